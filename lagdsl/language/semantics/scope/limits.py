"""Bounds of the expansion of loops, arrays and functions, each with a diagnostic (E0326)."""

from __future__ import annotations

import math

from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Indices, Symbol

MAX_ELEMENTS = 100_000
"""Elements of one array, values of one range."""

MAX_TURNS = 200_000
"""Turns of all loops, comprehensions and reductions of a model together."""

MAX_COORDINATES = 40_000
"""Coordinates and states: the runtime reserves a hundred matrices of them, of which it touches the pages with entries;
these are 1.3 TB of the 128 TB that a process can address."""

MAX_COMPONENTS = 2 * MAX_COORDINATES
"""Components of a model, those of components included: a joint and a link for each coordinate."""

MAX_CALLS = 50_000
"""Calls of the user's functions that are expanded in place, nested ones included."""


def array_fits(ctx: Context, span: Span, shape: tuple[int, ...], *, moves: bool = False) -> bool:
    """E0326 unless an array of this shape can be held; one that `moves` counts as coordinates and states."""
    if moves:
        ctx.counts.coordinates += math.prod(shape)
    fits = _fits(ctx, span, "an array", math.prod(shape), MAX_ELEMENTS)
    many = "the number of coordinates and states"
    return fits and (not moves or _fits(ctx, span, many, ctx.counts.coordinates, MAX_COORDINATES))


def shape_fits(ctx: Context, symbol: Symbol, shape: tuple[int, ...]) -> bool:
    """E0326 unless an array of this shape can be held, E0334 unless frames are given for all of it."""
    fits = array_fits(ctx, symbol.span, shape, moves=symbol.kind in ("coordinate", "state"))
    return fits and _frames_fit(ctx, symbol, shape)


def range_fits(ctx: Context, span: Span, count: int) -> bool:
    return _fits(ctx, span, "a range", count, MAX_ELEMENTS)


def another_turn(ctx: Context, span: Span) -> bool:
    """Count a turn of a loop."""
    ctx.counts.turns += 1
    return turns_fit(ctx, span, 0)


def turns_fit(ctx: Context, span: Span, more: int) -> bool:
    """E0326 where `more` turns beside those counted are too many."""
    return _fits(ctx, span, "the number of loop turns", ctx.counts.turns + more, MAX_TURNS)


def another_component(ctx: Context, span: Span) -> bool:
    """Count a component."""
    ctx.counts.components += 1
    return _fits(ctx, span, "the number of components", ctx.counts.components, MAX_COMPONENTS)


def another_call(ctx: Context, span: Span) -> bool:
    """Count a function that is expanded."""
    ctx.counts.calls += 1
    return _fits(ctx, span, "the number of expanded function calls", ctx.counts.calls, MAX_CALLS)


def _fits(ctx: Context, span: Span, what: str, count: int, most: int) -> bool:
    if count > most and what not in ctx.counts.exceeded:
        ctx.counts.exceeded.add(what)
        ctx.sink.report("E0326", span, what=what, most=most)
    return count <= most


def _frames_fit(ctx: Context, symbol: Symbol, shape: tuple[int, ...]) -> bool:
    """E0334 for an array of frames with a value that is not a frame for each element, in braces."""
    given = symbol.given.bindings
    if symbol.kind != "frame" or not shape or all(_is_within(key, shape) for key in given):
        return True
    found = "another value" if None in given else f"{len(given)} of them"
    wanted = f"{' by '.join(str(extent) for extent in shape)} frames in braces"
    ctx.sink.report("E0334", next(iter(given.values())).span, what=f"`{symbol.short}`", expected=wanted, found=found)
    return False


def _is_within(key: Indices | None, shape: tuple[int, ...]) -> bool:
    return key is not None and len(key) == len(shape) and all(i <= n for i, n in zip(key, shape, strict=True))
