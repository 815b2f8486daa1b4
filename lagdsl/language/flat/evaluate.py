"""Numbers for flat expressions: a plain interpreter, for checks that must try values before anything is derived.

It works in complex numbers, so that time derivatives come exactly from one complex step (W. Squire and G. Trapp, SIAM
Review 40 (1998) 110): der(e) = Im e(q + i h qd, t + i h) / h with h = 1e-30.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from dataclasses import field
from functools import cached_property, partial
from typing import TypeAlias, assert_never

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.events import Discrete, Relation, Timed, entries
from lagdsl.language.flat.rotation import quaternion_rotation, rotation, rotation_about
from lagdsl.language.flat.traversal import postorder

Complexes: TypeAlias = NDArray[np.complex128]
_Value: TypeAlias = "complex | Complexes"

_STEP = 1e-30
_NAN = complex(math.nan)


class NotEvaluable(Exception):  # noqa: N818 named after what it says
    """The expression needs what the mechanics provides, or a derivative that is not known here."""


@record(kw_only=True)
class Values:
    """Numbers of a moment: of coordinates, states, inputs and `time`, their rates, second derivatives of coordinates.

    Parameters may be given too; left out they have their defaults. Every other missing value is 0; the rate of `time`
    is 1.
    """

    variables: Mapping[str, float] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    accelerations: Mapping[str, float] = field(default_factory=dict)


def evaluate(flat: fm.FlatModel, expression: fx.FlatExpression, values: Values) -> float:
    """A scalar's value in SI units; nan outside the domain of a function. Raises NotEvaluable."""
    return Evaluator(flat, values).scalar(expression)


