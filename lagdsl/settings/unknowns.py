"""Coordinates of cut joints whose starts are set: the search for a start has to know them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from lagdsl.flat.model import FlatModel

_NAME = re.compile(r"(?:der\()?([^()\[\]]+)(?:\[[^\]]*\])*\)?(?:\[[^\]]*\])*")


def unknowns_of(flat: FlatModel, names: Iterable[str]) -> frozenset[str]:
    """Coordinates of `flat` that follow from others at present, without indices, among those whose starts have these
    names: `B.q.start`, `der(B.q)`, `ball.e[1].start`."""
    computed = {_coordinate(output.name) for output in flat.outputs if output.joint is not None}
    return frozenset(_coordinate(name) for name in names) & computed


def _coordinate(name: str) -> str:
    found = _NAME.fullmatch(name.removesuffix(".start"))
    return found.group(1) if found is not None else name
