"""The form of the functions that make nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from lagdsl.source import Span

Action = Callable[[list[Any], Span], object]
"""Makes a node of the kept children of a rule and their span."""
