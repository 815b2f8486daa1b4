"""Arrays by their name: `q` stands for `q[1]`, `q[2]`, and `link.m` for `link[1].m`, `link[2].m`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping

from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.language.settings.failure import SettingError, short
from lagdsl.language.settings.pieces import pieces_of

_SUBSCRIPT = re.compile(r"\[[^\[\]]*\]")
_COMMA = re.compile(r",(?![^\[(]*[\])])")
_BRACES = re.compile(r"\s*\{(.*)\}\s*([^{}]*?)\s*", re.DOTALL)


class UnknownColumn(KeyError):  # noqa: N818  it is the name that is wrong
    """A name that no column has; the text tells the nearest one.

    Built from the text and the name.
    """

    def __str__(self) -> str:
        return str(self.args[0])


def names_in(text: str) -> list[str]:
    """`c, I[1,2], theta.start` as names."""
    return [piece.strip() for piece in _COMMA.split(text) if piece.strip()]


def family(name: str, known: Iterable[str]) -> list[str]:
    """The elements of the array `name`, in their order; none where it is no array."""
    return [each for each in known if each != name and "[" in each and without_subscripts(each) == name]


def columns_among(names: Iterable[str], known: Collection[str]) -> list[str]:
    """The columns of these names, each once; an array stands for its elements. Raises UnknownColumn."""
    found: dict[str, None] = {}
    for name in names:
        elements = [name] if name in known else family(name, known)
        if not elements:
            hint = did_you_mean(name, known, f"there are {listing(name, known)}")
            raise UnknownColumn(f"there is no column `{name}`; {hint}", name)
        found |= dict.fromkeys(elements)
    return list(found)


def without_subscripts(name: str) -> str:
    return _SUBSCRIPT.sub("", name)


def spread(pairs: Mapping[str, str], known: Iterable[str]) -> dict[str, str]:
    """`q.start={10, 20} deg` as the assignments of its elements; all other assignments as they are. Raises
    SettingError for a number of values other than that of the elements."""
    names = list(known)
    found: dict[str, str] = {}
    for name, text in pairs.items():
        braces = _BRACES.fullmatch(text)
        if braces is None:
            found[name] = text
            continue
        elements = family(name, names)
        values = pieces_of(braces[1].replace("{", "").replace("}", ""), braces[2])
        if not elements:
            raise SettingError(f"{name}={short(text)}: `{name}` is no array")
        if len(values) != len(elements):
            raise SettingError(
                f"{name}={short(text)}: `{name}` has {len(elements)} elements ({elements[0]} to {elements[-1]}), "
                f"not {len(values)}"
            )
        found |= dict(zip(elements, values, strict=True))
    return found
