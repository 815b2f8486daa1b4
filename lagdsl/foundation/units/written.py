"""Quantities that are written as products of a number and units: `9.81*m/s^2`."""

from __future__ import annotations

import re

from lagdsl.foundation.units.parse import UnknownUnit, parse_unit


def literal_text(number: str, unit: str) -> str:
    """A number with a unit text as model texts take it: `2 /s` for `1/s`, `3 J/kg.K` for `J/(kg.K)`, as everything
    behind the one slash divides."""
    if unit in ("", "1"):
        return number
    above, slash, below = unit.partition("/")
    return f"{number} {above if above != '1' else ''}{slash}{below.removeprefix('(').removesuffix(')')}"


_LONGEST = 80  # characters on each side that are looked at
_POWER = r"[A-Za-z]+[0-9]?(?:(?:\^|\*\*)-?[1-9])?"
_FACTOR = rf"{_POWER}(?:\.{_POWER})*"
_BRACKET = rf"{_POWER}(?:[ \t]*[.*][ \t]*{_POWER})*"
_PRODUCT = re.compile(
    rf"(?<![\w.])(?P<number>[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)"
    rf"(?P<units>(?:[ \t]*(?![eE])|[ \t]+){_FACTOR})?(?P<rest>(?:[ \t]*[*/][ \t]*(?:{_FACTOR}|\({_BRACKET}\)))+)"
    rf"(?![\w(\[.])"
)


def literal_around(text: str, start: int, end: int) -> str | None:
    """The literal, `9.81 m/s2`, of the product of a number and units that the name at `start` to `end` is part of:
    `9.81*m/s^2`, `2 V/(rad.s)`."""
    first = max(start - _LONGEST, text.rfind("\n", 0, start) + 1)
    for match in _PRODUCT.finditer(text, first, min(end + _LONGEST, len(text))):
        if match.start() <= start and end <= match.end():
            return _literal(match)
    return None


_MINUS_OR_SLASH = re.compile(rf"(?<![\w.])(?P<number>[0-9]+(?:\.[0-9]+)?)[ \t]*(?P<unit>{_FACTOR})(?P<mark>[-/])$")


def literal_with(text: str, start: int, end: int) -> str | None:
    """The literal, `2 N.m` or `3 m/s`, that the name at `start` to `end` was meant to end: `2 N-m`, `3 m/sec`."""
    match = _MINUS_OR_SLASH.search(text, max(start - _LONGEST, text.rfind("\n", 0, start) + 1), start)
    if match is None:
        return None
    unit = match["unit"] + match["mark"].replace("-", ".") + text[start : min(end, start + _LONGEST)]
    try:
        parse_unit(unit)
    except UnknownUnit as fault:
        return None if fault.suggestion is None else f"{match['number']} {fault.suggestion}"
    return f"{match['number']} {unit}"


def literal_of(text: str) -> str | None:
    """The literal of a text that is a product of a number and units as a whole."""
    match = _PRODUCT.fullmatch(text.strip()) if len(text) <= _LONGEST else None
    return None if match is None else _literal(match)


def _literal(match: re.Match[str]) -> str | None:
    """None where a factor is no unit."""
    above: list[str] = [match["units"].strip()] if match["units"] else []
    below: list[str] = []
    for mark, factor in re.findall(rf"([*/])[ \t]*({_FACTOR}|\({_BRACKET}\))", match["rest"]):
        (above if mark == "*" else below).append(re.sub(r"[ \t()]+", "", factor).replace("**", "^").replace("*", "."))
    if any("/" in factor for factor in above):
        return None
    unit = ".".join(above) + (f"/{'.'.join(below)}" if below else "")
    unit = unit.replace("**", "").replace("^", "")
    try:
        parse_unit(unit)
    except UnknownUnit:
        return None
    return f"{match['number']} {unit}"
