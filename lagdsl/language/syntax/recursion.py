"""Room for recursion over trees as deep as `limits.MAX_DEPTH` allows."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from lagdsl.language.syntax.limits import MAX_DEPTH

_DEEPEST = 20 * MAX_DEPTH


@contextmanager
def deep_recursion(deepest: int = _DEEPEST) -> Iterator[None]:
    """Raise Python's recursion limit to `deepest` while the block runs."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, deepest))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
