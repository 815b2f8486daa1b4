"""The closure of a joint that brings none: six rows that put one frame onto another."""

from __future__ import annotations

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.assembly.closed_form.algebra import minus, over, plus, times, total
from lagdsl.language.semantics.operators.axes import axis_of, origin_of

# Half a turn away rows are as large as the ratio of these. Another zero lies as near to half a turn as the first is
# large.
_ASIDE = (1e-6, 1.3e-6, 1.7e-6)
_LEAST = 1e-12


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


def misalignment_anywhere(base: str, end: str) -> tuple[FlatExpression, ...]:
    """The same where the search for a start may begin half a turn away, as from the quaternion {1, 0, 0, 0}.

    There sin(a) n and 1 + cos(a) are both round-off, and so is their quotient. A term of the second order in a that
    the solution does not notice, and a denominator that is not zero, make it large: the search begins elsewhere.
    """
    crossed = [flat.Cross(axis_of(base, k), axis_of(end, k)) for k in range(3)]
    sine = flat.Binary("+", flat.Binary("+", crossed[0], crossed[1]), crossed[2])
    cosine = total([flat.Dot(axis_of(base, k), axis_of(end, k)) for k in range(3)])
    turned = minus(flat.Number(3.0), cosine)
    below = plus(cosine, flat.Number(1.0 + _LEAST))
    return tuple(over(plus(flat.Component(sine, k), times(flat.Number(_ASIDE[k]), turned)), below) for k in range(3))
