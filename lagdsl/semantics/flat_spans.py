"""Where an item of the flat model stands in the text."""

from __future__ import annotations

from lagdsl.semantics.flat_model import Item
from lagdsl.source import Span


def place(item: Item) -> Span | None:
    """The innermost span; None for items that were made without a text."""
    return item.spans[0] if item.spans else None
