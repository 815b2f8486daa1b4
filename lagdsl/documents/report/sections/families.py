"""Rows of a table that repeat with an index, as one row."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import prod
from typing import NamedTuple

INDICES = re.compile(r"(?<=[\[,])\d+(?=[,\]])")
NUMBERS = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.\]])")
_PLACES = re.compile("[#~]")
_WORDS = re.compile(r"[A-Za-z_]\w*\[\d+\]|[A-Za-z_]\w*|\d+|\S")
_LETTERS = "kjil"


class _Member(NamedTuple):
    indices: tuple[int, ...]
    numbers: tuple[str, ...]
    row: tuple[str, ...]


def rolled(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """Rows that differ by indices and numbers alone as one, with `[k]`, `[k-1]`, `[k,j]` and the ranges of the letters
    in the first cell, in the order of the first of them. Indices that keep their distance have one letter. Numbers that
    follow an index are a list, `{0.5, 2}[k]`."""
    found: dict[tuple[str, ...], list[_Member]] = {}
    for row in rows:
        indices = tuple(int(each) for cell in row for each in INDICES.findall(cell))
        plain = tuple(INDICES.sub("#", cell) for cell in row)
        numbers = tuple(each for cell in plain for each in NUMBERS.findall(cell))
        pattern = tuple(NUMBERS.sub("~", cell) for cell in plain)
        found.setdefault(pattern, []).append(_Member(indices, numbers, row))
    return [shown for pattern, members in found.items() for shown in _family(pattern, members)]


def with_likes(rows: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Names and values; a value that has the form of the one before, with other names, says so where that is shorter:
    `as x[k] with y for x`."""
    found: list[tuple[str, str]] = []
    last: tuple[str, str] | None = None
    for name, value in rows:
        others = None if last is None else _others(last[1], value)
        told = value if last is None or not others else f"as {last[0]} with {', '.join(others)}"
        if len(told) < len(value):
            found.append((name, told))
        else:
            found.append((name, value))
            last = (name, value)
    return found


def _others(value: str, other: str) -> list[str]:
    """`b for a` for the names that differ; none if the values have different forms."""
    words, theirs = _WORDS.findall(value), _WORDS.findall(other)
    if len(words) != len(theirs):
        return []
    pairs = dict(zip(words, theirs, strict=True))
    if [pairs[word] for word in words] != theirs or len(set(pairs.values())) < len(pairs):
        return []
    differing = [(word, their) for word, their in pairs.items() if word != their]
    return [f"{their} for {word}" for word, their in differing] if all(w[0].isalpha() for w, _ in differing) else []


def _family(pattern: tuple[str, ...], members: Sequence[_Member]) -> list[tuple[str, ...]]:
    """One row, or one for each choice of the second letter where the letters do not take all values together."""
    if len(members) == 1:
        return [members[0].row]
    columns = list(zip(*(member.indices for member in members), strict=True))
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
    lists = [_list(column, letters) for column in zip(*(member.numbers for member in members), strict=True)]
    if "" in lists:
        return _parts(pattern, members, [member.numbers for member in members])
    if not letters:
        return [members[0].row]
    if len(letters) > len(_LETTERS) or prod(map(len, ranges)) != len(set(zip(*letters, strict=True))):
        return _parts(pattern, members, list(zip(*letters[1:], strict=True)))
    indices, numbers = iter(places), iter(lists)
    row = [_PLACES.sub(lambda place: next(indices if place[0] == "#" else numbers), cell) for cell in pattern]
    spans = [f"{name} = {_span(values)}" for name, values in zip(_LETTERS, ranges, strict=False)]
    return [(", ".join([row[0], *spans]), *row[1:])]


def _parts(
    pattern: tuple[str, ...], members: Sequence[_Member], keys: Sequence[tuple[object, ...]]
) -> list[tuple[str, ...]]:
    parts: dict[tuple[object, ...], list[_Member]] = {}
    for member, key in zip(members, keys, strict=True):
        parts.setdefault(key, []).append(member)
    return [shown for part in parts.values() for shown in _family(pattern, part)]


def _list(numbers: Sequence[str], letters: Sequence[tuple[int, ...]]) -> str:
    """The number of all rows, or a list by the letter that it follows; "" if there is none."""
    if len(set(numbers)) == 1:
        return numbers[0]
    for name, letter in zip(_LETTERS, letters, strict=False):
        values = dict(zip(letter, numbers, strict=True))
        first = min(values)
        if [*sorted(values)] == [*range(first, first + len(values))] and all(
            values[index] == number for index, number in zip(letter, numbers, strict=True)
        ):
            shift = f"{1 - first:+d}" if first != 1 else ""
            return f"{{{', '.join(values[index] for index in sorted(values))}}}[{name}{shift}]"
    return ""


def _keeps_distance(column: Sequence[int], other: Sequence[int]) -> bool:
    return len({a - b for a, b in zip(column, other, strict=True)}) == 1


def _span(values: Sequence[int]) -> str:
    together = list(values) == list(range(values[0], values[-1] + 1))
    return f"{values[0]}…{values[-1]}" if together else ", ".join(map(str, values))
