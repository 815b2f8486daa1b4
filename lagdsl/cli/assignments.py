"""`--set name=value`: parameters, start values and structural parameters from the command line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

import click

from lagdsl.diagnostics import Sink
from lagdsl.diagnostics.suggest import nearest
from lagdsl.flat.admissible import require_value
from lagdsl.flat.model import Coordinate, FlatModel, Parameter
from lagdsl.flat.quantity import Quantity
from lagdsl.record import record
from lagdsl.source import SourceFile
from lagdsl.syntax import nodes
from lagdsl.syntax.parser import parse_expression
from lagdsl.units.definition import si_value
from lagdsl.units.dimension import DIMENSIONLESS, TIME, Dimension
from lagdsl.units.naming import describe, rate_text
from lagdsl.units.parse import parse_unit

_MOST_TOLD = 12


@record()
class Settings:
    """Values in SI units by name; starts by `theta` or `der(theta)`."""

    parameters: dict[str, float] = field(default_factory=dict)
    start: dict[str, float] = field(default_factory=dict)
    structural: dict[str, float] = field(default_factory=dict)


@record()
class _Literal:
    """A number as written; without a unit (`dimension` None) it takes that of what it is bound to."""

    text: str
    value: float
    dimension: Dimension | None
    boolean: bool = False
    counts_turns: bool = False  # a literal in Hz
    is_point: bool = False  # in a unit with an offset


def split(assignments: Sequence[str]) -> dict[str, str]:
    """`name=value` texts by name."""
    pairs: dict[str, str] = {}
    for assignment in assignments:
        name, equals, value = assignment.partition("=")
        if not equals or not name.strip() or not value.strip():
            raise click.UsageError(f"{assignment}: expected name=value, as in --set 'm=2 kg'")
        if name.strip() in pairs:
            raise click.UsageError(f"`{name.strip()}` is set twice")
        pairs[name.strip()] = value.strip()
    return pairs


def settings(flat: FlatModel, pairs: dict[str, str]) -> Settings:
    """Values of the assignments in this model. Raises UsageError for unknown names and values that do not fit."""
    result = Settings()
    parameters = {p.name: p for p in flat.parameters}
    starts: dict[str, Quantity] = {s.name: s for s in (*flat.coordinates, *flat.states)}
    rates: dict[str, Coordinate] = {f"der({c.name})": c for c in flat.coordinates}
    for name, text in pairs.items():
        base = name.removesuffix(".start")
        if name in parameters:
            parameter = parameters[name]
            target = result.structural if parameter.structural else result.parameters
            target[name] = _parameter_value(parameter, text)
        elif name != base and base in starts:
            result.start[base] = fitting(starts[base], name, text)
        elif name != base and base in rates:
            result.start[base] = fitting(rates[base], name, text, rate=True)
        else:
            raise click.UsageError(_unknown(flat, name, [*parameters, *(f"{s}.start" for s in [*starts, *rates])]))
    return result


def constants(flat: FlatModel, pairs: dict[str, str]) -> dict[str, float]:
    """Inputs by name, SI units. Raises UsageError for unknown names and values that do not fit."""
    inputs = {item.name: item for item in flat.inputs}
    for name in pairs:
        if name not in inputs:
            raise click.UsageError(f"{flat.name} has no input `{_short(name)}`; inputs: {', '.join(inputs) or 'none'}")
    return {name: fitting(inputs[name], name, text) for name, text in pairs.items()}


def fitting(quantity: Quantity, name: str, text: str, *, rate: bool = False) -> float:
    """A value of `quantity`, or of its rate, in SI units. Raises UsageError where it does not fit."""
    dimension = quantity.dimension / TIME if rate else quantity.dimension
    unit = rate_text(quantity.dimension, quantity.unit) if rate else quantity.unit
    given = literal(name, text)
    _require_amount(quantity, name, given)
    return _fitting(name, dimension, unit, given)


def seconds(option: str, text: str | None) -> float | None:
    """The value of an option that takes a time: `10` or `500 ms`."""
    return None if text is None else _fitting(option, TIME, "s", literal(option, text))


def literal(name: str, text: str) -> _Literal:
    """A number, a quantity as in a model text (`2000 g`), or true or false."""
    where = f"{name}={_short(text)}"
    sink = Sink()
    expression = parse_expression(SourceFile(name, text), sink)
    sign = ""
    while isinstance(expression, nodes.Unary) and expression.operator in "+-":
        sign = ("" if sign else "-") if expression.operator == "-" else sign
        expression = expression.operand
    if isinstance(expression, nodes.Number):
        return _Literal(text, float(sign + expression.text), None)
    if isinstance(expression, nodes.Quantity):
        definition = parse_unit(expression.unit)
        counts_turns = expression.unit in ("Hz", "kHz", "MHz")
        value = si_value(sign + expression.number, definition)
        is_point = definition.shift != 0
        return _Literal(text, value, definition.dimension, counts_turns=counts_turns, is_point=is_point)
    if isinstance(expression, nodes.Boolean):
        return _Literal(text, float(expression.value), DIMENSIONLESS, boolean=True)
    for fault in sink.diagnostics:
        if fault.code in ("E0105", "E0116"):  # no unit, no number of double precision
            raise click.UsageError(f"{where}: {fault.message}; {fault.help}")
    example = "10 or 500 ms" if name.startswith("--") else "2 kg"
    raise click.UsageError(f"{where}: expected a number with or without a unit, as in {example}")


def _parameter_value(parameter: Parameter, text: str) -> float:
    given = literal(parameter.name, text)
    where = f"{parameter.name}={_short(text)}"
    if given.boolean != (parameter.kind == "Boolean"):
        expected = "true or false" if parameter.kind == "Boolean" else "a number"
        raise click.UsageError(f"{where}: `{parameter.name}` is {expected}")
    _require_amount(parameter, parameter.name, given)
    value = _fitting(parameter.name, parameter.dimension, parameter.unit, given)
    try:
        require_value(parameter, value)
    except ValueError as error:
        raise click.UsageError(f"{where}: {error}") from error
    return value


def _require_amount(quantity: Quantity, name: str, given: _Literal) -> None:
    if given.is_point and quantity.type_name == "TemperatureDifference":
        raise click.UsageError(f"{name}={_short(given.text)}: `{name}` is a difference of temperatures; give it in K")


def _fitting(name: str, dimension: Dimension, unit: str, given: _Literal) -> float:
    if given.dimension is not None and given.dimension != dimension:
        raise click.UsageError(
            f"{name}={_short(given.text)}: `{name}` is {describe(dimension)} [{unit}], "
            f"this is {describe(given.dimension)}"
        )
    if given.counts_turns and unit == "rad/s":
        raise click.UsageError(f"{name}={_short(given.text)}: Hz counts turns; write `rev/s` or `rad/s`")
    return given.value


def _unknown(flat: FlatModel, name: str, known: Sequence[str]) -> str:
    if any(getattr(item, "name", None) == name for item in (*flat.named, *flat.outputs)):
        return f"`{name}` is computed from others in {flat.name}; set what it depends on"
    if any(item.name == name for item in flat.inputs):
        return f"`{name}` is an input of {flat.name}; give it as a column of a table with --input"
    if f"{name}.start" in known:
        return f"`{name}` moves; set its start value with --set '{name}.start=...'"
    first = name.removesuffix(".start") + "["
    for element in known:
        if element.startswith(first):
            return f"`{name}` is an array; set its elements, as in --set '{element}=...'"
    likely = nearest(name, known)
    if likely is not None:
        return f"{flat.name} has no parameter `{name}`; did you mean `{likely}`?"
    more = f" and {len(known) - _MOST_TOLD} more" if len(known) > _MOST_TOLD else ""
    listing = ", ".join(known[:_MOST_TOLD]) + more if known else "none"
    return f"{flat.name} has no parameter `{_short(name)}`; what can be set: {listing}"


def _short(text: str) -> str:
    """As much of what was typed as a message can hold."""
    return text if len(text) <= 60 else f"{text[:57]}..."
