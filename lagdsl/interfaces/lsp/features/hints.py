"""Hints inside the text: degrees of freedom, redundant rows, units of results without a type of their own."""

from __future__ import annotations

import re
from collections.abc import Iterator

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.deep import Depth
from lagdsl.interfaces.lsp.positions import position_at
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.flat.quantity import Quantity
from lagdsl.language.syntax import nodes

_FREEDOM = re.compile(r"= (\d+ degrees? of freedom)")


def hints(snapshot: Snapshot, depth: Depth | None) -> list[lsp.InlayHint]:
    """Hints of the whole text; `depth` is what is known of the model behind the equations."""
    return [*_freedom(snapshot, depth), *_redundant(snapshot, depth), *_units(snapshot)]


def _hint(snapshot: Snapshot, offset: int, text: str, tooltip: str) -> lsp.InlayHint:
    return lsp.InlayHint(position_at(snapshot.file, offset), text, padding_left=True, tooltip=tooltip)


def _freedom(snapshot: Snapshot, depth: Depth | None) -> Iterator[lsp.InlayHint]:
    found = _FREEDOM.search(depth.freedom) if depth is not None and depth.freedom is not None else None
    for item in snapshot.unit.items if snapshot.unit is not None else ():
        if found is not None and depth is not None and isinstance(item, nodes.Class) and item.name == depth.model:
            yield _hint(snapshot, item.name_span.end, found[1], depth.freedom or "")


def _redundant(snapshot: Snapshot, depth: Depth | None) -> Iterator[lsp.InlayHint]:
    for start, count in depth.redundant if depth is not None else ():
        if snapshot.text.startswith("connect", start):
            rows = "1 redundant row" if count == 1 else f"{count} redundant rows"
            yield _hint(snapshot, start + len("connect"), rows, "closure equations that follow from the others")


def _units(snapshot: Snapshot) -> Iterator[lsp.InlayHint]:
    """`[N.m]` after a name of type `Real` whose value has a dimension."""
    for flat in snapshot.flats.values():
        named = [*flat.outputs, *flat.parameters, *(each for each in flat.named if isinstance(each, Quantity))]
        for each in named:
            own = each.spans[0]
            is_own = len(each.spans) == 1 and own.file is snapshot.file and own.text == each.name
            if is_own and each.type_name == "Real" and each.unit != "1":
                yield _hint(snapshot, own.end, f"[{each.unit}]", "the unit that follows from the value")
