"""Names that can be set, and values of what they stand for."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Literal as OneOf
from typing import TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.record import record, remembered
from lagdsl.foundation.units.dimension import TIME, Dimension
from lagdsl.foundation.units.naming import rate_text
from lagdsl.foundation.units.written import literal_text
from lagdsl.language.flat.admissible import require_value
from lagdsl.language.flat.display import Display, display, display_rate
from lagdsl.language.flat.model import Coordinate, FlatModel, Parameter
from lagdsl.language.flat.quantity import MORE_THAN_A_TURN, Quantity
from lagdsl.language.settings.arrays import family
from lagdsl.language.settings.failure import SettingError, UnknownSettingError, short
from lagdsl.language.settings.literal import Literal, literal, require_dimension

Kind: TypeAlias = OneOf["parameter", "structural", "start", "input"]
SETTABLE: tuple[Kind, ...] = ("parameter", "structural", "start")


@record(kw_only=True)
class Target:
    """`name` is how users call it (`l`, `theta.start`), `key` how the model does (`theta`, `der(theta)`). With `rate`
    it is the rate of `quantity`."""

    name: str
    key: str
    kind: Kind
    quantity: Quantity
    rate: bool = False

    @property
    def dimension(self) -> Dimension:
        return self.quantity.dimension / TIME if self.rate else self.quantity.dimension

    @property
    def unit(self) -> str:
        """The coherent SI unit; empty for numbers."""
        item = self.quantity
        unit = rate_text(item.dimension, item.unit) if self.rate else item.unit
        return "" if unit == "1" else unit

    @property
    def display(self) -> Display:
        """The unit of summaries and figures."""
        if isinstance(self.quantity, Coordinate) and self.rate:
            shown = display_rate(self.quantity)
            return shown if shown.scale != 1.0 else Display(self.unit)
        return display(self.quantity)


def targets(flat: FlatModel, kinds: Iterable[Kind] = SETTABLE) -> dict[str, Target]:
    """Everything in `flat` that takes a value, by name."""
    wanted = set(kinds)
    return {target.name: target for target in _all_targets(flat) if target.kind in wanted}


@remembered
def _all_targets(flat: FlatModel) -> tuple[Target, ...]:
    return (
        *(
            Target(name=p.name, key=p.name, kind="structural" if p.structural else "parameter", quantity=p)
            for p in flat.parameters
            if not p.constant
        ),
        *(Target(name=i.name, key=i.name, kind="input", quantity=i) for i in flat.inputs),
        *(Target(name=f"{s.name}.start", key=s.name, kind="start", quantity=s) for s in flat.coordinates),
        *(Target(name=f"{s.name}.start", key=s.name, kind="start", quantity=s) for s in flat.states),
        *(
            Target(name=f"der({c.name}).start", key=f"der({c.name})", kind="start", quantity=c, rate=True)
            for c in flat.coordinates
        ),
    )


def find(flat: FlatModel, name: str, known: Mapping[str, Target]) -> Target:
    """The one of `known` that is called so. Raises UnknownSettingError."""
    if name not in known:
        raise UnknownSettingError(_unknown(flat, name, known))
    return known[name]


def value_of(target: Target, text: str) -> Literal:
    """The value in SI units; one of an enumeration by its name or its number. Raises SettingError where it is none of
    `target`."""
    where = f"{target.name}={short(text)}"
    item = target.quantity
    place = _place_in_enumeration(item, text.strip())
    if place is not None:
        return Literal(text, place, None)
    try:
        given = literal(target.name, text)
    except SettingError:
        if not item.literals:
            raise
        raise SettingError(f"{where}: `{target.name}` is one of {', '.join(item.literals)}") from None
    if isinstance(item, Parameter) and given.boolean != (item.kind == "Boolean"):
        expected = "true or false" if item.kind == "Boolean" else "a number"
        raise SettingError(f"{where}: `{target.name}` is {expected}")
    if given.is_point and item.type_name == "TemperatureDifference":
        raise SettingError(f"{where}: `{target.name}` is a difference of temperatures; give it in K")
    require_dimension(target.name, given, target.dimension, target.unit)
    if isinstance(item, Parameter):
        try:
            require_value(item, given.value)
        except ValueError as error:
            raise SettingError(f"{where}: {error}") from error
    return given


def _place_in_enumeration(item: Quantity, text: str) -> float | None:
    """The number of `fast` or `Mode.fast`; None for what is no name of a value of the type."""
    name = text.removeprefix(f"{item.type_name}.")
    return item.literals.index(name) + 1.0 if name in item.literals else None


def lacks_unit(target: Target, given: Literal) -> bool:
    """A bare number for a quantity with unit, where units make a difference: zero is zero in all units but degC."""
    if given.dimension is not None or not target.unit:
        return False
    return given.value != 0.0 or target.display.shift != 0.0


def note_lacking_unit(target: Target, text: str, value: float, sink: Sink) -> None:
    """N0871, or W0421 for an angle of more than a turn: `theta.start=30` is 30 rad = 1719 deg."""
    shown = target.display
    readings = [literal_text(f"{value:.6g}", target.unit)]
    if shown.unit != target.unit and math.isfinite(shown(value)):
        readings.append(literal_text(f"{shown(value):.4g}", shown.unit))
    report_lacking_unit(target, text, " = ".join(readings), value, sink)


def report_lacking_unit(target: Target, text: str, reading: str, largest: float, sink: Sink) -> None:
    """N0871, or W0421 where the `largest` of the values is an angle of more than a turn."""
    degrees = target.unit == "rad" and abs(largest) > MORE_THAN_A_TURN
    units = dict.fromkeys((target.display.unit, target.unit))
    ways = " or ".join(f"`{literal_text(text, unit)}`" for unit in units)
    sink.report("W0421" if degrees else "N0871", None, what=f"{target.name}={text}", reading=reading, ways=ways)


def _unknown(flat: FlatModel, name: str, known: Mapping[str, Target]) -> str:
    if any(getattr(item, "name", None) == name for item in (*flat.named, *flat.outputs)):
        return f"`{name}` is computed from others in {flat.name}; set what it depends on"
    if any(item.name == name for item in flat.parameters):
        return f"`{name}` is a constant of {flat.name}; declare it as a `parameter` to set it"
    if any(item.name == name for item in flat.inputs):
        return f"`{name}` is an input of {flat.name}; give it with --input '{name}=...', or in a table"
    if f"{name}.start" in known:
        return f"`{name}` moves; set its start value with --set '{name}.start=...'"
    elements = family(name, known)
    if elements:
        whole, first = f"--set '{name}={{...}}'", f"--set '{elements[0]}=...'"
        return f"`{name}` is an array; set it with {whole}, or its elements, as in {first}"
    hint = did_you_mean(name, known, f"what can be set: {listing(name, known)}")
    return f"{flat.name} has no parameter `{short(name)}`; {hint}"
