"""Estimate of the size of a derivation on paper, before anything is differentiated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import assert_never

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression_text import number_text
from lagdsl.language.flat.model import (
    Definition,
    FlatModel,
    Frame,
    Point,
    Rotate,
    RotateAbout,
    RotateQuaternion,
    SetAxes,
)
from lagdsl.language.flat.traversal import operands, postorder, step_expressions

_MOST_COORDINATES = 6
_MOST_CARRIERS = 12
_MOST_LOADS = 24
_MOST_ROWS = 12
_DEEPEST_TURNS = 6
_MOST_DEFINITIONS = 200
_LONGEST_EXPRESSION = 2000
_MOST_MULTIPLIED = 1  # a product of two has digits that no line shows
_PRINTED_DIGITS = 12
_LARGEST_DENOMINATOR = 1000
_COUNTED = 10**6
_MOST_EQUATIONS = 40
_MOST_NAMES = 1000


@dataclass(frozen=True, slots=True, kw_only=True)
class Extent:
    """`reasons` say, in plain words, what is beyond the bounds of a written-out derivation; none if nothing is.
    `has_short_parts`: single equations may be short, there are just many."""

    reasons: tuple[str, ...]
    has_short_parts: bool


def extent(flat: FlatModel) -> Extent:
    rows = sum(len(constraint.rows) for constraint in flat.constraints)
    digits = _digits(flat)
    measures = (
        (len(flat.coordinates), _MOST_COORDINATES, "coordinates"),
        (len(flat.masses) + len(flat.bodies), _MOST_CARRIERS, "masses and bodies"),
        (len(flat.loads), _MOST_LOADS, "loads"),
        (rows, _MOST_ROWS, "constraint rows"),
        (_turns(flat), _DEEPEST_TURNS, "rotations in a row"),
        (len(flat.named), _MOST_DEFINITIONS, "definitions, points and frames"),
        (_longest(flat), _LONGEST_EXPRESSION, "symbols in one expression, definitions written out"),
        (digits, _MOST_MULTIPLIED, f"numbers of more than {_PRINTED_DIGITS} digits multiplied with each other"),
    )
    reasons = tuple(f"{value} {noun} (at most {most})" for value, most, noun in measures if value > most)
    deep = _turns(flat) > _DEEPEST_TURNS or _longest(flat) > _LONGEST_EXPRESSION
    many = max(len(flat.coordinates), rows, len(flat.loads)) > _MOST_EQUATIONS or len(flat.named) > _MOST_NAMES
    return Extent(reasons=reasons, has_short_parts=not (deep or many or digits > _MOST_MULTIPLIED))


def _turns(flat: FlatModel) -> int:
    """The longest run of rotations from the world to a frame."""
    depth = {"world": 0}
    for item in flat.named:
        if isinstance(item, Frame):
            own = sum(isinstance(step, Rotate | RotateAbout | RotateQuaternion | SetAxes) for step in item.steps)
            depth[item.name] = depth.get(item.parent, 0) + own
    return max(depth.values())


def _longest(flat: FlatModel) -> int:
    """Leaves and operations of the longest expression, names replaced by what they stand for; counted up to a million.

    Frames count by the expressions of their steps: how often rotations multiply them is bounded by their depth.
    """
    known: dict[int, int] = {}
    names: dict[str, int] = {}

    def length(expression: fx.FlatExpression) -> int:
        for node in postorder(expression, known):
            inner = sum(known[id(operand)] for operand in operands(node))
            known[id(node)] = min(1 + inner + names.get(_name(node), 0), _COUNTED)
        return known[id(expression)]

    for item in flat.named:
        match item:
            case Definition(name=name, value=value):
                names[name] = length(value)
            case Point(name=name, position=position):
                names[name] = length(position)
            case Frame(name=name, parent=parent, steps=steps):
                own = sum(length(expression) for step in steps for expression in step_expressions(step))
                names[name] = names.get(parent, 0) + own
    return max([0, *names.values(), *(length(expression) for expression in _declared(flat))])


def _digits(flat: FlatModel) -> int:
    """The most numbers in one product whose digits are not all printed, names replaced by what they stand for, as those
    of a quadrature: a product of two is rounded anew, and what is written out is not what is declared."""
    known: dict[int, int] = {}
    names: dict[str, int] = {}

    def most(expression: fx.FlatExpression) -> int:
        for node in postorder(expression, known):
            inner = [known[id(operand)] for operand in operands(node)]
            known[id(node)] = min(_multiplied(node, inner) + names.get(_name(node), 0), _COUNTED)
        return known[id(expression)]

    for item in flat.named:
        names[item.name] = max(map(most, _values(item)), default=0)
    return max([0, *names.values(), *map(most, _declared(flat))])


def _multiplied(node: fx.FlatExpression, inner: list[int]) -> int:
    if isinstance(node, fx.Number):
        return int(not _is_printed(node.value))
    return sum(inner) if isinstance(node, fx.Binary) and node.operator in ("*", "/") else max(inner, default=0)


def _is_printed(value: float) -> bool:
    """True for pi, for a fraction such as 1/3 and for a number of few digits."""
    exact = Fraction(value).limit_denominator(_LARGEST_DENOMINATOR)
    short = len(number_text(abs(value)).replace(".", "").strip("0")) <= _PRINTED_DIGITS
    return short or value == math.pi or float(exact) == value


def _values(item: Definition | Point | Frame) -> Iterable[fx.FlatExpression]:
    match item:
        case Definition(value=value):
            return (value,)
        case Point(position=position):
            return (position,)
        case Frame(steps=steps):
            return (expression for step in steps for expression in step_expressions(step))
        case _:
            assert_never(item)


def _name(node: fx.FlatExpression) -> str:
    match node:
        case fx.Variable(name) | fx.PointReference(name):
            return name
        case fx.OfFrame():
            return node.frame
        case fx.Number() | fx.Previous() | fx.Derivative() | fx.Operation() | fx.Mechanical() | fx.OfMechanism():
            return ""
        case _:
            assert_never(node)


def _declared(flat: FlatModel) -> Iterator[fx.FlatExpression]:
    """Expressions that are differentiated beyond points and frames."""
    yield from (term.value for term in flat.energies)
    yield from (mass.position for mass in flat.masses)
    for constraint in flat.constraints:
        yield from constraint.residuals
