"""Modifiers of arrays of components: values are split over the elements unless `each` stands there."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeAlias, assert_never

from lagdsl.language.semantics.classes.modification import Given
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import each_help
from lagdsl.language.semantics.scope.scope import Indices, Scope
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Component,
    FrameValue,
    Poison,
    Reaction,
    Scalar,
    Text,
    Vector,
)
from lagdsl.language.syntax import nodes

# A modifier of an array of components with its scope and, if it is of one element, the subscripts of that.
Said: TypeAlias = "tuple[tuple[nodes.Subscript, ...], nodes.AnyModifier, Scope]"


class Splits:
    """Modifiers of an array of components (or, with the shape (), of one), innermost first."""

    def __init__(self, ctx: Context, name: str, shape: Indices, said: list[Said]) -> None:
        self.ctx = ctx
        self.name = name
        self.shape = shape
        self.said: list[tuple[Indices | None, nodes.AnyModifier, Scope]] = []
        for subscripts, modifier, scope in said:
            indices = self._indices(subscripts, scope) if subscripts else None
            if indices is not None or not subscripts:
                self.said.append((indices, modifier, scope))
            if shape and not subscripts:
                self._note(modifier, scope)

    def at(self, indices: Indices) -> list[Given]:
        """The modifiers of one element."""
        return [
            (modifier if own is not None else _split(modifier, indices), scope)
            for own, modifier, scope in self.said
            if own is None or own == indices
        ]

    def _indices(self, subscripts: tuple[nodes.Subscript, ...], scope: Scope) -> Indices | None:
        if len(subscripts) != len(self.shape):
            rank = len(self.shape)
            what = f"an array with {rank} subscript{'s' if rank > 1 else ''}" if rank else "a single component"
            self.ctx.sink.report("E0237", subscripts[0].span, name=self.name, what=what)
            return None
        found: list[int] = []
        for subscript, extent in zip(subscripts, self.shape, strict=True):
            if isinstance(subscript, nodes.All | nodes.Range):
                self.ctx.sink.report("E0312", subscript.span, expected="one index", found="a range")
                return None
            value = self.ctx.elaborate(self.ctx, scope, subscript, False)
            number = structural_integer(self.ctx, value, subscript, "E0333")
            if number is None:
                return None
            if not 1 <= number <= extent:
                self.ctx.sink.report("E0316", subscript.span, index=number, extent=extent)
                return None
            found.append(number)
        return tuple(found)

    def _note(self, modifier: nodes.AnyModifier, scope: Scope) -> None:
        """Sizes are checked when everything has its name."""
        if isinstance(modifier, nodes.Modifier) and "each" in modifier.prefixes:
            return
        for nested in modifier.modifiers:
            self._note(nested, scope)
        if isinstance(modifier, nodes.Modifier) and modifier.value is not None:
            self.ctx.splits.modifiers.append((modifier, self.shape, scope))


def _split(modifier: nodes.AnyModifier, indices: Indices) -> nodes.AnyModifier:
    if not indices:
        return modifier
    if not isinstance(modifier, nodes.Modifier):
        return replace(modifier, modifiers=tuple(_split(nested, indices) for nested in modifier.modifiers))
    if "each" in modifier.prefixes:
        return replace(modifier, prefixes=tuple(prefix for prefix in modifier.prefixes if prefix != "each"))
    inner = tuple(_split(nested, indices) for nested in modifier.modifiers)
    value = None if modifier.value is None else _element(modifier.value, indices)
    return replace(modifier, modifiers=inner, value=value)


def _element(value: nodes.Expression, indices: Indices) -> nodes.Expression:
    """`value[indices]`, taken apart here where the text lists its elements."""
    while indices and isinstance(value, nodes.Array) and 1 <= indices[0] <= len(value.elements):
        value, indices = value.elements[indices[0] - 1], indices[1:]
    if not indices:
        return value
    subscripts = tuple(nodes.Number(span=value.span, text=str(index)) for index in indices)
    return nodes.Index(span=value.span, target=value, subscripts=subscripts)


def check_splits(ctx: Context) -> None:
    """E0234 and E0335 for values that do not fit the array of components they are given to.

    Their elements are not looked at again.
    """
    for modifier, shape, scope in ctx.splits.modifiers:
        assert modifier.value is not None
        name = modifier.name.span.text
        with ctx.current.inside(scope):
            found = _leading(ctx, scope, modifier.value, len(shape))
            if found is None or found == shape:
                continue
            ctx.splits.values[scope, id(modifier.value)] = POISON
            if found == ():
                text = modifier.span.text
                ctx.sink.report("E0335", modifier.span, text=text, help=each_help(text))
                continue
            shown, wanted = (" by ".join(str(extent) for extent in extents) for extents in (found, shape))
            ctx.sink.report("E0234", modifier.value.span, name=name, found=shown, count=wanted)


def _leading(ctx: Context, scope: Scope, value: nodes.Expression, rank: int) -> Indices | None:
    """The first extents of the value; None where it has none that can be told."""
    if isinstance(value, nodes.Array):
        inner = {_leading(ctx, scope, part, rank - 1) for part in value.elements} if rank > 1 else {()}
        return (len(value.elements), *(inner.pop() or ())) if len(inner) == 1 else None
    found = ctx.elaborate(ctx, scope, value, True)
    match found:
        case Poison():
            ctx.splits.values[scope, id(value)] = POISON
            return None
        case Array():
            ctx.splits.values[scope, id(value)] = found  # else every component would make the whole of it
            return found.shape[:rank]
        case Vector():
            return (3,)
        case Scalar() | FrameValue() | Text() | Reaction():
            return ()
        case Component():
            return None
        case _:
            assert_never(found)
