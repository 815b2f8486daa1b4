"""`name=value`: parameters, start values, structural parameters and inputs of one model."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.aliases import by_own_names
from lagdsl.language.settings.arrays import spread
from lagdsl.language.settings.failure import SettingError, UnknownSettingError, short
from lagdsl.language.settings.literal import Literal
from lagdsl.language.settings.target import Target, find, lacks_unit, note_lacking_unit, targets, value_of

_DECIMAL_COMMA = re.compile(r"[^,:]*[0-9],[0-9][^,:]*")


@record()
class Settings:
    """Values in SI units by name; starts by `theta` or `der(theta)`."""

    parameters: dict[str, float] = field(default_factory=dict)
    start: dict[str, float] = field(default_factory=dict)
    structural: dict[str, float] = field(default_factory=dict)


def split(assignments: Sequence[str]) -> dict[str, str]:
    """`name=value` texts by name. Raises SettingError."""
    pairs: dict[str, str] = {}
    for assignment in assignments:
        name, equals, value = assignment.partition("=")
        if not equals or not name.strip() or not value.strip():
            raise SettingError(f"{short(assignment)}: expected name=value, as in 'm=2 kg'")
        if name.strip() in pairs:
            raise SettingError(f"`{name.strip()}` is set twice")
        pairs[name.strip()] = value.strip()
    return pairs


def settings(flat: FlatModel, pairs: Mapping[str, str], sink: Sink) -> Settings:
    """Values of the assignments in this model; N0871 for numbers that lack a unit. Raises SettingError for unknown
    names and values that do not fit."""
    result = Settings()
    known = targets(flat)
    for name, text in spread(by_own_names(flat, pairs), known).items():
        target = find(flat, name, known)
        given = one_value(target, text)
        if lacks_unit(target, given):
            note_lacking_unit(target, text, given.value, sink)
        kinds = {"parameter": result.parameters, "structural": result.structural, "start": result.start}
        kinds[target.kind][target.key] = given.value
    return result


def one_value(target: Target, text: str) -> Literal:
    """The value in SI units. Raises SettingError where it is none of `target`, or several."""
    _require_one(target.name, text, "`lag sweep --set` takes ranges and lists")
    return value_of(target, text)


def constants(flat: FlatModel, pairs: Mapping[str, str], sink: Sink) -> dict[str, float]:
    """Inputs by name, SI units; N0871 for numbers that lack a unit. Raises SettingError for unknown names and values
    that do not fit."""
    values: dict[str, float] = {}
    for name, (target, text) in texts_of_inputs(flat, pairs).items():
        _require_one(name, text, "`lag sweep --input` takes ranges and lists")
        given = value_of(target, text)
        if lacks_unit(target, given):
            note_lacking_unit(target, text, given.value, sink)
        values[name] = given.value
    return values


def texts_of_inputs(flat: FlatModel, pairs: Mapping[str, str]) -> dict[str, tuple[Target, str]]:
    """Inputs by name, with the texts that are given for them. Raises SettingError for unknown names."""
    known = targets(flat, ("input",))
    found: dict[str, tuple[Target, str]] = {}
    for name, text in spread(pairs, known).items():
        if name not in known:
            hint = did_you_mean(name, known, f"inputs: {listing(name, known)}")
            raise UnknownSettingError(f"{flat.name} has no input `{short(name)}`; {hint}")
        found[name] = known[name], text
    return found


def _require_one(name: str, text: str, hint: str) -> None:
    if _DECIMAL_COMMA.fullmatch(text):
        return  # a fault of the number, which its reader tells
    if ":" in text or "," in text:
        raise SettingError(f"{name}={short(text)}: one value stands here, as in 2 kg; {hint}")
