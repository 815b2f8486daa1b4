"""Structural parameters that are set: each value is read where the flattening meets its parameter."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.settings.arrays import family, spread, without_subscripts
from lagdsl.language.settings.target import Target, find, targets

Reading: TypeAlias = "Callable[[Target, str], float | None]"
"""The number that a text asks for; None where another one refuses it. Raises ValueError."""


class StructuralTexts:
    """`pairs` name parameters of all kinds; which of them are structural shows while the model is flattened."""

    def __init__(self, pairs: Mapping[str, str], read: Reading) -> None:
        self._pairs = pairs
        self._read = read

    def value(self, parameter: Parameter, alike: Callable[[], Sequence[str]]) -> float | None:
        """None for a parameter that has its value from the model, and for a text that does not fit: `of` tells."""
        name, whole = parameter.name, without_subscripts(parameter.name)
        target = Target(name=name, key=name, kind="structural", quantity=parameter)
        try:
            if name not in self._pairs and whole in self._pairs:
                return self._read(target, spread({whole: self._pairs[whole]}, alike())[name])
            return self._read(target, self._pairs[name]) if name in self._pairs else None
        except (ValueError, KeyError):
            return None

    def of(self, flat: FlatModel) -> dict[str, float]:
        """The values for the structural parameters of `flat`. Raises SettingError for texts that do not fit."""
        known = targets(flat, ("structural",))
        chosen = {name: text for name, text in self._pairs.items() if name in known or family(name, known)}
        read = {name: self._read(find(flat, name, known), text) for name, text in spread(chosen, known).items()}
        return {name: value for name, value in read.items() if value is not None}


def check_structure(flat: FlatModel, wanted: Mapping[str, float], sink: Sink) -> None:
    """E0222 for what `flat` did not take: a name that it does not have, or an element of an array."""
    values = {each.name: each.value for each in flat.parameters if each.structural and not each.constant}
    settable = [name for name in values if not name.endswith("]")]
    for name, value in wanted.items():
        if values.get(name) != value:
            sink.report("E0222", None, name=name, help=did_you_mean(name, settable))