class Evaluator:
    """Evaluates many expressions at one moment; points, frames and definitions are computed once."""

    def __init__(self, flat: fm.FlatModel, values: Values) -> None:
        self._flat, self._values = flat, values

    @cached_property
    def _instant(self) -> _Instant:
        """Made for the first expression: often there is none."""
        flat, values = self._flat, self._values
        named, variables = _of(flat)
        variables = {**variables, **values.variables}
        rates: dict[str, complex] = {c.name: 0j for c in flat.coordinates}
        rates.update({"time": 1.0, **values.rates})
        accelerations = {c.name: complex(values.accelerations.get(c.name, 0.0)) for c in flat.coordinates}
        return _Instant(flat, named, variables, rates, accelerations)

    def scalar(self, expression: fx.FlatExpression) -> float:
        with np.errstate(all="ignore"):
            return self._instant.scalar(expression).real

    def vector(self, expression: fx.FlatExpression) -> NDArray[np.float64]:
        """World components, shape (3,)."""
        with np.errstate(all="ignore"):
            return np.asarray(self._instant.vector(expression).real)

    def frame(self, name: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Origin (3,) and axes as columns (3, 3) of a frame, in the world."""
        with np.errstate(all="ignore"):
            origin, axes = self._instant.frame(name)
        return np.asarray(origin.real), np.asarray(axes.real)


@remembered
def _of(flat: fm.FlatModel) -> tuple[dict[str, fm.Named], dict[str, complex]]:
    """Named items, and values of variables that are not given, by name."""
    variables: dict[str, complex] = {p.name: p.value for p in flat.parameters}
    variables.update({item.name: 0j for item in (*flat.coordinates, *flat.states, *flat.inputs)})
    return {item.name: item for item in flat.named}, {**variables, "time": 0j}


class _Instant:
    def __init__(
        self,
        flat: fm.FlatModel,
        named: dict[str, fm.Named],
        variables: dict[str, complex],
        rates: dict[str, complex],
        accelerations: dict[str, complex] | None,
    ) -> None:
        self.flat = flat
        self.named = named
        self.variables = variables
        self.rates = rates
        self.accelerations = accelerations
        self._nodes: dict[int, tuple[fx.FlatExpression, _Value]] = {}
        self._frames: dict[str, tuple[Complexes, Complexes]] = {
            "world": (np.zeros(3, np.complex128), np.eye(3, dtype=np.complex128))
        }
        self._later: _Instant | None = None
        self._waiting: dict[str, Callable[[], complex]] = {}

    # ---- expressions -------------------------------------------------------------------------------------------------

    def scalar(self, expression: fx.FlatExpression) -> complex:
        value = self._value(expression)
        assert isinstance(value, complex | float | int), "a scalar is expected"
        return complex(value)

    def vector(self, expression: fx.FlatExpression) -> Complexes:
        value = self._value(expression)
        assert isinstance(value, np.ndarray), "a vector is expected"
        return value

    def _value(self, expression: fx.FlatExpression) -> _Value:
        known = self._nodes
        if id(expression) not in known:
            for node in postorder(expression, known):
                # The node is kept with its value, so that its identity is not given to another one.
                known[id(node)] = (node, self._compute(node))
        return known[id(expression)][1]

    def _compute(self, expression: fx.FlatExpression) -> _Value:  # noqa: C901, PLR0912 one case per node
        match expression:
            case fx.Number(value):
                return complex(value)
            case fx.Variable(name):
                return self._variable(name)
            case fx.Derivative(operand):
                return self._derivative(operand)
            case fx.Unary(operator, operand):
                inner = self._value(operand)
                return -inner if operator == "-" else _truth(not _holds(inner))
            case fx.Binary():
                return self._binary(expression)
            case fx.Function(name, arguments):
                return _apply(name, [self.scalar(argument) for argument in arguments])
            case fx.Conditional(condition, then, otherwise):
                return self._value(then if _holds(self._value(condition)) else otherwise)
            case fx.Component(vector, axis):
                return complex(self.vector(vector)[axis])
            case fx.Dot(left, right):
                return complex(self.vector(left) @ self.vector(right))
            case fx.Norm(vector):
                components = self.vector(vector)
                return cmath.sqrt(complex(components @ components))
            case fx.Vector(x, y, z):
                return np.array([self.scalar(x), self.scalar(y), self.scalar(z)])
            case fx.Cross(left, right):
                return np.cross(self.vector(left), self.vector(right))
            case fx.PointReference(name):
                point = self.named[name]
                assert isinstance(point, fm.Point)
                return self.vector(point.position)
            case fx.FrameOrigin(frame):
                return self.frame(frame)[0]
            case fx.FrameAxis(frame, axis):
                return self.frame(frame)[1][:, axis]
            case fx.AngularVelocity(frame):
                return self._angular_velocity(frame)
            case fx.MaterialVelocity(point_expression, frame):
                arm = self.vector(point_expression) - self.frame(frame)[0]
                origin_velocity = self._rate(lambda moment: moment.frame(frame)[0])
                return origin_velocity + np.cross(self._angular_velocity(frame), arm)
            case fx.Previous() | fx.Mechanical() | fx.OfMechanism():
                raise NotEvaluable(type(expression).__name__)
            case _:
                assert_never(expression)

    def _variable(self, name: str) -> complex:
        item = self.named.get(name)
        if isinstance(item, fm.Definition):
            return self.scalar(item.value)
        if name in self._waiting:
            self.variables[name] = self._waiting.pop(name)()
        if name in self.variables:
            return complex(self.variables[name])
        return self._discrete(name)

    def _discrete(self, name: str) -> complex:
        """Relations as they stand, variables at their starts, contacts open, slips free and without a sense, no clock
        ticking."""
        for entry in entries(self.flat.events):
            if entry.name == name:
                item = entry.item
                if isinstance(item, Relation):
                    value = self.scalar(item.difference).real
                    return _truth(value > 0.0 or (value == 0.0 and not item.strict))
                if isinstance(item, Timed):
                    return self.scalar(item.value)
                return self.scalar(item.start) if isinstance(item, Discrete) else 0j
        raise NotEvaluable(name)

    def _binary(self, expression: fx.Binary) -> _Value:
        left, right = self._value(expression.left), self._value(expression.right)
        operator = expression.operator
        match operator:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
            case "/":
                return left / right if right != 0 else left * _NAN
            case "^" | "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                assert isinstance(left, complex) and isinstance(right, complex)
                return _power(left, right) if operator == "^" else _truth(_RELATIONS[operator](left.real, right.real))
            case _:
                assert_never(operator)

    # ---- frames ------------------------------------------------------------------------------------------------------

    def frame(self, name: str) -> tuple[Complexes, Complexes]:
        """Origin (3,) and axes as columns (3, 3) of a frame, in the world."""
        if name not in self._frames:
            item = self.named[name]
            assert isinstance(item, fm.Frame)
            origin, axes = self.frame(item.parent)
            for step in item.steps:
                origin, axes = self._step(step, origin, axes)
            self._frames[name] = origin, axes
        return self._frames[name]

    def _step(self, step: fm.FrameStep, origin: Complexes, axes: Complexes) -> tuple[Complexes, Complexes]:
        match step:
            case fm.Rotate(axis, angle):
                return origin, axes @ rotation(axis, self.scalar(angle))
            case fm.RotateAbout(axis, angle):
                return origin, axes @ rotation_about(self._scalars(axis), self.scalar(angle))
            case fm.RotateQuaternion(e):
                return origin, axes @ quaternion_rotation(self._scalars(e))
            case fm.SetAxes(x, y, z):
                return origin, np.stack([self.vector(x), self.vector(y), self.vector(z)], axis=1)
            case fm.Move(offset):
                return origin + axes @ self._scalars(offset), axes
            case fm.Place(position):
                return self.vector(position), axes

    def _scalars(self, expressions: tuple[fx.FlatExpression, ...]) -> Complexes:
        return np.array([self.scalar(expression) for expression in expressions])

    # ---- time derivatives --------------------------------------------------------------------------------------------

    def _derivative(self, operand: fx.FlatExpression) -> _Value:
        if isinstance(operand, fx.Variable) and operand.name in self.rates:
            return complex(self.rates[operand.name])
        if isinstance(operand, fx.Derivative) and isinstance(operand.operand, fx.Variable):
            name = operand.operand.name
            if self.accelerations is not None and name in self.accelerations:
                return self.accelerations[name]
        return self._rate(lambda moment: moment._value(operand))

    def _rate(self, quantity: Callable[[_Instant], _Value]) -> _Value:
        later = quantity(self._shifted())
        return complex(later.imag / _STEP) if isinstance(later, complex) else np.asarray(later.imag / _STEP + 0j)

    def _angular_velocity(self, frame: str) -> Complexes:
        """omega from the skew matrix Rdot R'."""
        axes = self.frame(frame)[1]
        turning = np.asarray(self._rate(lambda moment: moment.frame(frame)[1])) @ axes.T
        x, y, z = turning[2, 1] - turning[1, 2], turning[0, 2] - turning[2, 0], turning[1, 0] - turning[0, 1]
        return np.array([x, y, z], dtype=np.complex128) / 2

    def _shifted(self) -> _Instant:
        """The moment an imaginary step later. Complex steps do not nest: a step of a step is refused."""
        if self.accelerations is None:
            raise NotEvaluable("a derivative of a derivative")
        if self._later is None:
            rates = {**self.rates}
            rates.update({i.derivative_of: self.variables[i.name] for i in self.flat.inputs if i.derivative_of})
            variables = {name: value + 1j * _STEP * rates.get(name, 0.0) for name, value in self.variables.items()}
            later = {name: rate + 1j * _STEP * self.accelerations.get(name, 0.0) for name, rate in self.rates.items()}
            self._later = _Instant(self.flat, self.named, variables, later, None)
            moving = (state for state in self.flat.states if state.name in variables and state.name not in rates)
            self._later._waiting = {state.name: partial(self._state_later, state) for state in moving}
        return self._later

    def _state_later(self, state: fm.State) -> complex:
        """Asked for where it is read only: equations of states may read rates of other quantities."""
        return self.variables[state.name] + 1j * _STEP * self.scalar(state.derivative)


# ---- functions of complex numbers next to the real line --------------------------------------------------------------

_RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    "and": lambda a, b: bool(a) and bool(b),
    "or": lambda a, b: bool(a) or bool(b),
}


