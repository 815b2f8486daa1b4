"""Rows of the equations of motion where places and angles are linear in the coordinates, as in finite elements with
absolute coordinates: a mass matrix without coordinates, and the gradients of potentials and dissipations.

The definitions of the model keep their names: the chain rule goes through them, so a row stays short. It stops at a
definition that is a root or a quotient of coordinates, as the strain of a cable: d(strain)/d(r) is such a derivative
and a row is the virtual work of the textbooks, the sum of forces times variations of strains. Where that is the same
work for all elements, it is written once, as `Q(element, coordinate)`. A viscous stress stands with its elastic one
(Kelvin and Voigt). A row is the sum of the shares of the elements that its coordinate belongs to. Bodies that turn by
unit quaternions have the inertia of P. Betsch and R. Siebert, Int. J. Numer. Methods Eng. 79 (2009) 444.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Sequence
from operator import add, mul, sub, truediv
from typing import TypeAlias

from lagdsl.derivation.textbook.steps.elements import Elements, places_of, same_frame
from lagdsl.derivation.textbook.steps.products import (
    Term,
    bracketed,
    partial_of,
    product,
    quotient,
    shared,
    text_of,
    viscous,
)
from lagdsl.derivation.textbook.steps.stresses import Stress, with_stresses
from lagdsl.derivation.textbook.steps.works import Work, with_works
from lagdsl.derivation.textbook.steps.zeros import vanishes
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.traversal import step_expressions

_LONGEST = 2500  # characters of a row that is printed
_OF_NUMBERS: dict[str, Callable[[float, float], float]] = {"+": add, "-": sub, "*": mul, "/": truediv, "^": pow}

_Rule: TypeAlias = "Callable[[fx.FlatExpression], list[Term]]"
_Pull: TypeAlias = list[list[Term]]
_Inertia: TypeAlias = tuple[list[Term], list[Term]]  # inertia and weight
_Spins: TypeAlias = dict[tuple[int, tuple[str, ...]], list[list[Term]]]


@record(kw_only=True)
class AssembledRow:
    """`left` is the force of the loads and constraints along one coordinate: inertia, forces of strains, elastic and
    viscous, and the weight. `element` is the number of the element whose share it is; None for all of them."""

    coordinate: str
    element: int | None
    left: str


@record(kw_only=True)
class Assembled:
    """`works` are what `Q` stands for in the rows, `stresses` what `S` stands for; none if they have none."""

    rows: tuple[AssembledRow, ...]
    works: tuple[Work, ...]
    stresses: tuple[Stress, ...]


class _NotWritten(Exception):  # noqa: N818 named after what it says
    """The row has another form."""


def assembled(flat: fm.FlatModel) -> tuple[Assembled, ...]:
    """The rows of all coordinates in two forms, whole and by elements; none where one of them has another form."""
    try:
        rows = _Rows(flat)
        shares = {each.name: rows.of(each.name) for each in flat.coordinates}
    except _NotWritten:
        return ()
    whole = [(q, None, [term for terms in of.values() for term in terms]) for q, of in shares.items()]
    parts = [(q, element, terms) for q, of in shares.items() for element, terms in of.items()]
    return tuple(found for each in (whole, parts) if (found := _texts(each)) is not None)


def _texts(rows: Sequence[tuple[str, int | None, list[Term]]]) -> Assembled | None:
    works, left = with_works([(q, terms) for q, _, terms in rows])
    stresses, left = with_stresses(left)
    texts = [text_of(terms) for terms in left]
    if any(len(text) > _LONGEST for text in texts):
        return None
    found = (AssembledRow(coordinate=q, element=e, left=t) for (q, e, _), t in zip(rows, texts, strict=True))
    return Assembled(rows=tuple(found), works=works, stresses=stresses)


class _Rows:
    def __init__(self, flat: fm.FlatModel) -> None:
        if any(term.kind in ("kinetic", "lagrangian") for term in flat.energies):
            raise _NotWritten
        self._flat, self._dependence = flat, Dependence(flat)
        self._named = {item.name: item for item in flat.named}
        self._coordinates = {coordinate.name: place for place, coordinate in enumerate(flat.coordinates)}
        self._parameters = {parameter.name for parameter in flat.parameters}
        self._partials: dict[tuple[str, str], list[Term]] = {}
        self._elements = Elements(flat, self._dependence)
        self._of_masses: defaultdict[tuple[str, int], _Inertia] = defaultdict(lambda: ([], []))
        self._shapes: dict[str, bool] = {}
        named: _Pull = [[Term(1.0, (f"gravity[{axis}]",))] for axis in (1, 2, 3)]
        self._pulls = {"world": named if any(self._gravity()) else self._gravity()}
        for mass in flat.masses:
            frame, place = _placed(mass.position)
            self._add(self._elements.of([mass.position]), self._terms(mass.mass), place, self._pull(frame))
        spins: _Spins = {}
        for body in flat.bodies:
            self._add_body(body, spins)
        for (element, quaternion), inertia in spins.items():
            common, moments = shared(inertia)
            diagonal = f"{{{', '.join(map(_entry, moments))}}}"
            vector = quaternion[0].removesuffix("[1]") if quaternion[0].endswith("[1]") else f"{quaternion[0][:-3]}]"
            for axis, name in enumerate(quaternion, start=1):
                self._of_masses[name, element][0].extend(
                    product([common], [Term(1.0, (f"spin({vector}, {diagonal})[{axis}]",))])
                )

    def of(self, name: str) -> dict[int, list[Term]]:
        """The terms of each element of the coordinate."""
        keys = [(name, element) for element in self._elements.sharing(name)]
        return {key[1]: [*self._of_masses[key][0], *self._strained(*key), *self._of_masses[key][1]] for key in keys}

    def _strained(self, name: str, element: int) -> list[Term]:
        energies = [(term.kind, term.value) for term in self._elements.energies(name, element)]
        stiffness = [each for kind, value in energies if kind == "potential" for each in self._partial(value, name)]
        damping = [each for kind, value in energies if kind == "dissipation" for each in self._by_rate(value, name)]
        return viscous(stiffness, damping)

    # ---- masses ------------------------------------------------------------------------------------------------------

    def _add_body(self, body: fm.RigidBody, spins: _Spins) -> None:
        frame = same_frame(self._named, body.frame)
        if not isinstance(frame, fm.Frame) or any(each != fx.ZERO for each in body.com):
            raise _NotWritten
        pull = self._pull(frame.parent)
        moves = [step for step in frame.steps if isinstance(step, fm.Move)]
        turns = [step for step in frame.steps if isinstance(step, fm.Rotate | fm.RotateQuaternion)]
        if frame.steps not in ((*moves,), (*moves, *turns)) or len(moves) != 1 or len(turns) > 1:
            raise _NotWritten
        element = self._elements.of(places_of(frame))
        self._add(element, self._terms(body.mass), moves[0].offset, pull)
        for turn in turns:
            if isinstance(turn, fm.Rotate):
                self._add(element, self._terms(body.inertia[turn.axis]), (turn.angle,), [[]])
            else:
                self._add_spin(element, body, turn, spins)

    def _add_spin(self, element: int, body: fm.RigidBody, turn: fm.RotateQuaternion, spins: _Spins) -> None:
        """The inertia of a body in the axes of its moments, which turns by coordinates that are a unit quaternion."""
        parts = [self._resolved(each) for each in turn.e]
        if all(map(self._fixed, parts)):
            return
        names = tuple(part.name for part in parts if isinstance(part, fx.Variable))
        ends = [re.sub(r"(\d+)\]$", "#", name) + name[-2:-1] for name in names]
        if ends != [f"{ends[0][:-1]}{axis}" for axis in (1, 2, 3, 4)] or not self._coordinates.keys() >= set(names):
            raise _NotWritten
        if any(each != fx.ZERO for each in body.inertia[3:]):
            raise _NotWritten
        known = spins.setdefault((element, names), [[], [], []])
        spins[element, names] = [[*k, *self._terms(each)] for k, each in zip(known, body.inertia[:3], strict=True)]

    def _resolved(self, expression: fx.FlatExpression) -> fx.FlatExpression:
        """The value of a name that other names repeat."""
        while isinstance(expression, fx.Variable):
            item = self._named.get(expression.name)
            if not isinstance(item, fm.Definition):
                break
            expression = item.value
        return expression

    def _gravity(self) -> _Pull:
        return [[], [], []] if self._flat.gravity is None else self._components(self._flat.gravity)

    def _pull(self, name: str) -> _Pull:
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

    def _turned(self, pull: _Pull, turn: fm.Rotate) -> _Pull:
        cos, sin = (self._terms(fx.Function(name, (turn.angle,))) for name in ("cos", "sin"))
        first, second = (turn.axis + 1) % 3, (turn.axis + 2) % 3
        pull = self._gravity() if pull is self._pulls["world"] else pull
        turned = list(pull)
        turned[first] = [*product(cos, pull[first]), *product(sin, pull[second])]
        turned[second] = [*product(cos, pull[second]), *product([Term(-1.0)], product(sin, pull[first]))]
        return turned

    def _add(self, element: int, mass: list[Term], places: tuple[fx.FlatExpression, ...], gravity: _Pull) -> None:
        """A mass, or a moment of inertia, whose place is linear in coordinates and in definitions that are not."""
        for place, pull in zip(places, gravity, strict=True):
            shares = {of: [self._original(term) for term in share] for of, share in self._shares(place).items()}
            names = {
                name
                for of in shares
                for name in ([of] if of in self._coordinates else self._dependence.of(fx.Variable(of)))
            }
            for name in sorted(names & self._coordinates.keys(), key=self._coordinates.__getitem__):
                varied = [each for of, share in shares.items() for each in product(share, self._varied(of, name))]
                for of, share in shares.items():
                    rate = [Term(1.0, (f"der(der({of}))",))]
                    self._of_masses[name, element][0].extend(product(product(mass, product(share, varied)), rate))
                self._of_masses[name, element][1].extend(product([Term(-1.0)], product(product(mass, pull), varied)))

    def _shares(self, place: fx.FlatExpression) -> dict[str, list[Term]]:
        """The place as a sum: the factors of coordinates, and of definitions that are not linear in them."""
        if self._fixed(place):
            return {}
        if self._linear(place):
            names = [name for name in self._dependence.of(place) if name not in self._parameters]
            if not self._coordinates.keys() >= set(names):
                raise _NotWritten
            return {name: self._partial(place, name) for name in names}
        if isinstance(place, fx.Variable) and isinstance(self._named.get(place.name), fm.Definition):
            return {place.name: [Term(1.0)]}
        if not isinstance(place, fx.Binary) or place.operator not in ("+", "-"):
            raise _NotWritten
        found = self._shares(place.left)
        sign = Term(1.0 if place.operator == "+" else -1.0)
        for name, share in self._shares(place.right).items():
            found[name] = [*found.get(name, []), *product([sign], share)]
        return found

    def _original(self, term: Term) -> Term:
        """With the names of parameters that definitions repeat, as a length that is given to a part."""
        names = {factor: self._resolved(fx.Variable(factor)) for factor in (*term.above, *term.below)}
        short = {factor: each.name for factor, each in names.items() if isinstance(each, fx.Variable)}
        return Term(term.number, *(tuple(short.get(f, f) for f in line) for line in (term.above, term.below)))

    def _varied(self, of: str, name: str) -> list[Term]:
        if of in self._coordinates:
            return [Term(1.0)] if of == name else []
        return [partial_of(of, name)] if name in self._dependence.of(fx.Variable(of)) else []

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

    def _components(self, vector: fx.FlatExpression) -> _Pull:
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
        if name not in self._dependence.of(item.value):
            return []
        if (variable, name) not in self._partials:
            if self._is_written(item):
                found = self._partial(item.value, name)
            else:
                found = [] if vanishes(item.value, self._named) else [partial_of(variable, name)]
            self._partials[variable, name] = found
        return self._partials[variable, name]

    def _is_written(self, item: fm.Definition) -> bool:
        """True if the chain rule goes through the definition, whichever coordinate it is for."""
        if item.name not in self._shapes:
            try:
                for name in self._coordinates.keys() & self._dependence.of(item.value):
                    self._partial(item.value, name)
                self._shapes[item.name] = True
            except _NotWritten:
                self._shapes[item.name] = False
        return self._shapes[item.name]

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


def _entry(terms: list[Term]) -> str:
    """Of a list: without brackets around the whole."""
    text = text_of(terms)
    alone = len(terms) == 1 and terms[0].above == (text,) and text.startswith("(")
    return text[1:-1] if alone else text


def _factor(expression: fx.FlatExpression) -> str:
    text = flat_expression_text(expression)
    return f"({text})" if isinstance(expression, fx.Binary) and expression.operator in ("+", "-") else text
