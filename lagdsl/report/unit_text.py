"""Units of the language as people write them."""

from __future__ import annotations

import re

EXPONENT = re.compile(r"(?<=[A-Za-z])(-?\d+)")
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def readable_unit(unit: str) -> str:
    """`kg.m2/s` as kg m²/s."""
    return EXPONENT.sub(lambda found: found.group().translate(_RAISED), unit.replace(".", " "))