def _truth(value: bool) -> complex:
    return 1 + 0j if value else 0j


def _holds(value: _Value) -> bool:
    assert isinstance(value, complex)
    return value.real != 0.0


def _power(base: complex, exponent: complex) -> complex:
    try:
        if exponent.imag == 0.0 and exponent.real == int(exponent.real) and abs(exponent.real) <= 1024:
            return base ** int(exponent.real)
        return base**exponent if base.real >= 0.0 else _NAN
    except (ArithmeticError, ValueError):
        return _NAN


def _apply(name: str, arguments: list[complex]) -> complex:
    try:
        return complex(_FUNCTIONS[name](*arguments))
    except (ArithmeticError, ValueError):
        return _NAN


def _atan2(y: complex, x: complex) -> complex:
    squared = x.real**2 + y.real**2
    return complex(math.atan2(y.real, x.real), (x.real * y.imag - y.real * x.imag) / squared if squared else 0.0)


def _on(low: float, high: float, function: Callable[[complex], complex]) -> Callable[[complex], complex]:
    """The function where its real domain is, nan elsewhere: cmath would continue it into the complex plane."""
    return lambda x: function(x) if low <= x.real <= high else _NAN


def _mod(x: complex, y: complex) -> complex:
    return x - y * math.floor(x.real / y.real)


_FUNCTIONS: dict[str, Callable[..., complex]] = {
    "sin": cmath.sin,
    "cos": cmath.cos,
    "tan": cmath.tan,
    "asin": _on(-1.0, 1.0, cmath.asin),
    "acos": _on(-1.0, 1.0, cmath.acos),
    "atan": cmath.atan,
    "atan2": _atan2,
    "sinh": cmath.sinh,
    "cosh": cmath.cosh,
    "tanh": cmath.tanh,
    "exp": cmath.exp,
    "log": _on(0.0, math.inf, cmath.log),
    "sqrt": _on(0.0, math.inf, cmath.sqrt),
    "abs": lambda x: -x if x.real < 0.0 else x,
    "sign": lambda x: complex((x.real > 0.0) - (x.real < 0.0)),
    "floor": lambda x: complex(math.floor(x.real)),
    "ceil": lambda x: complex(math.ceil(x.real)),
    "mod": _mod,
    "min": lambda x, y: x if x.real <= y.real else y,
    "max": lambda x, y: x if x.real >= y.real else y,
}
