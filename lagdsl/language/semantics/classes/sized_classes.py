"""Classes that stand for several components: `model Wheels = Wheel[4](each m = 2 kg);`."""

from __future__ import annotations

from lagdsl.foundation.record import record
from lagdsl.language.semantics.classes.array_modifiers import Splits
from lagdsl.language.semantics.classes.inheritance import Step
from lagdsl.language.semantics.classes.modification import Given, check_duplicates
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Indices, Scope
from lagdsl.language.syntax import nodes


@record()
class Sized:
    """The sizes that short classes give, those of the outermost first, and their modifiers, innermost first.

    Modifiers of a class are split over its own sizes and those of the classes inside.
    """

    shape: Indices
    splits: list[tuple[int, Splits]]

    def at(self, indices: Indices) -> list[Given]:
        """The modifiers of one element; `indices` may have those of the declaration before them."""
        return [
            given for rank, splits in self.splits for given in splits.at(indices[len(indices) - rank :] if rank else ())
        ]


def sized(ctx: Context, name: str, steps: list[Step]) -> Sized | None:
    """Sizes and modifiers of the short classes `steps`, outermost first; None after a diagnostic."""
    shape: Indices = ()
    splits: list[tuple[int, Splits]] = []
    for node, scope in reversed(steps):
        check_duplicates(ctx, node.modifiers)
        own = extents_of(ctx, node.name, node.subscripts, scope)
        if own is None:
            return None
        shape = (*own, *shape)
        splits.append((len(shape), Splits(ctx, name, shape, [((), modifier, scope) for modifier in node.modifiers])))
    return Sized(shape, splits)


def extents_of(ctx: Context, name: str, subscripts: tuple[nodes.Subscript, ...], scope: Scope) -> Indices | None:
    """The sizes of an array of components; None after a diagnostic."""
    extents: list[int] = []
    for subscript in subscripts:
        if isinstance(subscript, nodes.All | nodes.Range):
            ctx.sink.report("E0312", subscript.span, expected="a number of components", found="a range")
            return None
        value = ctx.elaborate(ctx, scope, subscript, False)
        extent = structural_integer(ctx, value, subscript, "E0301", name=subscript.span.text)
        if extent is not None and extent < 1:
            what = f"the size of `{name}`"
            ctx.sink.report("E0334", subscript.span, what=what, expected="positive", found=str(extent))
            return None
        if extent is None:
            return None
        extents.append(extent)
    return tuple(extents)
