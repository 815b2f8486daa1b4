"""Bodies of messages before they are decoded: Python's decoder of JSON recurses in C, for which Python's limit of
recursion is no bound here, as it is that of deep trees."""

from __future__ import annotations

import re
from typing import BinaryIO

MAX_LEVELS = 500
"""Lists and objects around one value. Messages of the protocol have about twenty."""
_TEXTS = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"?', re.DOTALL)  # one without an end is a text to the end
_BRACKETS = re.compile(rb"[\[{\]}]")
_OPENING = b"[{"
_NO_JSON = b"["


class Bodies:
    """Reads messages; a body that is nested too deeply reads as one that is not JSON."""

    def __init__(self, source: BinaryIO) -> None:
        self._source = source

    def readline(self) -> bytes:
        return self._source.readline()

    def read(self, size: int) -> bytes:
        body = self._source.read(size)
        return _NO_JSON if _is_too_deep(body) else body


def _is_too_deep(body: bytes) -> bool:
    if body.count(b"[") + body.count(b"{") <= MAX_LEVELS:
        return False
    level = 0
    for bracket in _BRACKETS.finditer(_TEXTS.sub(b"", body)):
        level += 1 if bracket.group() in _OPENING else -1
        if level > MAX_LEVELS:
            return True
    return False
