"""Room for recursion over trees as deep as `limits.MAX_DEPTH` allows."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from lagdsl.syntax.limits import MAX_DEPTH

_FRAMES_PER_LEVEL = 10


@contextmanager
def deep_recursion() -> Iterator[None]:
    """Raise Python's recursion limit while the block runs."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, _FRAMES_PER_LEVEL * MAX_DEPTH))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
