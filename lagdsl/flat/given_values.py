"""A model with other values of parameters and starts: as if they stood in its text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from lagdsl.flat.expression import Number
from lagdsl.flat.model import Coordinate, FlatModel, State


def with_values(flat: FlatModel, parameters: Mapping[str, float], start: Mapping[str, float]) -> FlatModel:
    """`flat` with values of independent parameters and starts, in SI units, by name: `m`, `theta`, `der(theta)`."""
    return replace(
        flat,
        parameters=tuple(
            replace(item, value=parameters[item.name]) if item.name in parameters else item for item in flat.parameters
        ),
        coordinates=tuple(_coordinate(item, start) for item in flat.coordinates),
        states=tuple(_state(item, start) for item in flat.states),
    )


def _coordinate(item: Coordinate, start: Mapping[str, float]) -> Coordinate:
    if item.name in start:
        item = replace(item, start=Number(start[item.name]), start_explicit=True)
    rate = f"der({item.name})"
    return replace(item, rate_start=Number(start[rate]), rate_start_explicit=True) if rate in start else item


def _state(item: State, start: Mapping[str, float]) -> State:
    return replace(item, start=Number(start[item.name]), start_explicit=True) if item.name in start else item
