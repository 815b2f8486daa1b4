"""Names of the user as identifiers and comments of a target language: nothing of a model text is copied unescaped."""

from __future__ import annotations

import re
from collections.abc import Set


def identifier(name: str, reserved: Set[str]) -> str:
    """`name` with everything but ASCII letters, digits and `_` replaced; safe as file name and identifier."""
    text = re.sub(r"[^0-9A-Za-z_]", "_", name)[:64]
    if not text or not text[0].isalpha() or text.lower() in reserved:
        text = f"model_{text}"
    return text


def comment_text(text: str) -> str:
    """`text` for the inside of a comment: printable ASCII that cannot end it."""
    return re.sub(r"[^ 0-9A-Za-z_.:,\[\]()=+-]", "_", text)[:120]
