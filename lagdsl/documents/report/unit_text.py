"""Units of the language as people write them, and values with their units."""

from __future__ import annotations

import re

from lagdsl.foundation.units.naming import to_display
from lagdsl.language.flat.quantity import Quantity

_EXPONENT = re.compile(r"(?<=[A-Za-z])(-?\d+)")
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_LETTERS = re.compile(r"Ohm|degC")
_WRITTEN = {"Ohm": "Ω", "degC": "°C"}


def readable_unit(unit: str) -> str:
    """`kg.m2/s` as kg·m²/s; nothing for a number."""
    if unit == "1":
        return ""
    raised = _EXPONENT.sub(lambda found: found.group().translate(_RAISED), unit.replace(".", "·"))
    return _LETTERS.sub(lambda found: _WRITTEN[found.group()], raised)


def unit_of(item: Quantity) -> str:
    return readable_unit(item.unit)


def value_and_unit(value: float, item: Quantity) -> tuple[str, str]:
    """The value of a quantity in the unit that the model shows it in, and this unit."""
    return f"{to_display(value, item.display_unit):.6g}", readable_unit(item.display_unit or item.unit)
