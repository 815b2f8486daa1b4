"""Links and ports that close a loop."""

from __future__ import annotations

from dataclasses import field

from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import Span
from lagdsl.language.flat.model import FrameStep, Output
from lagdsl.language.semantics.assembly.net import Link, Port
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.values import FrameValue


@record()
class Place:
    """Fields that the rows of one closure share. `span` is the `connect` that closes the loop."""

    name: str
    joint: str | None
    loop: tuple[str, ...]
    span: Span
    spans: tuple[Span, ...]


@mutable_record()
class Cut:
    """A link that closes a loop. `computed`: its coordinates are to follow from the frames, by `equations`. `hidden` is
    the frame that stands for the end of the link in all that closes it, so that it can be released alone, `start` the
    one that stands for its base; `steps` lead from there to the end."""

    link: Link
    loop: tuple[str, ...]
    span: Span
    equations: tuple[Placed, ...]
    computed: bool
    start: str = ""
    hidden: str = ""
    steps: tuple[FrameStep, ...] = ()
    started: bool = False
    outputs: list[Output] = field(default_factory=list)

    @property
    def place(self) -> Place:
        joint, binding = self.link.instance.name, self.link.binding
        return Place(f"closure({joint})", joint, self.loop, self.span, (binding.span, *binding.scope.spans))


@record()
class Tied:
    """A port with a place of its own, joined to frames that have theirs: both must be one."""

    port: int
    loop: tuple[str, ...]
    span: Span


class ReadAs:
    """Reads a port as another frame while texts of the closure are elaborated."""

    def __init__(self, port: Port, name: str) -> None:
        self._port, self._name = port, name

    def __enter__(self) -> None:
        if self._port.symbol is None:
            return
        self._before = self._port.symbol.made.cells[self._port.indices]
        self._port.symbol.made.cells[self._port.indices] = FrameValue(self._name)

    def __exit__(self, *_: object) -> None:
        if self._port.symbol is None:
            return
        self._port.symbol.made.cells[self._port.indices] = self._before
