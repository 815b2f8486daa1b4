"""Names of other files as names of the language."""

from __future__ import annotations

import re
import unicodedata

from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES

_WORDS = "end if then elseif else for loop when elsewhen equation and or not true false in world time der Lag"
TAKEN = frozenset([*_WORDS.split(), *TYPES, *CONSTANTS])
"""Words that no part of a model may have for its name."""
_LONGEST = 150


def identifier(original: str, kind: str) -> str:
    """ASCII letters, digits and `_`, as the language has them, with the look of the original."""
    letters = unicodedata.normalize("NFKD", original).encode("ascii", "ignore").decode("ascii")
    plain = re.sub(r"[^A-Za-z0-9_]", "_", letters)[:_LONGEST]
    if not re.search(r"[A-Za-z0-9]", plain):
        return kind
    return plain if not plain[0].isdigit() else f"{kind}_{plain}"


def model_name(original: str, kind: str) -> str:
    """`my-first robot` becomes `MyFirstRobot`."""
    words = re.findall(r"[A-Za-z0-9]+", identifier(original, kind))
    return "".join(word[:1].upper() + word[1:] for word in words)[:_LONGEST]
