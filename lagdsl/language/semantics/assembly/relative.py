"""A loop seen from where its two ways part.

Both ends of a cut joint hang on one frame, their lowest common ancestor. The conditions between them do not depend on
where that ancestor is; written with frames of the world they would mention every coordinate on the way to it all the
same. So the frames of the loop are copied onto the world, step by step, as if the ancestor were the world.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.model import Frame, FrameStep, Image, Move, Rotate, RotateAbout, RotateQuaternion
from lagdsl.language.flat.traversal import postorder, step_expressions
from lagdsl.language.semantics.assembly.net import Link, Net
from lagdsl.language.semantics.assembly.paths import Element, World, target_of
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import children

Maker = Callable[[str, tuple[FrameStep, ...], Image], str]
_OWN = (Move, Rotate, RotateAbout, RotateQuaternion)
_INNER = (
    flat.Number,
    flat.Variable,
    flat.Unary,
    flat.Binary,
    flat.Function,
    flat.Conditional,
    flat.Derivative,
)


class Ancestry:
    """Parents of the frames made so far."""

    def __init__(self, ctx: Context) -> None:
        self._ctx = ctx
        self._frames: dict[str, Frame] = {}
        self._depths = {"world": 0}
        self._seen = 0

    def copied(self, base: str, end: str, make: Maker) -> tuple[str, str, str | None]:
        """Copies of both frames and the ancestor they are seen from; the frames themselves and None where that is the
        world, or where a frame between is placed otherwise than by own displacements and turns."""
        self._update()
        down: list[list[Frame]] = [[], []]
        ends = [base, end]
        while ends[0] != ends[1]:
            side = 0 if self._depths[ends[0]] >= self._depths[ends[1]] else 1
            frame = self._frames[ends[side]]
            if not is_relative(frame.steps):
                return base, end, None
            down[side].append(frame)
            ends[side] = frame.parent
        ancestor = ends[0]
        if ancestor == "world":
            return base, end, None
        names = ["world", "world"]
        for side in (0, 1):
            for frame in reversed(down[side]):
                names[side] = make(names[side], frame.steps, Image(of=frame.name, within=ancestor))
        return names[0], names[1], ancestor

    def _update(self) -> None:
        for item in self._ctx.product.named[self._seen :]:
            if isinstance(item, Frame):
                self._frames[item.name] = item
                self._depths[item.name] = self._depths[item.parent] + 1
        self._seen = len(self._ctx.product.named)


def is_relative(steps: Iterable[FrameStep]) -> bool:
    """True if steps say the same wherever their frame is: own displacements and turns by scalars."""
    return all(
        isinstance(step, _OWN)
        and all(isinstance(node, _INNER) for part in step_expressions(step) for node in postorder(part))
        for step in steps
    )


def speaks_of_its_frames(ctx: Context, net: Net, link: Link, equations: Iterable[Placed]) -> bool:
    """True if closure equations mention nothing but the two frames of the link, its coordinates and parameters."""
    ports = {(port.symbol, port.indices) for port in (net.ports[link.base], net.ports[link.child])}
    stack: list[tuple[Placed, nodes.Node]] = [(placed, placed.node) for placed in equations]
    while stack:
        placed, node = stack.pop()
        target = None
        if isinstance(node, nodes.Reference | nodes.Member | nodes.Index):
            target = target_of(ctx, placed.scope, node)
        if isinstance(target, World):
            return False
        if not isinstance(target, Element):
            stack.extend((placed, child) for child in children(node))
            continue
        known = target.symbol.kind in ("parameter", "structural", "constant") or target.symbol in link.own
        if not known and (target.symbol, target.indices) not in ports:
            return False
    return True
