"""Order of preference of links for the spanning tree, lowest first; the others are cut."""

from __future__ import annotations

from enum import IntEnum
from typing import Literal

from lagdsl.language.semantics.assembly.net import Link, Net
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Symbol
from lagdsl.language.semantics.scope.values import Text
from lagdsl.language.semantics.variables.attributes import attributes, flags
from lagdsl.language.syntax import nodes


class Preference(IntEnum):
    """RIGID links carry no coordinate. KEPT are joints that can only be cut with their coordinates kept, STARTED those
    whose start the user wrote: an unknown more."""

    RIGID = 0
    ALWAYS = 1
    FIXED = 2
    KEPT = 3
    STARTED = 4
    PLAIN = 5
    NEVER = 6


_STARTS = ("start", "der.start", "omega.start")
_FIXED = ("fixed", "der.fixed", "omega.fixed")


def preference(ctx: Context, link: Link, *, solvable: bool) -> Preference:
    """`solvable`: the coordinates of the link may follow from its frames without loss."""
    if not link.own:
        return Preference.RIGID
    wishes = {wish for symbol in link.own if (wish := wish_of(ctx, symbol)) is not None}
    if "always" in wishes:
        return Preference.ALWAYS
    if "never" in wishes:
        return Preference.NEVER
    if any(is_fixed(ctx, symbol) for symbol in link.own):
        return Preference.FIXED
    if not solvable:
        return Preference.KEPT
    if any(is_started(ctx, symbol) for symbol in link.own):
        return Preference.STARTED
    return Preference.PLAIN


def is_fixed(ctx: Context, symbol: Symbol) -> bool:
    found = attributes(ctx, symbol)
    shape = ctx.resolver.shape(ctx, symbol) or ()
    return any(any(flags(ctx, found.get(name), "`fixed`", shape)) for name in _FIXED)


def is_started(ctx: Context, symbol: Symbol) -> bool:
    """True if a start of the coordinate or of its rate is written: the search for a start has to know it."""
    found = attributes(ctx, symbol)
    return any(name in found for name in _STARTS)


def wish_of(ctx: Context, symbol: Symbol) -> Literal["always", "never"] | None:
    """The attribute `prefer`; E0708 for another value."""
    attribute = attributes(ctx, symbol).get("prefer")
    if attribute is None:
        return None
    node = attribute.value
    word = node.name if isinstance(node, nodes.Reference) else None
    if word is None:
        value = ctx.elaborate(ctx, attribute.scope, node, False)
        word = value.value if isinstance(value, Text) else node.span.text
    if word == "always":
        return "always"
    if word == "never":
        return "never"
    ctx.sink.report("E0708", node.span, found=word)
    return None


def preferences(ctx: Context, net: Net, solvable: list[bool]) -> list[Preference]:
    """Preference of every link for the spanning tree."""
    return [preference(ctx, link, solvable=able) for link, able in zip(net.links, solvable, strict=True)]
