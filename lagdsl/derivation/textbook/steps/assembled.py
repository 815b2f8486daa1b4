"""Rows of the equations of motion where places and angles are linear in the coordinates, as in finite elements with
absolute coordinates: a mass matrix without coordinates, and the gradients of potentials and dissipations.

The definitions of the model keep their names: the chain rule goes through them, so a row stays short.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field, replace
from fractions import Fraction
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.expression_text import flat_expression_text, number_text

_LONGEST = 1500  # characters of a part of a row that is printed
_NOTHING = 1e-12  # of a sum of numbers that cancel each other
_LARGEST_DENOMINATOR = 1000

_Rule: TypeAlias = "Callable[[fx.FlatExpression], list[_Term]]"


@record(kw_only=True)
class AssembledRow:
    """`left` is the force of the loads and constraints along one coordinate: inertia, the gradients of potentials, with
    that of the weight, and those of dissipations by the rate."""

    coordinate: str
    left: str


@record()
class _Term:
    """A product: number, factors above and below the line, as texts."""

    number: float
    above: tuple[str, ...] = field(default=())
    below: tuple[str, ...] = field(default=())


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
        self._partials: dict[tuple[str, str], list[_Term]] = {}
        self._along: dict[str, list[_Term]] = {name: [] for name in self._coordinates}
        self._weights: dict[str, list[_Term]] = {name: [] for name in self._coordinates}
        gravity = [[], [], []] if flat.gravity is None else self._components(flat.gravity)
        for mass in flat.masses:
            position = mass.position
            if not isinstance(position, fx.Vector):
                raise _NotWritten
            self._add(self._terms(mass.mass), (position.x, position.y, position.z), gravity)
        for body in flat.bodies:
            self._add_body(body, gravity)

    def of(self, name: str) -> AssembledRow:
        energies = [(term.kind, term.value) for term in self._flat.energies if name in self._dependence.of(term.value)]
        stiffness = [each for kind, value in energies if kind == "potential" for each in self._partial(value, name)]
        damping = [each for kind, value in energies if kind == "dissipation" for each in self._by_rate(value, name)]
        return AssembledRow(
            coordinate=name, left=_text([*self._along[name], *stiffness, *self._weights[name], *damping])
        )

    # ---- masses ------------------------------------------------------------------------------------------------------

    def _add_body(self, body: fm.RigidBody, gravity: list[list[_Term]]) -> None:
        frame = self._named.get(body.frame)
        if not isinstance(frame, fm.Frame) or any(each != fx.ZERO for each in body.com):
            raise _NotWritten
        self._require_world(frame.parent)
        moves = [step for step in frame.steps if isinstance(step, fm.Move)]
        turns = [step for step in frame.steps if isinstance(step, fm.Rotate)]
        if frame.steps not in ((*moves,), (*moves, *turns)) or len(moves) != 1 or len(turns) > 1:
            raise _NotWritten
        self._add(self._terms(body.mass), moves[0].offset, gravity)
        for turn in turns:
            self._add(self._terms(body.inertia[turn.axis]), (turn.angle,), [[]])

    def _require_world(self, name: str) -> None:
        """The frame stands in the world without turn and displacement, by whatever name."""
        frame = self._named.get(name)
        if name != "world" and not (isinstance(frame, fm.Frame) and not frame.steps):
            raise _NotWritten
        if isinstance(frame, fm.Frame):
            self._require_world(frame.parent)

    def _add(self, mass: list[_Term], places: tuple[fx.FlatExpression, ...], gravity: list[list[_Term]]) -> None:
        """A mass, or a moment of inertia, whose place is linear in coordinates."""
        for place, pull in zip(places, gravity, strict=True):
            names = list(self._dependence.of(place))
            if not self._coordinates.issuperset(names):
                raise _NotWritten
            shares = {name: self._partial(place, name) for name in names}
            if any(part.above or part.below for share in shares.values() for part in share):
                raise _NotWritten
            for name, share in shares.items():
                for other, factor in shares.items():
                    rate = [_Term(1.0, (f"der(der({other}))",))]
                    self._along[name] += _product(_product(mass, _product(share, factor)), rate)
                self._weights[name] += _product([_Term(-1.0)], _product(_product(mass, pull), share))

    def _components(self, vector: fx.FlatExpression) -> list[list[_Term]]:
        if isinstance(vector, fx.Vector):
            return [self._terms(each) for each in (vector.x, vector.y, vector.z)]
        if isinstance(vector, fx.Binary) and vector.operator == "*" and isinstance(vector.right, fx.Vector):
            return [_product(self._terms(vector.left), each) for each in self._components(vector.right)]
        raise _NotWritten

    # ---- products and derivatives ------------------------------------------------------------------------------------

    def _terms(self, expression: fx.FlatExpression) -> list[_Term]:
        """The expression as one product; none for zero."""
        if isinstance(expression, fx.Number):
            return [_Term(expression.value)] if expression.value else []
        if isinstance(expression, fx.Unary) and expression.operator == "-":
            return _product([_Term(-1.0)], self._terms(expression.operand))
        if isinstance(expression, fx.Binary) and expression.operator in ("*", "/"):
            left, right = self._terms(expression.left), self._terms(expression.right)
            return _product(left, right) if expression.operator == "*" else _quotient(left, right)
        return [_Term(1.0, (_factor(expression),))]

    def _partial(self, expression: fx.FlatExpression, name: str) -> list[_Term]:
        """The derivative by a coordinate."""
        if isinstance(expression, fx.Variable):
            return self._partial_of_name(expression.name, name)
        if name not in self._dependence.of(expression):
            return []
        if isinstance(expression, fx.Derivative):
            raise _NotWritten
        return self._chain(expression, lambda each: self._partial(each, name))

    def _partial_of_name(self, variable: str, name: str) -> list[_Term]:
        item = self._named.get(variable)
        if not isinstance(item, fm.Definition):
            return [_Term(1.0)] if variable == name else []
        if (variable, name) not in self._partials:
            self._partials[variable, name] = self._partial(item.value, name)
        return self._partials[variable, name]

    def _by_rate(self, expression: fx.FlatExpression, name: str) -> list[_Term]:
        """The derivative by the rate of a coordinate."""
        if isinstance(expression, fx.Variable):
            item = self._named.get(expression.name)
            return self._by_rate(item.value, name) if isinstance(item, fm.Definition) else []
        if isinstance(expression, fx.Derivative):
            return self._partial(expression.operand, name)
        if name not in self._dependence.of(expression):
            return []
        return self._chain(expression, lambda each: self._by_rate(each, name))

    def _chain(self, expression: fx.FlatExpression, of: _Rule) -> list[_Term]:
        if isinstance(expression, fx.Unary) and expression.operator == "-":
            return _product([_Term(-1.0)], of(expression.operand))
        if isinstance(expression, fx.Binary):
            return self._chain_of_two(expression, of)
        if isinstance(expression, fx.Function) and expression.name in ("sin", "cos"):
            other, sign = ("cos", 1.0) if expression.name == "sin" else ("sin", -1.0)
            slope = self._terms(fx.Function(other, expression.arguments))
            return _product([_Term(sign)], _product(slope, of(expression.arguments[0])))
        raise _NotWritten

    def _chain_of_two(self, expression: fx.Binary, of: _Rule) -> list[_Term]:
        left, right, operator = expression.left, expression.right, expression.operator
        if operator in ("+", "-"):
            return [*of(left), *_product([_Term(1.0 if operator == "+" else -1.0)], of(right))]
        if operator == "*":
            return [*_product(self._terms(left), of(right)), *_product(self._terms(right), of(left))]
        if operator == "/" and not of(right):
            return _quotient(of(left), self._terms(right))
        if operator == "^" and isinstance(right, fx.Number):
            lower = self._terms(left if right.value == 2.0 else fx.Binary("^", left, fx.Number(right.value - 1.0)))
            return _product(_product([_Term(right.value)], lower), _bracketed(of(left)))
        raise _NotWritten


def _product(left: Iterable[_Term], right: list[_Term]) -> list[_Term]:
    return [
        _cancelled(_Term(a.number * b.number, (*a.above, *b.above), (*a.below, *b.below))) for a in left for b in right
    ]


def _quotient(left: list[_Term], right: list[_Term]) -> list[_Term]:
    return [_over(above, below) for above in left for below in right]


def _over(above: _Term, below: _Term) -> _Term:
    return _cancelled(_Term(above.number / below.number, (*above.above, *below.below), (*above.below, *below.above)))


def _cancelled(term: _Term) -> _Term:
    """Without the factors that stand above and below."""
    above, below = list(term.above), []
    for factor in term.below:
        if factor in above:
            above.remove(factor)
        else:
            below.append(factor)
    return replace(term, above=tuple(above), below=tuple(below))


def _factor(expression: fx.FlatExpression) -> str:
    text = flat_expression_text(expression)
    return f"({text})" if isinstance(expression, fx.Binary) and expression.operator in ("+", "-") else text


def _bracketed(terms: list[_Term]) -> list[_Term]:
    """A sum as one factor, without what all its terms have."""
    sums = _together(terms)
    if len(sums) < 2:
        return sums
    sizes, below = {abs(each.number) for each in sums}, {each.below for each in sums}
    number, line = sizes.pop() if len(sizes) == 1 else 1.0, below.pop() if len(below) == 1 else ()
    inner = [_Term(each.number / number, each.above, () if line else each.below) for each in sums]
    return [_Term(number, (f"({_text(inner)})",), line)]


def _together(terms: list[_Term]) -> list[_Term]:
    """Like terms as one, without those that cancel each other."""
    sums: dict[tuple[tuple[str, ...], tuple[str, ...]], list[_Term]] = {}
    for term in terms:
        sums.setdefault((tuple(sorted(term.above)), tuple(sorted(term.below))), []).append(term)
    found = [(likes, sum(each.number for each in likes)) for likes in sums.values()]
    return [
        replace(likes[0], number=number)
        for likes, number in found
        if abs(number) > _NOTHING * max(abs(each.number) for each in likes)
    ]


def _text(terms: list[_Term]) -> str:
    text = ""
    for term in _together(terms):
        shown = _shown(replace(term, number=abs(term.number)))
        text += f"{' - ' if term.number < 0 else ' + '}{shown}" if text else f"{'-' * (term.number < 0)}{shown}"
    if len(text) > _LONGEST:
        raise _NotWritten
    return text or "0"


def _shown(term: _Term) -> str:
    exact = Fraction(term.number).limit_denominator(_LARGEST_DENOMINATOR)
    simple = abs(float(exact) - term.number) <= _NOTHING * abs(term.number)
    above = [str(exact.numerator)] if simple and exact.numerator != 1 else [] if simple else [number_text(term.number)]
    below = [str(exact.denominator)] if simple and exact.denominator != 1 else []
    above += term.above
    below += term.below
    line = "*".join(above) or "1"
    return line if not below else f"{line}/{below[0]}" if len(below) == 1 else f"{line}/({'*'.join(below)})"
