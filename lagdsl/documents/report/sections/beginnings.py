"""The first row of a family that goes on with neighbours: it has the form of the others if an index 0 names nothing."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from lagdsl.documents.report.sections.families import INDICES

_ABSENT = re.compile(r"[A-Za-z_][\w.\[\]]*\[(?:\d+,)*0(?:,\d+)*\]")
_SIGN = re.compile(r" [+-] $")


def with_beginnings(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """`a[1]: x[1]` before `a[2]: x[2] - x[1]` and `a[3]: x[3] - x[2]` is `x[1] - x[0]`, which is the same where `x[0]`
    is zero."""
    places = {row[0]: place for place, row in enumerate(rows)}
    found = list(rows)
    for place, row in enumerate(rows):
        for second, third in _following(row[0]):
            if second in places and third in places:
                guess = _before(rows[places[second]], rows[places[third]])
                if guess is not None and (guess[0], *map(without_absent, guess[1:])) == row:
                    found[place] = guess
                    break
    return found


def _following(name: str) -> list[tuple[str, str]]:
    """Names with 2 and 3 in the places of an index 1, of one or of all."""
    ones = [found.span() for found in INDICES.finditer(name) if found[0] == "1"]
    return [
        (_replaced(name, spans, "2"), _replaced(name, spans, "3"))
        for spans in ([[each] for each in ones] + ([ones] if len(ones) > 1 else []))
    ]


def _replaced(name: str, spans: Sequence[tuple[int, int]], index: str) -> str:
    for start, end in reversed(spans):
        name = name[:start] + index + name[end:]
    return name


def _before(second: tuple[str, ...], third: tuple[str, ...]) -> tuple[str, ...] | None:
    """The row before two that follow each other; None if it has no index 0."""
    cells = []
    for one, other in zip(second, third, strict=True):
        if INDICES.sub("#", one) != INDICES.sub("#", other):
            return None
        pairs = zip(INDICES.findall(one), INDICES.findall(other), strict=True)
        cells.append(_with_indices(one, [2 * int(a) - int(b) for a, b in pairs]))
    return tuple(cells) if any(map(_ABSENT.search, cells[1:])) else None


def _with_indices(cell: str, indices: Iterable[int]) -> str:
    following = iter(indices)
    return INDICES.sub(lambda _: str(next(following)), cell)


def without_absent(text: str) -> str | None:
    """The sum without terms with an index 0; None if one stands where zero is no zero term."""
    found: str | None = text
    while found is not None and (absent := _ABSENT.search(found)) is not None:
        found = _without(found, *absent.span())
    return found


def _without(text: str, start: int, end: int) -> str | None:
    """Without the term in which the factor from `start` to `end` is zero."""
    if text[:start].endswith("/"):
        return None
    left, right = _edge(text, start - 1, -1), _edge(text, end, 1)
    after, before = text[right : right + 1], text[left - 1 : left]
    if after == "," or before == ",":
        return None
    signed = _SIGN.search(text[:left])
    if not signed and after in ("", ")"):  # the only term
        if not before:
            return "0"
        if text[: left - 1].endswith("der"):
            return _without(text, left - 4, right + 1)
        return None if re.search(r"\w$", text[: left - 1]) else _without(text, left - 1, right + 1)
    rest = text[:left].removesuffix(signed[0]) + text[right:] if signed else text[:left] + _opened(text[right:])
    return _unbracketed(rest, left - (3 if signed else 0))


def _opened(rest: str) -> str:
    return rest[3:] if rest.startswith(" + ") else f"-{rest[3:]}"


def _edge(text: str, at: int, step: int) -> int:
    """The end of the term: a sign between spaces, a comma or the bracket around it."""
    depth, opening, closing = 0, "([{", ")]}"
    if step < 0:
        opening, closing = closing, opening
    while 0 <= at < len(text):
        depth += (text[at] in opening) - (text[at] in closing)
        if depth < 0 or (depth == 0 and (text[at] == "," or text[at - 1 : at + 2] in (" + ", " - "))):
            break
        at += step
    signed = text[at - 1 : at + 2] in (" + ", " - ")
    return (at + 2 if signed else at + 1) if step < 0 else (at - 1 if signed else at)


def _unbracketed(text: str, inside: int) -> str:
    """Without brackets around a single term that is a factor."""
    left, right = inside, inside
    depth = 0
    while left > 0 and not (text[left - 1] == "(" and depth == 0):
        depth += (text[left - 1] == ")") - (text[left - 1] == "(")
        left -= 1
    if left == 0 or not text[: left - 1].endswith("*"):
        return text
    right = _edge(text, left, 1)
    single = text[right : right + 1] == ")" and "/" not in text[right + 1 : right + 2]
    return text[: left - 1] + text[left:right] + text[right + 1 :] if single else text
