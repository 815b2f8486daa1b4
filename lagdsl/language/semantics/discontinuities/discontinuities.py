"""From discontinuities as they stand in the text to what the runtime does there: one pass over the flat model.

| it is | of time alone | of the motion |
|---|---|---|
| a relation, `sign` | an entry of the kind `timed` | a relation |
| a function that jumps, or over which velocities jump | the same | a relation, on which its branch depends |
| another function | the same | as it stands; steps end where the distance of a corner passes zero |
| in `noEvent`, the cut of `atan2` | nothing | as it stands, with a corner that starts and sweeps know |

`max(a, b)` of time is `a` or `b` by the truth of `a - b >= 0`, `floor(x)` a whole number, a table the polynomial of one
interval. All of that is constant between events, so the equations are smooth there, and a derivative by time is that of
the present piece. Nothing is stepped over: the instants are computed ahead.

A force reads a continuous function of the motion as it stands: `sqrt(max(x, 0))` must not see a negative number. One
that jumps is held: at a jump it has no value, and a start there would see one side in the first stage of a step and the
other in the next.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, assert_never

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.events import BRANCH
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.flat.reached import reached
from lagdsl.language.flat.traversal import operands, rewritten
from lagdsl.language.semantics.discontinuities.branching import branching
from lagdsl.language.semantics.discontinuities.corners import with_corners
from lagdsl.language.semantics.discontinuities.distances import at_whole_numbers
from lagdsl.language.semantics.discontinuities.entries import Entries
from lagdsl.language.semantics.operators.arithmetic import negative
from lagdsl.language.semantics.operators.pieces import chosen_by_number
from lagdsl.language.semantics.scope.product import Met, Pieces
from lagdsl.language.semantics.scope.values import Order

# Subtracted from zero, it makes a negative number.
_LEAST = 1e-300


def discontinuities(flat: fm.FlatModel, met: Sequence[Met], sink: Sink) -> fm.FlatModel:
    """`flat` with guards in place of the discontinuities `met`, and with its corners; N0309 for the first jump that is
    no event."""
    if not met:
        return flat
    guards = _Guards(flat, met)
    flat = replace(flat, named=tuple(map(guards.steady, flat.named)))
    known, flat = rewritten((tuple(met), flat), guards.rule)
    flat = replace(flat, events=guards.entries.added(flat.events))
    kinks = [now for each, now in zip(met, known, strict=True) if guards.is_kink(each)]
    jump = next((each for each in kinks if each.located and each.function in ("floor", "ceil", "mod")), None)
    if jump is not None:
        sink.report("N0309", jump.spans[0], name=jump.function)
    return with_corners(flat, kinks)


class _Guards:
    """Decides which discontinuities are guards, and makes them."""

    def __init__(self, flat: fm.FlatModel, met: Sequence[Met]) -> None:
        self.entries = Entries()
        self._flat = flat
        self._met = {id(each.expression): each for each in met}
        truths = [each for each in met if each.located and _is_truth(each.expression)]
        self._truths = {id(each.expression) for each in truths}
        functions = [each for each in met if each.located and id(each.expression) not in self._truths]
        self._branching = branching(flat, [each for each in functions if each.order > Order.STILL], truths)
        whole = {id(each.expression) for each in met if each.located and _is_whole(each.expression)}
        known = {id(each.expression) for each in met if each.order == Order.STILL}
        self._steps = self._truths | (whole & (self._branching | known)) if whole & self._branching else set()
        self._moving = {"time"} | {item.name for item in (*flat.coordinates, *flat.states, *flat.inputs)}
        self._moving |= {delay.name for delay in flat.events.delays}
        self._resting = {id(each.expression) for each in met if self._rests(operands(each.expression))}

    def _rests(self, parts: Sequence[FlatExpression]) -> bool:
        """True for what changes with the whole number of a guard only."""
        if not self._steps:
            return False
        below = reached(self._flat, parts, lambda x: () if id(x) in self._steps else operands(x))
        moves = ((isinstance(x, fx.Variable) and x.name in self._moving) or isinstance(x, fx.Mechanical) for x in below)
        return not any(moves)

    def steady(self, item: fm.Named) -> fm.Named:
        """A definition that changes with guards only is discrete."""
        if isinstance(item, fm.Definition) and item.variability == Variability.CONTINUOUS and self._rests([item.value]):
            return replace(item, variability=Variability.DISCRETE)
        return item

    def _is_guard(self, met: Met) -> bool:
        key = id(met.expression)
        if not met.located or key in self._resting:
            return False
        return met.order == Order.STILL or key in self._truths or key in self._branching

    def is_kink(self, met: Met) -> bool:
        """True if the motion meets it as it stands."""
        return met.order > Order.STILL and not self._is_guard(met) and id(met.expression) not in self._resting

    def rule(self, node: Any, of: Callable[[Any], Any]) -> FlatExpression | None:
        """The guard in place of a node of the text; None where the node stays."""
        met = self._met.get(id(node))
        if met is None or not self._is_guard(met):
            return None
        if met.pieces is not None:
            return self._piece(met, of(met.pieces))
        expression = met.expression
        if isinstance(expression, fx.Binary):
            return self._relation(met, expression.operator, of(expression.left), of(expression.right))
        assert isinstance(expression, fx.Function)
        return self._function(met, expression.name, of(expression.arguments))

    def _truth(self, met: Met, text: str, difference: FlatExpression, *, strict: bool, told: bool) -> fx.Variable:
        if met.order == Order.STILL:
            return self.entries.timed_truth(met, text, difference, strict=strict, told=told)
        return self.entries.relation(met, text, difference, strict=strict)

    def _relation(
        self, met: Met, operator: fx.BinaryOperator, left: FlatExpression, right: FlatExpression
    ) -> FlatExpression:
        """Whole numbers are the same where they differ by less than a half."""
        match operator:
            case ">" | ">=" | "<" | "<=":
                larger, smaller = (left, right) if operator in (">", ">=") else (right, left)
                difference = larger if smaller == fx.ZERO else fx.Binary("-", larger, smaller)
                return self._truth(met, met.text, difference, strict=operator in ("<", ">"), told=True)
            case "==" | "<>":
                apart = fx.Function("abs", (fx.Binary("-", left, right),))
                near = fx.Binary("-", fx.Number(0.5), apart)
                same = self._truth(met, met.text, near, strict=True, told=True)
                return same if operator == "==" else fx.Unary("not", same)
            case "+" | "-" | "*" | "/" | "^" | "and" | "or":
                raise AssertionError(f"{operator} is no relation")
            case _:
                assert_never(operator)

    def _function(self, met: Met, name: str, arguments: tuple[FlatExpression, ...]) -> FlatExpression:
        x, other = arguments[0], arguments[-1]
        match name:
            case "sign":
                above = self._truth(met, f"{met.text} > 0", x, strict=True, told=True)
                below = self._truth(met, f"{met.text} < 0", fx.Unary("-", x), strict=True, told=True)
                return fx.Conditional(above, fx.ONE, fx.Conditional(below, fx.Number(-1.0), fx.ZERO))
            case "abs":
                return fx.Conditional(self._branch(met, x), x, negative(x))
            case "max":
                return fx.Conditional(self._branch(met, fx.Binary("-", x, other)), x, other)
            case "min":
                return fx.Conditional(self._branch(met, fx.Binary("-", x, other)), other, x)
            case "floor":
                return self._whole(met, x)
            case "ceil":
                return negative(self._whole(met, negative(x)))
            case "mod":
                return fx.Binary("-", x, fx.Binary("*", self._whole(met, fx.Binary("/", x, other)), other))
            case _:
                raise AssertionError(f"{name} is no discontinuity")

    def _branch(self, met: Met, difference: FlatExpression) -> fx.Variable:
        """The truth on which the branch of a continuous function depends."""
        return self._truth(met, BRANCH + met.text, difference, strict=False, told=False)

    def _whole(self, met: Met, x: FlatExpression) -> FlatExpression:
        """floor(x). Of the motion it is the nearest even or odd number, by a relation that turns at each whole number:
        near such a number neither of them jumps."""
        if met.order == Order.STILL:
            return self.entries.whole(met, met.text, x)
        half, two = fx.Binary("/", x, fx.Number(2.0)), fx.Number(2.0)
        odd_now = fx.Function("mod", (fx.Function("floor", (x,)), two))
        even = fx.Binary("-", at_whole_numbers(x), fx.Binary("*", fx.Number(_LEAST), odd_now))
        is_even = self._branch(replace(met, dimension=DIMENSIONLESS), even)

        def nearest(shift: float) -> FlatExpression:
            return fx.Binary("*", two, fx.Function("floor", (fx.Binary("+", half, fx.Number(shift)),)))

        return fx.Conditional(is_even, nearest(0.25), fx.Binary("+", nearest(-0.25), fx.ONE))

    def _piece(self, met: Met, pieces: Pieces) -> FlatExpression:
        """The value on the interval in which x is; of the motion its number is that of the relations that hold."""
        x, borders = pieces.x, pieces.borders
        number: FlatExpression = fx.ZERO
        if met.order == Order.STILL:
            number = self.entries.piece(met, f"piece of {met.text}", x, borders)
        else:
            for border in borders:
                beyond = self._branch(met, fx.Binary("-", x, fx.Number(border)))
                number = fx.Binary("+", number, fx.Conditional(beyond, fx.ONE, fx.ZERO))
        return chosen_by_number(number, pieces.values)


def _is_truth(expression: FlatExpression) -> bool:
    """True for relations, and for `sign`, which is two of them."""
    return isinstance(expression, fx.Binary) or (isinstance(expression, fx.Function) and expression.name == "sign")


def _is_whole(expression: FlatExpression) -> bool:
    return isinstance(expression, fx.Function) and expression.name in ("floor", "ceil")
