"""Coordinates of a cut joint from the frames on its two sides, in closed form.

The kinematics of the joint say base * steps(q) = end. The axes and origins of both determine q: angles by atan2, with
the branch cut opposite to the start; lengths as components; a quaternion from the rotation matrix. Sources: Goldstein,
*Classical Mechanics* (3rd ed.), 4.4 (sequences of angles); Shepperd, *J. Guidance and Control* 1 (1978) 223 (4 e e' in
terms of the matrix).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import assert_never

from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FrameStep, Move, Place, Rotate, RotateAbout, RotateQuaternion, SetAxes
from lagdsl.language.semantics.assembly.closed_form.algebra import minus, negative, over, plus, times, total
from lagdsl.language.semantics.assembly.closed_form.inverse import inverse
from lagdsl.language.semantics.assembly.closed_form.linear import linear, variables
from lagdsl.language.semantics.operators.axes import axis_of, origin_of


class NoFormulaError(Exception):
    """The kinematics are of no form that is solved here."""


@record()
class Formula:
    """One coordinate. `turn`: it is known up to multiples of this; zero: up to the sign of a quaternion."""

    name: str
    value: FlatExpression
    turn: FlatExpression | None


class Solver:
    """Finds the coordinates of one joint, in an order in which each may use those before.

    `frame(parent, steps)` names a frame made on the way, `found` is told of each formula at once; `starts` are the
    start values of the coordinates by name.
    """

    def __init__(
        self,
        base: str,
        end: str,
        starts: dict[str, FlatExpression],
        frame: Callable[[str, tuple[FrameStep, ...]], str],
        found: Callable[[Formula], None],
    ) -> None:
        self._base, self._end, self._starts = base, end, starts
        self._frame, self._found = frame, found
        self._solved: set[str] = set()

    def solve(self, steps: tuple[FrameStep, ...]) -> None:
        """All coordinates; raises NoFormulaError where there is none."""
        if any(isinstance(step, Place | SetAxes) for step in steps):
            raise NoFormulaError
        self._turning(tuple(step for step in steps if not isinstance(step, Move)))
        self._moved(steps)
        if len(self._solved) != len(self._starts):
            raise NoFormulaError

    def _free(self, *parts: FlatExpression) -> list[str]:
        """The coordinates in expressions."""
        return [name for name in variables(parts) if name in self._starts]

    def _give(self, name: str, value: FlatExpression, turn: FlatExpression | None = None) -> None:
        if name in self._solved:
            raise NoFormulaError
        self._solved.add(name)
        self._found(Formula(name, value, turn))

    # ---- turning -----------------------------------------------------------------------------------------------------

    def _turning(self, steps: tuple[FrameStep, ...]) -> None:
        free = [k for k, step in enumerate(steps) if self._free(*_angles(step))]
        if not free:
            return
        first, last = free[0], free[-1]
        if free != list(range(first, last + 1)):
            raise NoFormulaError
        base = self._frame(self._base, steps[:first])
        end = self._frame(self._end, _undone(steps[last + 1 :]))
        turns = steps[first : last + 1]
        if len(turns) == 1 and isinstance(turns[0], RotateQuaternion):
            self._quaternion(base, end, turns[0].e)
        elif len(turns) == 1 and isinstance(turns[0], RotateAbout):
            self._about(base, end, turns[0])
        else:
            self._sequence(base, end, turns)

    def _sequence(self, base: str, end: str, turns: tuple[FrameStep, ...]) -> None:
        """One to three turns about own axes, neighbors different."""
        known = [step for step in turns if isinstance(step, Rotate)]
        if len(known) != len(turns) or any(a.axis == b.axis for a, b in pairwise(known)):
            raise NoFormulaError
        match known:
            case [one]:
                self._one(base, end, one)
            case [one, two]:
                self._two(base, end, one, two)
            case [one, two, three]:
                self._first_of_three(base, end, one, two, three)
                self._two(self._frame(base, (one,)), end, two, three)
            case _:
                raise NoFormulaError

    def _angle(self, angle: FlatExpression, cosine: FlatExpression, sine: FlatExpression) -> None:
        """The coordinate in an angle a q + b whose cosine and sine are known up to a common positive factor."""
        [name] = self._free(angle) or [""]
        found = linear(angle, name)
        if found is None or name not in self._starts or self._free(*found):
            raise NoFormulaError
        factor, rest = found
        at = plus(times(factor, self._starts[name]), rest)
        turned = turn_near(at, cosine, sine)
        turn = flat.Function("abs", (over(flat.Number(2.0 * math.pi), factor),))
        self._give(name, over(minus(turned, rest), factor), turn)

    def _one(self, base: str, end: str, step: Rotate) -> None:
        i, j = (step.axis + 1) % 3, (step.axis + 2) % 3
        cosine = plus(_dot(base, i, end, i), _dot(base, j, end, j))
        sine = minus(_dot(base, j, end, i), _dot(base, i, end, j))
        self._angle(step.angle, cosine, sine)

    def _about(self, base: str, end: str, step: RotateAbout) -> None:
        """cos: (trace - n.R n)/2, sin: n.vex(R), with n = axis/|axis|; here both times 2."""
        square = total([times(part, part) for part in step.axis])
        along = [_along(frame, step.axis) for frame in (base, end)]
        cosine = minus(total([_dot(base, k, end, k) for k in range(3)]), over(flat.Dot(along[0], along[1]), square))
        crossed = [flat.Cross(axis_of(base, k), axis_of(end, k)) for k in range(3)]
        sine = flat.Dot(along[0], flat.Binary("+", flat.Binary("+", crossed[0], crossed[1]), crossed[2]))
        self._angle(step.angle, cosine, over(sine, flat.Function("sqrt", (square,))))

    def _two(self, base: str, end: str, one: Rotate, two: Rotate) -> None:
        """R = R1(a) R2(b): axis 2 of the end turns with a about axis 1; seen from the end, axis 1 turns with -b."""
        self._angle(one.angle, *_turned(one.axis, two.axis, lambda k: _dot(base, k, end, two.axis)))
        cosine, sine = _turned(two.axis, one.axis, lambda k: _dot(end, k, base, one.axis))
        self._angle(two.angle, cosine, negative(sine))

    def _first_of_three(self, base: str, end: str, one: Rotate, two: Rotate, three: Rotate) -> None:
        """Axis 3 of the end lies in the plane of axis 1 and a direction that turns with the first angle. The start of
        the second angle selects one of its two ends."""
        second = self._at_start(two.angle)
        if three.axis == one.axis:
            # R2(b) e1 = cos b e1 + sin b (e2 x e1)
            middle = 3 - one.axis - two.axis
            across = flat.Function("sin", (second,))
            sign = _sign(across if (two.axis + 1) % 3 == one.axis else negative(across))
        else:
            middle, sign = three.axis, _sign(flat.Function("cos", (second,)))
        cosine, sine = _turned(one.axis, middle, lambda k: _dot(base, k, end, three.axis))
        self._angle(one.angle, times(sign, cosine), times(sign, sine))

    def _at_start(self, angle: FlatExpression) -> FlatExpression:
        [name] = self._free(angle) or [""]
        found = linear(angle, name)
        if found is None or name not in self._starts:
            raise NoFormulaError
        return plus(times(found[0], self._starts[name]), found[1])

    def _quaternion(self, base: str, end: str, e: tuple[FlatExpression, ...]) -> None:
        """The unit quaternion on the side of the start: the longest column of 4 e e', normalized."""
        names = [part.name if isinstance(part, flat.Variable) else "" for part in e]
        if any(name not in self._starts for name in names) or len(set(names)) != 4:
            raise NoFormulaError
        square = four_squares(base, end)
        longest = [_longest(square, i) for i in range(4)]
        side = _sign(total([times(part, self._starts[name]) for name, part in zip(names, longest, strict=True)]))
        length = flat.Function("sqrt", (total([times(part, part) for part in longest]),))
        for name, part in zip(names, longest, strict=True):
            self._give(name, over(times(side, part), length), flat.ZERO)

    # ---- moving ------------------------------------------------------------------------------------------------------

    def _moved(self, steps: tuple[FrameStep, ...]) -> None:
        free = [k for k, step in enumerate(steps) if isinstance(step, Move) and self._free(*step.offset)]
        if not free:
            return
        if len(free) > 1:
            raise NoFormulaError
        place = free[0]
        step = steps[place]
        assert isinstance(step, Move)
        base = self._frame(self._base, steps[:place])
        end = self._frame(self._end, _undone(steps[place + 1 :]))
        way = flat.Binary("-", origin_of(end), origin_of(base))
        names = self._free(*step.offset)
        factors, rest = self._columns(step.offset, names)
        parts = [minus(flat.Dot(way, axis_of(base, k)), rest[k]) for k in range(3)]
        along = [_product(column, parts) for column in factors]
        square = [[_product(one, two) for two in factors] for one in factors]
        for name, value in zip(names, _solved(square, along), strict=True):
            self._give(name, value)

    def _columns(
        self, offset: tuple[FlatExpression, ...], names: list[str]
    ) -> tuple[list[list[FlatExpression]], list[FlatExpression]]:
        """offset = sum of coordinate * column + rest."""
        columns: list[list[FlatExpression]] = []
        rest = list(offset)
        for name in names:
            found = [linear(part, name) for part in rest]
            known = [part for part in found if part is not None]
            if len(known) < len(found) or self._free(*(factor for factor, _ in known)):
                raise NoFormulaError
            columns.append([factor for factor, _ in known])
            rest = [remainder for _, remainder in known]
        return columns, rest


