"""XML as text: elements with attributes, in the order in which they are given."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import assert_never
from xml.etree import ElementTree

from lagdsl.exchange.fmi.variables.scalar import Type

Element = ElementTree.Element
Value = str | int | float | bool | None

# Characters that XML 1.0 cannot contain.
_IMPOSSIBLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def element(tag: str, parent: Element | None = None, **attributes: Value) -> Element:
    """A new last child of `parent`. Attributes that are None are left out; `_` behind a name is not part of it."""
    given = {name.rstrip("_"): text(value) for name, value in attributes.items() if value is not None}
    return Element(tag, given) if parent is None else ElementTree.SubElement(parent, tag, given)


def text(value: str | float | bool) -> str:
    """As XML Schema writes booleans and doubles; of texts what XML can hold."""
    match value:
        case bool():
            return "true" if value else "false"
        case int():
            return str(value)
        case float():
            return number(value)
        case str():
            return _IMPOSSIBLE.sub("\N{REPLACEMENT CHARACTER}", value)
        case _:
            assert_never(value)


def number(value: float) -> str:
    """Reads back as the same number."""
    if math.isnan(value):
        return "NaN"
    return repr(value) if math.isfinite(value) else "INF" if value > 0 else "-INF"


def start_text(kind: Type, values: Sequence[float | str]) -> str | None:
    """Start values of one variable, with blanks between; None without. Start values of Strings are elements of their
    own."""
    if not values:
        return None
    match kind:
        case "REAL":
            return " ".join(number(float(value)) for value in values)
        case "INTEGER" | "ENUMERATION":
            return " ".join(str(int(value)) for value in values)
        case "BOOLEAN":
            return " ".join(text(bool(value)) for value in values)
        case "STRING":
            return str(values[0])
        case "CLOCK":
            return None


def one_line(value: str) -> str:
    """A text without line ends and tabs, as names of XML must be."""
    return re.sub(r"\s+", " ", value).strip()


def document(root: Element) -> str:
    """The whole file."""
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"
