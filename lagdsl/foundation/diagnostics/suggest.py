"""The nearest name: what the user may have meant.

Distance: Damerau-Levenshtein in its restricted form (optimal string alignment), where a swap of neighbours counts once;
F. J. Damerau, Communications of the ACM 7 (1964) 171.
"""

from __future__ import annotations

from collections.abc import Iterable

MOST_LISTED = 12
_LONGEST = 64  # names beyond it are compared for equality only: hostile input must not cost quadratic time


def distance(left: str, right: str, most: int | None = None) -> int:
    """Number of insertions, deletions, substitutions and swaps of neighbours between two names.

    Beyond `most` any greater number stands for it: most pairs of names are told apart by their first letters.
    """
    before: list[int] = []
    previous = list(range(len(right) + 1))
    least = 0
    for i, a in enumerate(left, 1):
        current = [i]
        for j, b in enumerate(right, 1):
            cost = min(previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (a != b))
            if i > 1 and j > 1 and a == right[j - 2] and left[i - 2] == b:
                cost = min(cost, before[j - 2] + 1)
            current.append(cost)
        passed, least = least, min(current)
        if most is not None and passed > most < least:  # a swap reaches back over one row
            return least
        before, previous = previous, current
    return previous[-1]


def nearest(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `name`, or None if none is likely meant.

    A name that differs only in case comes first. Otherwise one slip is allowed in names of up to four letters (the
    first letter must agree in names of two), two up to seven, three beyond. Of equally near ones the first of the
    alphabet wins, so the answer does not depend on the order of `candidates`.
    """
    if len(name) > _LONGEST:
        return None
    likely = [
        (slips, distance(name, candidate), candidate)
        for candidate in set(candidates)
        if _comparable(name, candidate)
        and (slips := distance(name.casefold(), candidate.casefold(), _allowed(name))) <= _allowed(name)
    ]
    return min(likely)[2] if likely else None


def listing(name: str, candidates: Iterable[str], form: str = "{}") -> str:
    """Twelve candidates at most, each in `form`, as `a, b and 5 more`; where there are more, those most like `name`
    first. `none` without any."""
    names = list(candidates)
    if len(names) > MOST_LISTED:
        asked = name[:_LONGEST].casefold()
        names.sort(key=lambda each: (distance(asked, each[:_LONGEST].casefold()), each))
    more = f" and {len(names) - MOST_LISTED} more" if len(names) > MOST_LISTED else ""
    return ", ".join(form.format(each) for each in names[:MOST_LISTED]) + more if names else "none"


class Proposal(str):
    """The help that proposes the name `meant` where `asked` is written."""

    asked: str
    meant: str

    def __new__(cls, text: str, asked: str, meant: str) -> Proposal:
        made = super().__new__(cls, text)
        made.asked, made.meant = asked, meant
        return made


def did_you_mean(name: str, candidates: Iterable[str], otherwise: str | None = None, *, mark: str = "") -> str | None:
    """The question for the nearest candidate, which is written after `mark`; `otherwise` where none is likely meant."""
    meant = nearest(name, candidates)
    return otherwise if meant is None else proposal(name, meant, mark)


def proposal(name: str, meant: str, mark: str = "") -> Proposal:
    """The question for `meant`, which is written after `mark`."""
    return Proposal(f"did you mean `{mark}{meant}`?", name, meant)


def _comparable(name: str, candidate: str) -> bool:
    close = len(candidate) <= _LONGEST and abs(len(candidate) - len(name)) <= _allowed(name)
    return close and candidate != name and _alike(name, candidate)


def _allowed(name: str) -> int:
    if len(name) <= 1:
        return 1
    return 1 if len(name) <= 4 else 2 if len(name) <= 7 else 3


def _alike(name: str, candidate: str) -> bool:
    """Very short names resemble everything: they must share their first letter, or differ in case only."""
    if min(len(name), len(candidate)) > 2 or name.casefold() == candidate.casefold():
        return True
    return len(name) > 1 and len(candidate) > 1 and name[0].casefold() == candidate[0].casefold()