def _product(one: list[FlatExpression], two: list[FlatExpression]) -> FlatExpression:
    return total([times(a, b) for a, b in zip(one, two, strict=True)])


def _solved(square: list[list[FlatExpression]], along: list[FlatExpression]) -> list[FlatExpression]:
    """The normal equations of up to two coordinates, or of any number along directions across each other."""
    count = len(along)
    if all(square[i][j] == flat.ZERO for i in range(count) for j in range(count) if i != j):
        return [over(along[k], square[k][k]) for k in range(count)]
    if count != 2:
        raise NoFormulaError
    (a, b), (_, c) = square
    size = minus(times(a, c), times(b, b))
    one = minus(times(c, along[0]), times(b, along[1]))
    two = minus(times(a, along[1]), times(b, along[0]))
    return [over(one, size), over(two, size)]


def four_squares(base: str, end: str) -> list[list[FlatExpression]]:
    """4 e e' of the unit quaternion e that turns `base` to `end`: both signs have the same."""
    r = [[_dot(base, i, end, j) for j in range(3)] for i in range(3)]
    d = [r[k][k] for k in range(3)]
    x, y, z = minus(r[2][1], r[1][2]), minus(r[0][2], r[2][0]), minus(r[1][0], r[0][1])
    xy, xz, yz = plus(r[0][1], r[1][0]), plus(r[0][2], r[2][0]), plus(r[1][2], r[2][1])
    one = flat.ONE
    return [
        [total([one, d[0], d[1], d[2]]), x, y, z],
        [x, minus(minus(plus(one, d[0]), d[1]), d[2]), xy, xz],
        [y, xy, minus(minus(plus(one, d[1]), d[0]), d[2]), yz],
        [z, xz, yz, minus(minus(plus(one, d[2]), d[0]), d[1])],
    ]


