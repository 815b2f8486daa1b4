"""Coordinates of cut joints whose starts are set: the search for a start has to know them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from lagdsl.language.flat.model import FlatModel

_NAME = re.compile(r"(?:der\()?([^()\[\]]+)(?:\[[^\]]*\])*\)?(?:\[[^\]]*\])*")


def unknowns_of(flat: FlatModel, names: Iterable[str]) -> frozenset[str]:
    """Coordinates of `flat` that follow from others at present, without indices, among those whose starts have these
    names: `B.q.start`, `der(B.q)`, `ball.e[1].start`."""
    return coordinates_of(names) & coordinates_of(output.name for output in flat.outputs if output.joint is not None)


def coordinates_of(names: Iterable[str]) -> frozenset[str]:
    """The coordinates, without indices, of these if they are names of starts."""
    return frozenset(map(_coordinate, names))


def _coordinate(name: str) -> str:
    found = _NAME.fullmatch(name.removesuffix(".start"))
    return found.group(1) if found is not None else name
