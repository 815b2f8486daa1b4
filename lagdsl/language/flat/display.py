"""Values as people read them: in the display unit where there is one, else in the coherent SI unit."""

from __future__ import annotations

from functools import lru_cache

from lagdsl.foundation.record import record
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.language.flat.model import Coordinate
from lagdsl.language.flat.quantity import Quantity


@record()
class Display:
    """shown = si * scale + shift, in `unit`."""

    unit: str
    scale: float = 1.0
    shift: float = 0.0

    def __call__(self, si: float) -> float:
        return si * self.scale + self.shift


def display(quantity: Quantity) -> Display:
    """Unit and factor in which a value of `quantity` is shown. Plain angles (type Angle without a display unit) are
    shown in degrees."""
    text = quantity.display_unit or ("deg" if quantity.type_name == "Angle" else None)
    if text is None:
        return Display("" if quantity.unit == "1" else quantity.unit)
    return _display_in(text)


@lru_cache(maxsize=1024)
def _display_in(text: str) -> Display:
    definition = parse_unit(text)
    return Display(text, 1.0 / definition.factor, -definition.offset / definition.factor)


def display_rate(coordinate: Coordinate) -> Display:
    """Unit and factor in which a rate of `coordinate` is shown: its display unit per second, without offset."""
    shown = display(coordinate)
    return Display(f"{shown.unit or '1'}/s", shown.scale)


def drawn_rate(shown: Display) -> Display:
    """Of a rate in pictures, where people read spins in rad/s and currents in A: the SI units."""
    read = {"deg/s": "rad/s", "C/s": "A"}.get(shown.unit)
    return shown if read is None else Display(read)


def quantity_text(si: float, quantity: Quantity) -> str:
    """`30 deg`, four digits."""
    shown = display(quantity)
    return f"{shown(si):.4g} {shown.unit}".rstrip()
