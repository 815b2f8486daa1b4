"""Flat expressions as SymPy expressions: one rule per node, nothing simplified, no text ever parsed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias, assert_never

import sympy
from sympy import Expr, Float, Integer, Rational, Symbol

from lagdsl.derivation.textbook import functions, geometry
from lagdsl.derivation.textbook.differentiate import along
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.kinematics import RELEASE, RELEASE_RATE, Kinematics, Release
from lagdsl.derivation.textbook.symbols import Symbols, occurring, rates_of_motion
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.model import Definition, FlatModel, Frame, Point

Mechanical: TypeAlias = (
    flat.Multiplier
    | flat.FrameReaction
    | flat.ReactionAlong
    | flat.SystemEnergy
    | flat.GeneralizedMomentum
    | flat.ForceBalance
    | flat.LinearMomentum
    | flat.AngularMomentum
    | flat.AdmissibleMotion
    | flat.RequiredForce
)
_Geometric: TypeAlias = (
    flat.Vector
    | flat.Cross
    | flat.PointReference
    | flat.FrameOrigin
    | flat.FrameAxis
    | flat.AngularVelocity
    | flat.MaterialVelocity
)

_FUNCTIONS: dict[str, Callable[..., Expr]] = {
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "asin": sympy.asin,
    "acos": sympy.acos,
    "atan": sympy.atan,
    "atan2": functions.ArcTangent2,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "exp": sympy.exp,
    "log": sympy.log,
    "sqrt": sympy.sqrt,
    "abs": functions.Absolute,
    "sign": functions.Sign,
    "floor": functions.Floor,
    "ceil": functions.Ceil,
    "mod": functions.Modulo,
    "min": functions.Minimum,
    "max": functions.Maximum,
}

_RELATIONS: dict[str, Callable[[Expr, Expr], Expr]] = {
    "<": functions.Less,
    "<=": functions.LessEqual,
    ">": lambda x, y: functions.Less(y, x),
    ">=": lambda x, y: functions.LessEqual(y, x),
    "==": functions.Equal,
    "<>": lambda x, y: functions.Not(functions.Equal(x, y)),
    "and": functions.And,
    "or": functions.Or,
}

_LARGEST_EXACT_INTEGER = 2**53


def plain_number(value: float) -> Expr:
    """Exactly the value: whole numbers and halves, quarters, eighths as rationals, all others as 53-bit floats."""
    if not -_LARGEST_EXACT_INTEGER < value < _LARGEST_EXACT_INTEGER:
        return sympy.oo if value == float("inf") else -sympy.oo if value == -float("inf") else Float(value)
    fraction = Fraction(value)
    if fraction.denominator <= 8:
        return Rational(fraction.numerator, fraction.denominator)
    return Float(value)


def as_it_is(expression: Expr) -> Expr:
    return expression


class NoDerivativeError(ValueError):
    """An input's derivative is asked for and the model does not provide it; the checker refuses such models before."""


class NotDerivedYetError(Exception):
    """A multiplier, reaction or energy is read before the derivation has it; such a definition is made later."""


@record(kw_only=True)
class Style:
    """Notation of expressions: `opaque` names definitions that stay symbols; `settle` makes choices between numbers.
    `held` has symbols for rates of states, in the place of their equations."""

    number: Callable[[float], Expr] = plain_number
    tidy: Callable[[Expr], Expr] = as_it_is
    settle: Callable[[Expr], Expr] = as_it_is
    opaque: Mapping[str, Symbol] = field(default_factory=dict)
    held: Mapping[Symbol, Symbol] = field(default_factory=dict)


