"""Loops of a net: what closes them, and which components lie around them."""

from __future__ import annotations

from lagdsl.foundation.source import Span
from lagdsl.language.semantics.assembly.cuts import Cut, Tied
from lagdsl.language.semantics.assembly.graph import Step, Tree
from lagdsl.language.semantics.assembly.net import Link, Net
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.scope import Instance


class Loops:
    """Finds the way around the loops of a spanning tree."""

    def __init__(self, net: Net, tree: Tree) -> None:
        self._net, self._tree = net, tree
        self._steps = {step.node: step for step in tree.steps}
        self._depths: dict[int, int] = {}
        for step in tree.steps:
            before = self._before(step)
            self._depths[step.node] = self._depths[before] + 1 if before is not None else 0

    def cuts(self, equations: dict[Instance, list[Placed]], computed: list[bool]) -> list[Cut]:
        """The links that close a loop, in the order of the text."""
        found = []
        for number in self._tree.cuts:
            link = self._net.links[number]
            loop = self._around(self._net.root(link.base), self._net.root(link.child), link.instance.name)
            given = tuple(equations.get(link.instance, ()))
            found.append(Cut(link, loop, self._span(link), given, computed[number]))
        return found

    def ties(self) -> list[Tied]:
        """Ports with a place of their own that were joined to others that have one."""
        return [
            Tied(self._net.placed[number].port, (), self._net.spans[self._net.placed[number].port])
            for number in self._tree.redundant_edges
        ]

    def _span(self, link: Link) -> Span:
        """The `connect` that closes the loop: the one at the far end of the joint."""
        spans = self._net.spans
        return spans.get(link.child) or spans.get(link.base) or link.binding.span

    def _before(self, step: Step) -> int | None:
        if step.edge is None:
            return None
        link = self._net.links[step.edge]
        return self._net.root(link.child if step.backward else link.base)

    def _around(self, base: int, end: int, joint: str) -> tuple[str, ...]:
        """The components from where the two ways part, over one way to the joint and back over the other."""
        out: list[str] = []
        back: list[str] = []
        while base != end:
            if self._depths[base] == self._depths[end] == 0:
                break
            if self._depths[base] >= self._depths[end]:
                base = self._climb(base, out)
            else:
                end = self._climb(end, back)
        return (*reversed(out), joint, *back)

    def _climb(self, node: int, names: list[str]) -> int:
        step = self._steps[node]
        before = self._before(step)
        assert before is not None
        assert step.edge is not None
        names.append(self._net.links[step.edge].instance.name)
        return before
