"""`when` clauses: conditions, and what is to be done where one becomes true."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from typing import assert_never

from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import events
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Spans, Variability
from lagdsl.language.semantics.events.resets import resets, what_it_is
from lagdsl.language.semantics.operators import arrays
from lagdsl.language.semantics.operators.arguments import named_element, positional
from lagdsl.language.semantics.operators.arithmetic import Operand, boolean
from lagdsl.language.semantics.operators.assertions import asserted
from lagdsl.language.semantics.operators.nested_loops import unrolled
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name, kind_of
from lagdsl.language.semantics.scope.scope import Indices, Scope, Symbol
from lagdsl.language.semantics.scope.values import Array, Order, Poison, Scalar, Text
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.variables.resolver import every
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants


def check_targets(ctx: Context, items: Iterable[Placed]) -> None:
    """E0373 for plain variables that get their values in clauses only; nothing more is said about these."""
    for placed in items:
        for node in descendants(placed.node) if isinstance(placed.node, nodes.When) else ():
            if isinstance(node, nodes.Equation):
                side = node.left.target if isinstance(node.left, nodes.Index) else node.left
                found = named_element(ctx, placed.scope, side) if isinstance(side, _NAMES) else None
                if found is not None and found[0].kind in ("algebraic", "output") and not found[0].given.bindings:
                    ctx.sink.report("E0373", side.span, *what_it_is(ctx, placed.scope, side), name=side.span.text)
                    found[0].kind = "unknown"


_NAMES = (nodes.Reference, nodes.Member)


def elaborate_when(ctx: Context, placed: Placed) -> None:
    """Add the clause to the model, or report why not."""
    node = placed.node
    assert isinstance(node, nodes.When)
    branches = []
    for branch in node.branches:
        conditions = _conditions(ctx, placed.scope, branch.condition)
        body = _Body(ctx)
        with ctx.current.standing(in_clause=True):
            body.read(branch.body, placed.scope, None)
        memories = tuple(ctx.product.occurrences.condition(_text(branch.condition)) for _ in conditions)
        spans = (branch.condition.span, *placed.scope.spans)
        branches.append(
            events.Branch(spans=spans, conditions=conditions, memories=memories, actions=tuple(body.actions))
        )
    spans = (node.span, *placed.scope.spans)
    ctx.product.occurrences.whens.append(events.When(spans=spans, branches=tuple(branches)))


def _text(condition: nodes.Expression) -> str:
    return " ".join(condition.span.text.split())


def _conditions(ctx: Context, scope: Scope, node: nodes.Expression) -> tuple[FlatExpression, ...]:
    """One condition, or several in braces; each of them may become true by itself."""
    with ctx.current.standing(in_clause=True):
        parts = node.elements if isinstance(node, nodes.Array) else (node,)
        found = [(part, each) for part in parts for each in _truths(ctx, scope, part)]
    for part, condition in found:
        if condition.variability == Variability.CONTINUOUS:
            ctx.sink.report("E0371", part.span)
        elif condition.variability != Variability.DISCRETE:
            ctx.sink.report("E0372", part.span)
    return tuple(condition.expression for _, condition in found)


def _truths(ctx: Context, scope: Scope, node: nodes.Expression) -> list[Scalar]:
    """The truth, or those of an array of Booleans."""
    value = ctx.elaborate(ctx, scope, node, False)
    if isinstance(value, Array) and value.kind == "Boolean":
        return arrays.elements_of(value)
    condition = boolean(ctx, Operand(node, value))
    return [condition] if condition is not None else []


@mutable_record()
class _Body:
    """The actions of one branch in the order of the text."""

    ctx: Context
    actions: list[events.Action] = field(default_factory=list)

    def read(self, items: Iterable[nodes.Item], scope: Scope, guard: FlatExpression | None) -> None:
        for item in items:
            match item:
                case nodes.Equation():
                    self._assign(item, scope, guard)
                case nodes.CallEquation():
                    self._call(item, scope, guard)
                case nodes.For():
                    for turn in unrolled(self.ctx, scope, item):
                        self.read(item.body, turn, guard)
                case nodes.If():
                    self._if(item, scope, guard)
                case nodes.When():
                    hint = "a clause inside would act where two things become true at once: write it beside this one"
                    self.ctx.sink.report("E0378", _keyword(item), help=hint)
                case nodes.Import() | nodes.Definition() | nodes.Declaration() | nodes.Physics() | nodes.Connect():
                    self.ctx.sink.report("E0378", item.span)
                case nodes.Extends() | nodes.Annotation():
                    self.ctx.sink.report("E0378", item.span)
                case _:
                    assert_never(item)

    def _if(self, item: nodes.If, scope: Scope, guard: FlatExpression | None) -> None:
        """The conditions of the branches before are false in the branches after."""
        for branch in item.branches:
            with self.ctx.current.without_relations():
                condition = boolean(
                    self.ctx, Operand(branch.condition, self.ctx.elaborate(self.ctx, scope, branch.condition, False))
                )
            if condition is None:
                return
            self.read(branch.body, scope, _both(guard, condition.expression))
            guard = _both(guard, flat.Unary("not", condition.expression))
        if item.otherwise is not None:
            self.read(item.otherwise, scope, guard)

    # ---- v = e -------------------------------------------------------------------------------------------------------

    def _assign(self, item: nodes.Equation, scope: Scope, guard: FlatExpression | None) -> None:
        ctx = self.ctx
        found = next(filter(None, (_target(ctx, scope, side) for side in (item.left, item.right))), None)
        if found is None:
            named = what_it_is(ctx, scope, item.left)
            if named or not isinstance(ctx.elaborate(ctx, scope, item.left, False), Poison):
                ctx.sink.report("E0373", item.left.span, *named, name=item.left.span.text)
            return
        symbol, indices = found
        side, other = (item.left, item.right)
        if _target(ctx, scope, item.left) is None:
            side, other = other, side
        shape = ctx.resolver.shape(ctx, symbol)
        if shape is None or symbol.info is None:
            return
        shape = shape[len(indices) :]
        with ctx.current.without_relations():
            value = ctx.elaborate(ctx, scope, other, True)
        expected = Expected(
            f"`{symbol.short}`", symbol.info.dimension or DIMENSIONLESS, shape, symbol.info.base, symbol.info.unit
        )
        got = conform(ctx, scope, other, value, expected)
        if got is None:
            return
        parts = (got.expression,) if isinstance(got, Scalar) else got.elements
        spans = (item.span, *scope.spans)
        for rest, part in zip(every(shape), parts, strict=True):
            name = element_name(symbol.name, (*indices, *rest))
            self.actions.append(events.Assign(spans=spans, variable=name, value=part, guard=guard))

    # ---- calls -------------------------------------------------------------------------------------------------------

    def _call(self, item: nodes.CallEquation, scope: Scope, guard: FlatExpression | None) -> None:
        call, ctx = item.call, self.ctx
        name = call.function.span.text if isinstance(call, nodes.Call) else ""
        spans = (item.span, *scope.spans)
        match name:
            case "reinit":
                assert isinstance(call, nodes.Call)
                self.actions += resets(ctx, call, scope, spans, guard)
            case "terminate":
                message = self._message(call, scope, 1)
                if message is not None:
                    self.actions.append(events.Terminate(spans=spans, message=message, guard=guard))
            case "assert":
                self._check(call, scope, spans, guard)
            case "impact":
                self._impact(call, scope, spans, guard)
            case _:
                equal = isinstance(call, nodes.Binary) and call.operator == "=="
                hint = "an assignment is written with a single `=`" if equal else None
                ctx.sink.report("E0378", item.span, help=hint)

    def _message(self, call: nodes.Expression, scope: Scope, count: int) -> str | None:
        """The last of `count` arguments."""
        assert isinstance(call, nodes.Call)
        arguments = positional(self.ctx, call, count, count)
        if arguments is None:
            return None
        message = self.ctx.elaborate(self.ctx, scope, arguments[-1], False)
        if isinstance(message, Text):
            return message.value
        if not isinstance(message, Poison):
            span = arguments[-1].span
            self.ctx.sink.report("E0312", span, expected="a message in quotes", found=kind_of(message))
        return None

    def _check(self, call: nodes.Expression, scope: Scope, spans: Spans, guard: FlatExpression | None) -> None:
        assert isinstance(call, nodes.Call)
        found = asserted(self.ctx, scope, call)
        if found is not None:
            check = events.Check(
                spans=spans, condition=found.condition, message=found.message, warning=found.warning, guard=guard
            )
            self.actions.append(check)

    def _impact(self, call: nodes.Expression, scope: Scope, spans: Spans, guard: FlatExpression | None) -> None:
        ctx = self.ctx
        assert isinstance(call, nodes.Call)
        arguments = positional(ctx, call, 2, 2)
        if arguments is None:
            return
        with ctx.current.without_relations():
            gap, restitution = (ctx.elaborate(ctx, scope, argument, False) for argument in arguments)
        if not isinstance(gap, Scalar):
            if not isinstance(gap, Poison):
                ctx.sink.report("E0312", arguments[0].span, expected="a gap", found=kind_of(gap))
            return
        if gap.order != Order.CONFIGURATION:
            ctx.sink.report("E0382", arguments[0].span)
            return
        factor = conform(ctx, scope, arguments[1], restitution, Expected("the restitution", DIMENSIONLESS, ()))
        if isinstance(factor, Scalar):
            impact = events.Impact(spans=spans, gap=gap.expression, restitution=factor.expression, guard=guard)
            self.actions.append(impact)


def _keyword(item: nodes.When) -> Span:
    return Span(item.span.file, item.span.start, item.span.start + len("when"))


def _both(one: FlatExpression | None, two: FlatExpression) -> FlatExpression:
    return two if one is None else flat.Binary("and", one, two)


def _target(ctx: Context, scope: Scope, side: nodes.Expression) -> tuple[Symbol, Indices] | None:
    """The discrete variable, or the element of one, that an equation gives a value."""
    if not isinstance(side, nodes.Reference | nodes.Member | nodes.Index):
        return None
    found = named_element(ctx, scope, side)
    return found if found is not None and found[0].kind == "discrete" else None