@dataclass
class Converter:
    """Converts expressions of one flat model.

    `mechanical` evaluates for the converter that asks what only the derivation knows, and is set by it: first forces
    that motions require, then multipliers, reactions, energies.
    """

    model: FlatModel
    symbols: Symbols
    release: Release | None = None
    style: Style = field(default_factory=Style)
    mechanical: Callable[[Mechanical | flat.Component, Converter], Expr | Vector] | None = None
    rates: dict[Symbol, Expr] = field(init=False)
    kinematics: Kinematics = field(init=False)
    _values: dict[str, Expr] = field(init=False)
    _items: dict[str, Definition | Point | Frame] = field(init=False)
    _memo: dict[int, tuple[object, Expr | Vector]] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        self.rates = rates_of_motion(self.model, self.symbols)
        if self.release is not None:
            self.rates[RELEASE] = RELEASE_RATE
        self.rates |= self.style.held
        self.kinematics = Kinematics(
            scalar=self.scalar, vector=self.vector, rate=self.rate, tidy=self.style.tidy, release=self.release
        )
        s = self.symbols
        known = (s.time, *s.q, *s.z, *s.u, *s.w, *s.p)
        self._values = {symbol.name: symbol for symbol in known}
        for parameter in self.model.parameters:
            if parameter.structural:
                self._values[parameter.name] = self.style.number(parameter.value)
        self._items = {item.name: item for item in self.model.named}
        for item in self.model.named:
            with suppress(NotDerivedYetError):
                self._define(item.name)

    def _define(self, name: str) -> None:
        """Make a definition, point or frame, once; order and need both lead here."""
        item = self._items.pop(name, None)
        try:
            self._make_item(name, item)
        except NotDerivedYetError:
            if item is not None:
                self._items[name] = item
            raise

    def _make_item(self, name: str, item: Definition | Point | Frame | None) -> None:
        match item:
            case Definition(value=value):
                self._values[name] = self.style.opaque[name] if name in self.style.opaque else self.scalar(value)
            case Point() as point:
                self.kinematics.place_point(point)
            case Frame() as frame:
                self.kinematics.place_frame(frame)
            case None:
                pass

    def known(self, name: str, value: Expr) -> None:
        """From here on the definition `name` is the value."""
        self._values[name] = value

    def rate(self, expression: Expr, *, bias: bool = False) -> Expr:
        """Total time derivative; that of a state is its equation. `bias`: its part without accelerations."""
        present = occurring(expression)
        for state, symbol in zip(self.model.states, self.symbols.z, strict=True):
            if symbol in present and symbol not in self.rates:
                self.rates[symbol] = self.scalar(state.derivative)
        missing = [u for u in self.symbols.u if u not in self.rates and u in present]
        if missing:
            raise NoDerivativeError(missing[0].name)
        rates = self.rates
        if bias:
            rates = {symbol: rate for symbol, rate in rates.items() if symbol not in self.symbols.qd}
        return self.style.tidy(along(expression, rates))

    # ---- scalars -----------------------------------------------------------------------------------------------------

    def scalar(self, node: flat.FlatExpression) -> Expr:
        value = self._convert(node)
        assert not isinstance(value, tuple), node
        return value

    def vector(self, node: flat.FlatExpression) -> Vector:
        value = self._convert(node)
        assert isinstance(value, tuple), node
        return value

    def _convert(self, node: flat.FlatExpression) -> Expr | Vector:
        """Memoised by identity; long sums and products, which lean to the left, are walked without recursion."""
        spine = []
        while isinstance(node, flat.Binary) and id(node) not in self._memo:
            spine.append(node)
            node = node.left
        value = self._memo[id(node)][1] if id(node) in self._memo else self._make(node)
        self._memo[id(node)] = (node, value)
        for binary in reversed(spine):
            value = self._binary(binary.operator, value, self._convert(binary.right))
            self._memo[id(binary)] = (binary, value)
        return value

    def _make(self, node: flat.FlatExpression) -> Expr | Vector:  # noqa: C901, PLR0912 one case for each node
        match node:
            case flat.Number(value):
                return self.style.number(value)
            case flat.Variable(name):
                self._define(name)
                return self._values[name]
            case flat.Derivative(operand):
                inner = self._convert(operand)
                return geometry.each(self.rate, inner) if isinstance(inner, tuple) else self.rate(inner)
            case flat.Unary(operator, operand):
                return self._unary(operator, self._convert(operand))
            case flat.Function(name, arguments):
                return self.style.settle(_FUNCTIONS[name](*(self.scalar(argument) for argument in arguments)))
            case flat.Conditional(condition, value, otherwise):
                return self._select(self.scalar(condition), self._convert(value), self._convert(otherwise))
            case flat.Component(flat.FrameReaction(), _) if self.mechanical is not None:
                return self.mechanical(node, self)
            case flat.Component(vector, axis):
                return self.vector(vector)[axis]
            case flat.Dot(left, right):
                return geometry.dot(self.vector(left), self.vector(right))
            case flat.Norm(vector, _):
                return self.style.tidy(geometry.norm(self.vector(vector)))
            case flat.Vector() | flat.Cross() | flat.PointReference() | flat.OfFrame():
                return self._make_vector(node)
            case flat.Mechanical() | flat.RequiredForce():
                if self.mechanical is None:
                    raise NotDerivedYetError(type(node).__name__)
                return self.mechanical(node, self)
            case flat.Binary() | flat.Previous() | flat.Motion():
                raise AssertionError(node)
            case _:
                assert_never(node)

    def _make_vector(self, node: _Geometric) -> Vector:
        kinematics = self.kinematics
        if isinstance(node, flat.OfFrame):
            self._define(node.frame)
        match node:
            case flat.Vector(x, y, z):
                return (self.scalar(x), self.scalar(y), self.scalar(z))
            case flat.PointReference(name):
                self._define(name)
                return kinematics.points[name]
            case flat.FrameOrigin(frame):
                return kinematics.poses[frame].origin
            case flat.FrameAxis(frame, axis):
                return kinematics.axis(frame, axis)
            case flat.AngularVelocity(frame):
                return kinematics.angular_velocity(frame)
            case flat.MaterialVelocity(point, frame):
                return kinematics.material_velocity(self.vector(point), frame)
            case flat.Cross(left, right):
                return geometry.cross(self.vector(left), self.vector(right))
            case _:
                assert_never(node)

    def _unary(self, operator: flat.UnaryOperator, value: Expr | Vector) -> Expr | Vector:
        if operator == "not":
            return self.style.settle(functions.Not(value))
        return geometry.scale(Integer(-1), value) if isinstance(value, tuple) else -value

    def _select(self, condition: Expr, value: Expr | Vector, otherwise: Expr | Vector) -> Expr | Vector:
        if isinstance(value, tuple):
            assert isinstance(otherwise, tuple)
            x, y, z = (self._choice(condition, a, b) for a, b in zip(value, otherwise, strict=True))
            return (x, y, z)
        return self._choice(condition, value, otherwise)

    def _choice(self, condition: Expr, value: Expr, otherwise: Expr) -> Expr:
        return self.style.settle(functions.Select(condition, value, otherwise))

    def _binary(self, operator: flat.BinaryOperator, left: Expr | Vector, right: Expr | Vector) -> Expr | Vector:
        if isinstance(right, tuple):
            return self._vector_binary(operator, left, right)
        if isinstance(left, tuple):
            assert operator == "/"
            return geometry.scale(1 / right, left)
        match operator:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
            case "/":
                return left / right
            case "^":
                return left**right
            case "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                return self.style.settle(_RELATIONS[operator](left, right))
            case _:
                assert_never(operator)

    def _vector_binary(self, operator: flat.BinaryOperator, left: Expr | Vector, right: Vector) -> Vector:
        if not isinstance(left, tuple):
            assert operator == "*"
            return geometry.scale(left, right)
        return geometry.add(left, right) if operator == "+" else geometry.subtract(left, right)
