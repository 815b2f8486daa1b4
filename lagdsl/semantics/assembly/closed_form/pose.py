"""The closure of a joint that brings none: six rows that put one frame onto another."""

from __future__ import annotations

from lagdsl.flat import expression as flat
from lagdsl.flat.expression import FlatExpression
from lagdsl.semantics.assembly.closed_form.algebra import minus, over, times, total
from lagdsl.semantics.assembly.closed_form.computed import four_squares
from lagdsl.semantics.operators.axes import axis_of, origin_of


def displacement(base: str, end: str) -> tuple[FlatExpression, ...]:
    """World components of the way between the origins [m]."""
    way = flat.Binary("-", origin_of(end), origin_of(base))
    return tuple(flat.Component(way, k) for k in range(3))


def misalignment(base: str, end: str) -> tuple[FlatExpression, ...]:
    """World components of tan(a/2) n, for the turn a about n from `base` to `end` (Rodrigues' vector).

    It vanishes only where the axes coincide: the vector part sin(a) n of the rotation matrix alone vanishes for half a
    turn as well. Three smooth rows that vanish once do not exist on the rotations; this one is infinite at half a turn,
    and Newton's step from any other turn leads nearer (from a to sin a).
    """
    crossed = [flat.Cross(axis_of(base, k), axis_of(end, k)) for k in range(3)]
    aligned = [flat.Dot(axis_of(base, k), axis_of(end, k)) for k in range(3)]
    sine = flat.Binary("+", flat.Binary("+", crossed[0], crossed[1]), crossed[2])
    cosine = flat.Binary("+", flat.Binary("+", aligned[0], aligned[1]), aligned[2])
    vector = flat.Binary("/", sine, flat.Binary("+", flat.ONE, cosine))
    return tuple(flat.Component(vector, k) for k in range(3))


def quaternion_residual(base: str, end: str, e: tuple[FlatExpression, ...]) -> tuple[FlatExpression, ...]:
    """(E E' - 1) e with the unit quaternion E of the turn from `base` to `end`: four rows, of which three are
    independent. They vanish at multiples of E only and are smooth everywhere, half a turn away as well."""
    square = four_squares(base, end)
    four = flat.Number(4.0)
    return tuple(minus(over(total([times(square[i][j], e[j]) for j in range(4)]), four), e[i]) for i in range(4))
