"""Places in the text of the items of the flat model."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.flat.quantity import Item


def place(item: Item) -> Span | None:
    """The innermost span; None for items that were made without a text."""
    return item.spans[0] if item.spans else None


def around(item: Item) -> tuple[Label, ...]:
    """The components that hold the item, innermost first."""
    return tuple(Label(span, f"in component `{span.text}`") for span in item.spans[1:])
