"""Turns of nested loops, counted before any of them is expanded."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.language.semantics.operators.arrays import range_values, turns
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.limits import turns_fit
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import children, descendants

Loop = nodes.For | nodes.Comprehension | nodes.Reduction
# Branches that may not be taken, and bodies that are read when they are used.
_ELSEWHERE = (nodes.If, nodes.When, nodes.Conditional, nodes.Class, nodes.Function)


def unrolled(ctx: Context, scope: Scope, loop: nodes.For) -> list[Scope]:
    """A scope for each turn; none after a diagnostic."""
    return (turns(ctx, scope, loop.iterators) or []) if loop_fits(ctx, scope, loop) else []


def loop_fits(ctx: Context, scope: Scope, loop: Loop) -> bool:
    """E0326 where `loop` with the loops inside it certainly has more turns than are left. An outermost loop counts for
    all inside it; ranges that depend on its index are counted when they are expanded."""
    if scope.path or not any(isinstance(node, Loop) for each in _inside(loop) for node in descendants(each)):
        return True
    return turns_fit(ctx, loop.iterators[0].span, _least_turns(ctx, scope, loop, frozenset()))


def _least_turns(ctx: Context, scope: Scope, loop: Loop, indices: frozenset[str]) -> int:
    total = 1
    known = indices | {iterator.name for iterator in loop.iterators}
    for iterator in loop.iterators:
        if any(isinstance(node, nodes.Reference) and node.name in known for node in descendants(iterator.range)):
            return 0
        values = range_values(ctx, scope, iterator.range)
        total *= 0 if values is None else len(values)
    return total * max(1, sum(_least_of(ctx, scope, node, known) for node in _inside(loop)))


def _least_of(ctx: Context, scope: Scope, node: nodes.Node, indices: frozenset[str]) -> int:
    """Turns of the loops in `node`. No recursion: expressions may be deep."""
    found, stack = 0, [node]
    while stack:
        each = stack.pop()
        if isinstance(each, Loop):
            found += _least_turns(ctx, scope, each, indices)
        elif not isinstance(each, _ELSEWHERE):
            stack += children(each)
    return found


def _inside(loop: Loop) -> Iterable[nodes.Node]:
    return loop.body if isinstance(loop, nodes.For) else (loop.body,)
