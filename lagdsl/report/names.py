"""Names of masses, bodies and loads in a report, from the model."""

from __future__ import annotations

from lagdsl.flat.expression import FrameOrigin, PointReference
from lagdsl.flat.model import FlatModel, PointMass
from lagdsl.flat.quantity import Item
from lagdsl.report.boxes import Box, Name, Number, Subscript, Upright
from lagdsl.report.notation import name_box
from lagdsl.report.unicode_math import line

_LONGEST_STATEMENT = 100


def statement(item: Item, otherwise: str) -> str:
    """The user's own words, in one line."""
    if not item.spans:
        return otherwise
    words = " ".join(item.spans[0].text.split())
    return words if len(words) <= _LONGEST_STATEMENT else words[: _LONGEST_STATEMENT - 1] + "…"


def carrier_labels(flat: FlatModel) -> list[Box]:
    """An index for every mass, then every body: its point or label if that is its alone, else its number."""
    names = [_point_name(mass) for mass in flat.masses] + [body.label or body.frame for body in flat.bodies]
    labels: list[Box] = []
    for number, name in enumerate(names, start=1):
        unique = name is not None and names.count(name) == 1
        labels.append(name_box(name) if unique and name is not None else Number(str(number)))
    return labels


def _point_name(mass: PointMass) -> str | None:
    place = mass.position
    if isinstance(place, PointReference):
        return place.name
    return place.frame if isinstance(place, FrameOrigin) else None


def indexed(letter: str, index: Box) -> Box:
    """`r` with an index; a word, or an index with an index of its own, is set upright."""
    if isinstance(index, Subscript) or (isinstance(index, Name) and len(index.text) > 1):
        return Subscript(Name(letter), Upright(line(index)))
    return Subscript(Name(letter), index)
