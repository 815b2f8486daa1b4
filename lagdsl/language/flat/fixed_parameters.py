"""Other values of parameters and starts, as if they stood in the text; parameters that become numbers of the model.

No function asks for a fixed parameter. It folds into the expressions as a structural one does: what it multiplies,
divides or switches is simplified when the equations are derived, and the program has one entry of `p` fewer.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace

from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.language.flat.admissible import require_value
from lagdsl.language.flat.expression import Number
from lagdsl.language.flat.model import Coordinate, FlatModel, Parameter, State


def fix_parameters(flat: FlatModel, values: Mapping[str, float]) -> FlatModel:
    """`flat` with the independent parameters `values` (SI units, by name) fixed.

    Raises KeyError for a name that is no independent parameter, ValueError for a value that it may not have.
    """
    independent = {parameter.name: parameter for parameter in flat.parameters if not parameter.structural}
    for name, value in values.items():
        if name not in independent:
            raise KeyError(_unknown(name, flat, list(independent)))
        require_value(independent[name], value)
    return replace(flat, parameters=tuple(_fixed(parameter, values) for parameter in flat.parameters))


def matching_values(flat: FlatModel, patterns: Iterable[str]) -> dict[str, float]:
    """Default values of the independent parameters that `patterns` name; `*` in a pattern stands for any text.

    Raises KeyError for a pattern that names none.
    """
    defaults = {parameter.name: parameter.value for parameter in flat.parameters if not parameter.structural}
    found: dict[str, float] = {}
    for pattern in patterns:
        expression = re.compile(".*".join(re.escape(part) for part in pattern.split("*")), re.DOTALL)
        names = [name for name in defaults if expression.fullmatch(name)]
        if not names:
            raise KeyError(_unknown(pattern, flat, list(defaults)))
        found |= {name: defaults[name] for name in names}
    return found


def _fixed(parameter: Parameter, values: Mapping[str, float]) -> Parameter:
    if parameter.structural or parameter.name not in values:
        return parameter
    return replace(parameter, structural=True, free=False, value=float(values[parameter.name]))


def _unknown(name: str, flat: FlatModel, known: list[str]) -> str:
    if any(parameter.name == name and parameter.structural for parameter in flat.parameters):
        return f"`{name}` is structural: it is a number of the model already"
    hint = did_you_mean(name, known, f"there are {listing(name, known)}")
    return f"{flat.name} has no independent parameter `{name}`; {hint}"


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
