"""From components and their connections to frames, coordinates and closures."""

from __future__ import annotations

from lagdsl.semantics.contents import Contents
from lagdsl.semantics.context import Context
from lagdsl.semantics.flat_model import Joint
from lagdsl.semantics.scope import Instance


def assemble(ctx: Context, root: Instance, contents: Contents) -> tuple[Joint, ...]:
    """Give every frame without a binding its place; the joints of the model, in the order of the text.

    Called when all names, modifiers and items are known and nothing is elaborated yet.
    """
    for placed in (*contents.connects, *contents.kinematics, *contents.closure):
        what = type(placed.node).__name__.lower()
        ctx.sink.report("E0311", placed.node.span, what=f"this {what}", hint="joints come with components")
    return ()
