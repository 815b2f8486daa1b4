"""Rows of a table that repeat with an index, as one row."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import prod

_INDICES = re.compile(r"(?<=\[)\d+(?:,\d+)*(?=\])")
_LETTERS = "kjil"


def rolled(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """Rows that differ by indices alone as one, with `[k]`, `[k-1]`, `[k,j]` and the ranges of the letters in the first
    cell, in the order of the first of them. Indices that keep their distance have one letter."""
    found: dict[tuple[str, ...], list[tuple[tuple[int, ...], tuple[str, ...]]]] = {}
    for row in rows:
        indices = tuple(int(n) for cell in row for match in _INDICES.findall(cell) for n in match.split(","))
        pattern = tuple(_INDICES.sub(lambda match: ",".join("#" for _ in match[0].split(",")), cell) for cell in row)
        found.setdefault(pattern, []).append((indices, row))
    return [shown for pattern, members in found.items() for shown in _family(pattern, members)]


def _family(
    pattern: tuple[str, ...], members: Sequence[tuple[tuple[int, ...], tuple[str, ...]]]
) -> list[tuple[str, ...]]:
    """One row, or one for each choice of the second letter where the letters do not take all values together."""
    if len(members) == 1:
        return [members[0][1]]
    columns = list(zip(*(indices for indices, _ in members), strict=True))
    letters: list[tuple[int, ...]] = []
    places: list[str] = []
    for column in columns:
        if len(set(column)) == 1:
            places.append(str(column[0]))
            continue
        known = [(each, column[0] - of[0]) for each, of in enumerate(letters) if _keeps_distance(column, of)]
        if not known:
            letters.append(column)
            known = [(len(letters) - 1, 0)]
        letter, distance = known[0]
        places.append(_LETTERS[letter % len(_LETTERS)] + (f"{distance:+d}" if distance else ""))
    ranges = [sorted(set(letter)) for letter in letters]
    if not letters:
        return [members[0][1]]
    if len(letters) > len(_LETTERS) or prod(map(len, ranges)) != len(set(zip(*letters, strict=True))):
        parts: dict[tuple[int, ...], list[tuple[tuple[int, ...], tuple[str, ...]]]] = {}
        for member, others in zip(members, zip(*letters[1:], strict=True), strict=True):
            parts.setdefault(others, []).append(member)
        return [shown for part in parts.values() for shown in _family(pattern, part)]
    text = iter(places)
    row = [re.sub("#", lambda _: next(text), cell) for cell in pattern]
    spans = [f"{name} = {_span(values)}" for name, values in zip(_LETTERS, ranges, strict=False)]
    return [(", ".join([row[0], *spans]), *row[1:])]


def _keeps_distance(column: Sequence[int], other: Sequence[int]) -> bool:
    return len({a - b for a, b in zip(column, other, strict=True)}) == 1


def _span(values: Sequence[int]) -> str:
    together = list(values) == list(range(values[0], values[-1] + 1))
    return f"{values[0]}…{values[-1]}" if together else ", ".join(map(str, values))