def turn_near(at: FlatExpression, cosine: FlatExpression, sine: FlatExpression) -> FlatExpression:
    """The angle of a direction that is less than half a turn from `at`."""
    if at == flat.ZERO:
        return flat.Function("atan2", (sine, cosine))
    c, s = flat.Function("cos", (at,)), flat.Function("sin", (at,))
    across = minus(times(sine, c), times(cosine, s))
    along = plus(times(cosine, c), times(sine, s))
    return plus(at, flat.Function("atan2", (across, along)))


def _angles(step: FrameStep) -> tuple[FlatExpression, ...]:
    match step:
        case Rotate(angle=angle):
            return (angle,)
        case RotateAbout(axis=axis, angle=angle):
            return (*axis, angle)
        case RotateQuaternion(e=e):
            return e
        case SetAxes() | Move() | Place():
            return ()
        case _:
            assert_never(step)


def _undone(steps: tuple[FrameStep, ...]) -> tuple[FrameStep, ...]:
    undone = inverse(steps)
    if undone is None:
        raise NoFormulaError
    return undone


def _dot(a: str, i: int, b: str, j: int) -> FlatExpression:
    return flat.Dot(axis_of(a, i), axis_of(b, j))


def _along(frame: str, own: tuple[FlatExpression, FlatExpression, FlatExpression]) -> FlatExpression:
    x, y, z = (flat.Binary("*", part, axis_of(frame, k)) for k, part in enumerate(own))
    return flat.Binary("+", flat.Binary("+", x, y), z)


def _turned(
    about: int, start: int, component: Callable[[int], FlatExpression]
) -> tuple[FlatExpression, FlatExpression]:
    """Cosine and sine of the turn about an axis that brings axis `start` to a vector with these components."""
    i, j = (about + 1) % 3, (about + 2) % 3
    if start == i:
        return component(i), component(j)
    return component(j), negative(component(i))


def _longest(square: list[list[FlatExpression]], row: int) -> FlatExpression:
    """Element `row` of the column of 4 e e' that is the longest: that with the largest e."""
    found = square[row][0]
    most = square[0][0]
    for k in range(1, 4):
        longer = flat.Binary("<", most, square[k][k])
        found = flat.Conditional(longer, square[row][k], found)
        most = flat.Function("max", (most, square[k][k]))
    return found


def _sign(value: FlatExpression) -> FlatExpression:
    """1 for zero, too."""
    below = flat.Binary("<", value, flat.ZERO)
    return flat.Conditional(below, flat.Number(-1.0), flat.ONE)
