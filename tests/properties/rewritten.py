"""Texts that say the same in another way: a stranger beside it, other order, other names, a class around it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from lagdsl.diagnostics import Sink
from lagdsl.pipeline import read
from lagdsl.syntax import nodes
from lagdsl.syntax.parser import parse


@dataclass(frozen=True)
class Source:
    """A text and its last class, which is the model."""

    text: str
    model: nodes.Class

    @property
    def unitless(self) -> bool:
        return 'units = "none"' in self.text


def source(path: Path) -> Source:
    sink = Sink()
    file = read(path, sink)
    assert file is not None
    unit = parse(file, sink)
    assert unit is not None
    model = [item for item in unit.items if isinstance(item, nodes.Class)][-1]
    return Source(file.text, model)


def with_stranger(s: Source, start: float, rate: float, mass: float) -> str:
    """A coordinate beside it that nothing couples to it, first of all."""
    kind, unit = ("Real", "") if s.unitless else ("Length", " kg")
    added = (
        f"coordinate {kind} stranger(start = {start!r}, der(start = {rate!r}));\n"
        f"  kinetic 1/2*({mass!r}{unit})*der(stranger)^2;\n  "
    )
    at = s.model.items[0].span.start
    return s.text[:at] + added + s.text[at:]


def reordered(s: Source) -> str:
    """Its statements from the last to the first; components and what joins them stay in their order, from which merged
    coordinates have their names and `connect` its frames, and come last."""
    items = s.model.items
    joined = [item for item in items if isinstance(item, nodes.Component | nodes.Connect | nodes.For | nodes.If)]
    others = [item for item in reversed(items) if item not in joined]
    text = "\n  ".join(item.span.text for item in (*others, *joined))
    return s.text[: items[0].span.start] + text + s.text[items[-1].span.end :]


def wrapped(s: Source) -> str:
    """An instance of it in another model."""
    return f"{s.text}\nmodel Around\n  {s.model.name} inner;\nend Around;\n"
