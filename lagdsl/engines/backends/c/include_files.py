"""Headers that C files read: what has to be compiled again when one of them changes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"]+)"', re.MULTILINE)


def included(texts: Iterable[str], text_of: Callable[[str], str | None]) -> dict[str, str]:
    """The headers that C `texts` include, directly and through others: text by name as it is written, sorted.

    `text_of` gives the text of a header, or None where it is not to be followed.
    """
    found: dict[str, str] = {}
    waiting = list(texts)
    while waiting:
        for name in _INCLUDE.findall(waiting.pop()):
            text = None if name in found else text_of(name)
            if text is not None:
                found[name] = text
                waiting.append(text)
    return dict(sorted(found.items()))
