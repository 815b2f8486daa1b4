"""Rows of the equations of motion where places and angles are linear in the coordinates, as in finite elements with
absolute coordinates: a mass matrix without coordinates, and the gradients of potentials and dissipations.

The definitions of the model keep their names: the chain rule goes through them, so a row stays short. It stops at a
definition that is a root or a quotient of coordinates, as the strain of a cable: d(strain)/d(r) is such a derivative,
and a row is the virtual work of the textbooks, the sum of forces times variations of strains.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import add, mul, sub, truediv
from typing import TypeAlias

from lagdsl.derivation.textbook.steps.products import Term, bracketed, partial_of, product, quotient, text_of
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.traversal import step_expressions

_LONGEST = 2500  # characters of a row that is printed
_OF_NUMBERS: dict[str, Callable[[float, float], float]] = {"+": add, "-": sub, "*": mul, "/": truediv, "^": pow}

_Rule: TypeAlias = "Callable[[fx.FlatExpression], list[Term]]"


@record(kw_only=True)
class AssembledRow:
    """`left` is the force of the loads and constraints along one coordinate: inertia, the gradients of potentials, with
    that of the weight, and those of dissipations by the rate."""

    coordinate: str
    left: str


class _NotWritten(Exception):  # noqa: N818 named after what it says
    """The row has another form."""


def assembled_rows(flat: fm.FlatModel) -> list[AssembledRow]:
    """The rows of all coordinates; none where one of them has another form."""
    try:
        rows = _Rows(flat)
        return [rows.of(coordinate.name) for coordinate in flat.coordinates]
    except _NotWritten:
        return []


class _Rows:
    def __init__(self, flat: fm.FlatModel) -> None:
        if any(term.kind in ("kinetic", "lagrangian") for term in flat.energies):
            raise _NotWritten
        self._flat, self._dependence = flat, Dependence(flat)
        self._named = {item.name: item for item in flat.named}
        self._coordinates = {coordinate.name for coordinate in flat.coordinates}
        self._parameters = {parameter.name for parameter in flat.parameters}
        self._partials: dict[tuple[str, str], list[Term]] = {}
        self._along: dict[str, list[Term]] = {name: [] for name in self._coordinates}
        self._weights: dict[str, list[Term]] = {name: [] for name in self._coordinates}
        gravity = [[], [], []] if flat.gravity is None else self._components(flat.gravity)
        self._pulls = {"world": gravity}
        for mass in flat.masses:
            frame, place = _placed(mass.position)
            self._add(self._terms(mass.mass), place, self._pull(frame))
        for body in flat.bodies:
            self._add_body(body)

    def of(self, name: str) -> AssembledRow:
        energies = [(term.kind, term.value) for term in self._flat.energies if name in self._dependence.of(term.value)]
        stiffness = [each for kind, value in energies if kind == "potential" for each in self._partial(value, name)]
        damping = [each for kind, value in energies if kind == "dissipation" for each in self._by_rate(value, name)]
        left = text_of([*self._along[name], *stiffness, *self._weights[name], *damping])
        if len(left) > _LONGEST:
            raise _NotWritten
        return AssembledRow(coordinate=name, left=left)

    # ---- masses ------------------------------------------------------------------------------------------------------

    def _add_body(self, body: fm.RigidBody) -> None:
        frame = self._named.get(body.frame)
        if not isinstance(frame, fm.Frame) or any(each != fx.ZERO for each in body.com):
            raise _NotWritten
        pull = self._pull(frame.parent)
        moves = [step for step in frame.steps if isinstance(step, fm.Move)]
        turns = [step for step in frame.steps if isinstance(step, fm.Rotate)]
        if frame.steps not in ((*moves,), (*moves, *turns)) or len(moves) != 1 or len(turns) > 1:
            raise _NotWritten
        self._add(self._terms(body.mass), moves[0].offset, pull)
        for turn in turns:
            self._add(self._terms(body.inertia[turn.axis]), (turn.angle,), [[]])

    def _pull(self, name: str) -> list[list[Term]]:
        """Gravity in the axes of a frame that does not move."""
        if name not in self._pulls:
            frame = self._named.get(name)
            if not isinstance(frame, fm.Frame):
                raise _NotWritten
            pull = self._pull(frame.parent)
            for step in frame.steps:
                if not isinstance(step, fm.Move | fm.Rotate):
                    raise _NotWritten
                if not all(map(self._fixed, step_expressions(step))):
                    raise _NotWritten
                if isinstance(step, fm.Rotate):
                    pull = self._turned(pull, step)
            self._pulls[name] = pull
        return self._pulls[name]

    def _turned(self, pull: list[list[Term]], turn: fm.Rotate) -> list[list[Term]]:
        cos, sin = (self._terms(fx.Function(name, (turn.angle,))) for name in ("cos", "sin"))
        first, second = (turn.axis + 1) % 3, (turn.axis + 2) % 3
        turned = list(pull)
        turned[first] = [*product(cos, pull[first]), *product(sin, pull[second])]
        turned[second] = [*product(cos, pull[second]), *product([Term(-1.0)], product(sin, pull[first]))]
        return turned

    def _add(self, mass: list[Term], places: tuple[fx.FlatExpression, ...], gravity: list[list[Term]]) -> None:
        """A mass, or a moment of inertia, whose place is linear in coordinates."""
        for place, pull in zip(places, gravity, strict=True):
            names = [name for name in self._dependence.of(place) if name not in self._parameters]
            if not self._coordinates.issuperset(names) or not self._linear(place):
                raise _NotWritten
            shares = {name: self._partial(place, name) for name in names}
            for name, share in shares.items():
                for other, factor in shares.items():
                    rate = [Term(1.0, (f"der(der({other}))",))]
                    self._along[name] += product(product(mass, product(share, factor)), rate)
                self._weights[name] += product([Term(-1.0)], product(product(mass, pull), share))

    def _fixed(self, expression: fx.FlatExpression) -> bool:
        return self._parameters.issuperset(self._dependence.of(expression))

    def _linear(self, expression: fx.FlatExpression) -> bool:
        """In the coordinates, with coefficients that do not change."""
        if self._fixed(expression):
            return True
        if isinstance(expression, fx.Variable):
            item = self._named.get(expression.name)
            return not isinstance(item, fm.Definition) or self._linear(item.value)
        if isinstance(expression, fx.Unary):
            return expression.operator == "-" and self._linear(expression.operand)
        if not isinstance(expression, fx.Binary) or expression.operator not in ("+", "-", "*", "/"):
            return False
        fixed = self._fixed(expression.right) or (expression.operator == "*" and self._fixed(expression.left))
        alone = expression.operator in ("+", "-") or fixed
        return alone and self._linear(expression.left) and self._linear(expression.right)

    def _components(self, vector: fx.FlatExpression) -> list[list[Term]]:
        if isinstance(vector, fx.Vector):
            return [self._terms(each) for each in (vector.x, vector.y, vector.z)]
        if isinstance(vector, fx.Binary) and vector.operator == "*" and isinstance(vector.right, fx.Vector):
            return [product(self._terms(vector.left), each) for each in self._components(vector.right)]
        raise _NotWritten

    # ---- products and derivatives ------------------------------------------------------------------------------------

    def _terms(self, expression: fx.FlatExpression) -> list[Term]:
        """The expression as one product; none for zero."""
        number = _number(expression)
        if number is not None:
            return [Term(number)] if number else []
        if isinstance(expression, fx.Unary) and expression.operator == "-":
            return product([Term(-1.0)], self._terms(expression.operand))
        if isinstance(expression, fx.Binary) and expression.operator in ("*", "/"):
            left, right = self._terms(expression.left), self._terms(expression.right)
            return product(left, right) if expression.operator == "*" else quotient(left, right)
        return [Term(1.0, (_factor(expression),))]

    def _partial(self, expression: fx.FlatExpression, name: str) -> list[Term]:
        """The derivative by a coordinate."""
        if isinstance(expression, fx.Variable):
            return self._partial_of_name(expression.name, name)
        if name not in self._dependence.of(expression):
            return []
        if isinstance(expression, fx.Derivative):
            raise _NotWritten
        return self._chain(expression, lambda each: self._partial(each, name))

    def _partial_of_name(self, variable: str, name: str) -> list[Term]:
        item = self._named.get(variable)
        if not isinstance(item, fm.Definition):
            return [Term(1.0)] if variable == name else []
        if (variable, name) not in self._partials:
            try:
                found = self._partial(item.value, name)
            except _NotWritten:
                found = [] if self._vanishes(item.value) else [partial_of(variable, name)]
            self._partials[variable, name] = found
        return self._partials[variable, name]

    def _vanishes(self, expression: fx.FlatExpression) -> bool:
        """Zero by the form of the expression, as the curvature out of the plane of a cable that stays in it."""
        if isinstance(expression, fx.Number):
            return expression.value == 0.0
        if isinstance(expression, fx.Variable):
            item = self._named.get(expression.name)
            return isinstance(item, fm.Definition) and self._vanishes(item.value)
        if isinstance(expression, fx.Unary):
            return expression.operator == "-" and self._vanishes(expression.operand)
        if isinstance(expression, fx.Binary):
            left = self._vanishes(expression.left)
            if expression.operator in ("+", "-"):
                return left and self._vanishes(expression.right)
            return expression.operator in ("*", "/") and (
                left or (expression.operator == "*" and self._vanishes(expression.right))
            )
        return isinstance(expression, fx.Component) and self._vanishes_along(expression.vector, expression.axis)

    def _vanishes_along(self, vector: fx.FlatExpression, axis: int) -> bool:
        if isinstance(vector, fx.Vector):
            return self._vanishes((vector.x, vector.y, vector.z)[axis])
        if isinstance(vector, fx.Binary) and vector.operator in ("*", "/"):
            return any(self._vanishes_along(each, axis) for each in (vector.left, vector.right))
        if isinstance(vector, fx.Cross):
            others = [other for other in range(3) if other != axis]
            return all(
                self._vanishes_along(vector.left, a) or self._vanishes_along(vector.right, b)
                for a, b in (others, others[::-1])
            )
        return False

    def _by_rate(self, expression: fx.FlatExpression, name: str) -> list[Term]:
        """The derivative by the rate of a coordinate."""
        if isinstance(expression, fx.Variable):
            item = self._named.get(expression.name)
            return self._by_rate(item.value, name) if isinstance(item, fm.Definition) else []
        if isinstance(expression, fx.Derivative):
            return self._partial(expression.operand, name)
        if name not in self._dependence.of(expression):
            return []
        return self._chain(expression, lambda each: self._by_rate(each, name))

    def _chain(self, expression: fx.FlatExpression, of: _Rule) -> list[Term]:
        if isinstance(expression, fx.Unary) and expression.operator == "-":
            return product([Term(-1.0)], of(expression.operand))
        if isinstance(expression, fx.Binary):
            return self._chain_of_two(expression, of)
        if isinstance(expression, fx.Function) and expression.name in ("sin", "cos"):
            other, sign = ("cos", 1.0) if expression.name == "sin" else ("sin", -1.0)
            slope = self._terms(fx.Function(other, expression.arguments))
            return product([Term(sign)], product(slope, of(expression.arguments[0])))
        raise _NotWritten

    def _chain_of_two(self, expression: fx.Binary, of: _Rule) -> list[Term]:
        left, right, operator = expression.left, expression.right, expression.operator
        if operator in ("+", "-"):
            return [*of(left), *product([Term(1.0 if operator == "+" else -1.0)], of(right))]
        if operator == "*":
            return [*product(self._terms(left), of(right)), *product(self._terms(right), of(left))]
        if operator == "/" and not of(right):
            return quotient(of(left), self._terms(right))
        if operator == "^" and isinstance(right, fx.Number):
            lower = self._terms(left if right.value == 2.0 else fx.Binary("^", left, fx.Number(right.value - 1.0)))
            return product(product([Term(right.value)], lower), bracketed(of(left)))
        raise _NotWritten


def _placed(position: fx.FlatExpression) -> tuple[str, tuple[fx.FlatExpression, ...]]:
    """The frame and the components in its axes: of a vector of the world, and of a point of a frame."""
    if isinstance(position, fx.Vector):
        return "world", (position.x, position.y, position.z)
    if isinstance(position, fx.FrameOrigin):
        return position.frame, (fx.ZERO, fx.ZERO, fx.ZERO)
    if not isinstance(position, fx.Binary) or position.operator != "+" or not isinstance(position.right, fx.Binary):
        raise _NotWritten
    length, along = position.right.left, position.right.right
    frame, place = _placed(position.left)
    if not isinstance(along, fx.FrameAxis) or frame != along.frame or place[along.axis] != fx.ZERO:
        raise _NotWritten
    return frame, (*place[: along.axis], length, *place[along.axis + 1 :])


def _number(expression: fx.FlatExpression) -> float | None:
    """The value of what has no names."""
    if isinstance(expression, fx.Number):
        return expression.value
    if isinstance(expression, fx.Unary) and expression.operator == "-":
        value = _number(expression.operand)
        return None if value is None else -value
    if not isinstance(expression, fx.Binary):
        return None
    left, right = _number(expression.left), _number(expression.right)
    of = _OF_NUMBERS.get(expression.operator)
    return None if left is None or right is None or of is None else of(left, right)


def _factor(expression: fx.FlatExpression) -> str:
    text = flat_expression_text(expression)
    return f"({text})" if isinstance(expression, fx.Binary) and expression.operator in ("+", "-") else text
