"""Many values of one thing: a list, a range as in Modelica (`first:step:last unit`), or `linspace(first, last, count)
unit`. Counted in the decimals that were typed (docs/adr/0031)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import field
from fractions import Fraction

from lagdsl.foundation.record import record
from lagdsl.language.settings.failure import SettingError, short
from lagdsl.language.settings.pieces import QUANTITY, pieces_of

CALL = re.compile(r"([a-z]+)\s*\(([^()]*)\)\s*(.*?)\s*")
_OTHER_RANGES = re.compile(r"\.\.| to ")
_MOST_DIGITS = 12


@record(kw_only=True)
class Grid:
    """`count` values: those of `listed`, or first, first + step, ... in `unit`. `missed` is the last value of a range
    whose steps do not meet it."""

    count: int
    listed: tuple[str, ...] = ()
    first: Fraction = Fraction(0)
    step: Fraction = Fraction(0)
    unit: str = ""
    missed: str = ""
    shown: str = field(default="", compare=False)

    def texts(self) -> Iterator[str]:
        """Every value as a literal."""
        if self.listed:
            yield from self.listed
            return
        for i in range(self.count):
            yield f"{float(self.first + i * self.step)!r} {self.unit}".strip()


def grid_of(name: str, text: str) -> Grid:
    """The values of `text`. Raises SettingError."""
    call = CALL.fullmatch(text)
    if call is not None and call[1] == "linspace":
        return _linspace(f"{name}={short(text)}", call)
    if ":" in text:
        return _range(name, text)
    if _OTHER_RANGES.search(text):
        raise SettingError(f"{name}={short(text)}: a range is first:step:last, as in 0.1:0.1:1 m")
    values = tuple(pieces_of(text))
    return Grid(count=len(values), listed=values)


def evenly(name: str, first: tuple[str, str], last: tuple[str, str], count: int) -> Grid:
    """`count` values between two numbers with units, which must be the same or stand at the last only."""
    unit = _common_unit(name, [first[1], last[1]])
    begin, end = _exact(name, first[0]), _exact(name, last[0])
    return Grid(count=count, first=begin, step=(end - begin) / (count - 1), unit=unit)


def parts_of(name: str, text: str) -> list[tuple[str, str]]:
    """The numbers of a range and their units, as they stand. Raises SettingError."""
    found = [QUANTITY.fullmatch(part) for part in text.split(":")]
    parts = [(part[1], part[2]) for part in found if part is not None]
    if len(parts) < len(found):
        raise SettingError(f"{name}={short(text)}: a range is first:step:last, as in 0.1:0.1:1 m")
    for number, _ in parts:
        _exact(f"{name}={short(text)}", number)
    return parts


def rewritten(name: str, parts: list[tuple[str, str]], unit: str) -> str:
    """`from:to:count` as a range: `P=0:0.1:3 N`; with steps that no decimal number tells by linspace."""
    (first, _), (last, _), (digits, _) = parts
    count = int(digits)
    step = _decimal((Fraction(last) - Fraction(first)) / max(count - 1, 1))
    if step is None or count < 2:
        return f"{name}=linspace({first}, {last}, {count}) {unit}".rstrip()
    return f"{name}={first}:{step}:{last} {unit}".rstrip()


def counted(name: str, text: str, parts: list[tuple[str, str]], unit: str) -> SettingError:
    """The error for a range that seems to be from:to:count, with the texts to write for both readings."""
    first, step, last = (Fraction(number) for number, _ in parts)
    leads = step != 0 and (last - first) / step >= 0
    steps = f", for steps '{name}={':'.join(number for number, _ in parts)} {unit}'" if leads else ""
    return SettingError(
        f"{name}={short(text)}: a range is first:step:last with its unit at the end, not from:to:count; "
        f"for {parts[2][0]} values write '{rewritten(name, parts, unit)}'{steps}"
    )


def is_count(part: tuple[str, str]) -> bool:
    """True if the last part of a range may have been meant as a number of values."""
    number, unit = part
    return not unit and number.isdigit() and int(number) >= 2


def _range(name: str, text: str) -> Grid:
    """`first:step:last unit`, the last included where the steps meet it."""
    where = f"{name}={short(text)}"
    parts = parts_of(name, text)
    if len(parts) != 3:
        raise SettingError(f"{where}: a range is first:step:last, as in 0.1:0.1:1 m, or linspace(0.1, 1, 10) m")
    if is_count(parts[2]) and (parts[0][1] or parts[1][1]):
        raise counted(name, text, parts, parts[1][1] or parts[0][1])
    unit = _common_unit(where, [unit for _, unit in parts])
    first, step, last = (Fraction(number) for number, _ in parts)
    if step == 0 or (last - first) / step < 0:
        hint = f"; for {parts[2][0]} values write '{rewritten(name, parts, unit)}'" if is_count(parts[2]) else ""
        raise SettingError(
            f"{where}: a range is first:step:last; steps of {float(step):g} do not lead from {float(first):g} to "
            f"{float(last):g}{hint}"
        )
    count = (last - first) // step + 1
    end = first + (count - 1) * step
    missed = "" if end == last else f"{float(end):g} {unit}".rstrip()
    return Grid(count=count, first=first, step=step, unit=unit, missed=missed, shown=f"{float(last):g} {unit}".rstrip())


def _linspace(where: str, call: re.Match[str]) -> Grid:
    given = [piece.strip() for piece in call[2].split(",")]
    if len(given) != 3 or not given[2].isdigit() or int(given[2]) < 2:
        raise SettingError(f"{where}: write linspace(first, last, count) unit, with two values at least")
    limits = [QUANTITY.fullmatch(piece) for piece in given[:2]]
    first, last = ((each[1], each[2] or call[3]) if each else ("", "") for each in limits)
    if not first[0] or not last[0]:
        raise SettingError(f"{where}: the first and the last value must be numbers, as in linspace(0, 3, 31) N")
    if Fraction(first[0]) == Fraction(last[0]):
        raise SettingError(f"{where}: the first and the last value are the same")
    return evenly(where, first, last, int(given[2]))


def _common_unit(where: str, units: list[str]) -> str:
    """The one unit of a range, which stands at its end or at each of its numbers."""
    if len({unit for unit in units if unit}) > 1 or (any(units) and not units[-1]):
        raise SettingError(f"{where}: give one unit for the whole range, at its end")
    return units[-1]


def _exact(where: str, number: str) -> Fraction:
    """The number as it is typed. Raises SettingError where a double cannot hold it."""
    if math.isinf(float(number)):
        raise SettingError(f"{where}: {number} is too large for a number")
    return Fraction(number)


def _decimal(number: Fraction) -> str | None:
    """The number as it is typed; None where it has no short decimal form."""
    text = f"{float(number):.{_MOST_DIGITS}g}"
    return text if Fraction(text) == number else None
