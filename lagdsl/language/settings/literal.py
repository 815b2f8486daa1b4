"""Numbers and quantities as they are typed: `2`, `2000 g`, `true`."""

from __future__ import annotations

import math
import re

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.definition import si_value
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME, Dimension
from lagdsl.foundation.units.naming import describe
from lagdsl.foundation.units.parse import UnknownUnit, counts_otherwise, parse_unit
from lagdsl.language.settings.failure import SettingError, short
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse_expression

_OF_NUMBERS = ("E0105", "E0108", "E0116")
"""No unit, a character such as a degree sign, no number of double precision."""
_WRITTEN = re.compile(r"([+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)[ \t]*([^0-9. \t].*|1/.*)")


@record()
class Literal:
    """A number as written, `value` in SI units; without a unit (`dimension` None) it takes that of what it is bound
    to."""

    text: str
    value: float
    dimension: Dimension | None
    boolean: bool = False
    unit: str = ""
    is_point: bool = False  # in a unit with an offset


def literal(name: str, text: str, example: str = "2 kg") -> Literal:
    """A number, a quantity as in a model text (`2000 g`) or with a unit as in its declaration (`2 V/(rad.s)`), or true
    or false. Raises SettingError."""
    where = f"{name}={short(text)}"
    sink = Sink()
    expression = parse_expression(SourceFile(name, text), sink)
    sign = ""
    while isinstance(expression, nodes.Unary) and expression.operator in "+-":
        sign = ("" if sign else "-") if expression.operator == "-" else sign
        expression = expression.operand
    if isinstance(expression, nodes.Number):
        return Literal(text, float(sign + expression.text), None)
    if isinstance(expression, nodes.Quantity):
        definition = parse_unit(expression.unit)
        value = si_value(sign + expression.number, definition)
        return Literal(
            text,
            value,
            definition.dimension,
            unit=expression.unit,
            is_point=definition.shift != 0,
        )
    if isinstance(expression, nodes.Boolean):
        return Literal(text, float(expression.value), DIMENSIONLESS, boolean=True)
    declared = _with_declared_unit(text)
    if declared is not None:
        return declared
    for fault in sink.diagnostics:
        if fault.code in _OF_NUMBERS or (fault.code == "E0100" and fault.edit is not None):  # or a decimal comma
            raise SettingError(f"{where}: {fault.message}; {fault.help}")
    if (suggestion := _unit_meant(text)) is not None:
        raise SettingError(f"{where}: did you mean the unit `{suggestion}`?")
    raise SettingError(f"{where}: expected a number with or without a unit, as in {example}")


def _with_declared_unit(text: str) -> Literal | None:
    """`2 V/(rad.s)`, `2 1/s`: units of declarations, which in a model text would be products with names."""
    match = _WRITTEN.fullmatch(text.strip())
    try:
        definition = parse_unit(match[2]) if match is not None else None
    except UnknownUnit:
        return None
    if match is None or definition is None:
        return None
    value = si_value(match[1], definition)
    return Literal(text, value, definition.dimension, unit=match[2]) if math.isfinite(value) else None


def _unit_meant(text: str) -> str | None:
    """The unit that resembles what stands behind a number: `V/rad.s` for `2 V/rad/s`."""
    match = _WRITTEN.fullmatch(text.strip())
    try:
        parse_unit(match[2] if match is not None else "")
    except UnknownUnit as fault:
        return fault.suggestion
    return None


def require_dimension(name: str, given: Literal, dimension: Dimension, unit: str) -> None:
    """Raise SettingError where a value of `dimension` [unit] cannot be `given`."""
    if given.dimension is not None and given.dimension != dimension:
        raise SettingError(
            f"{name}={short(given.text)}: `{name}` is {describe(dimension)} [{unit}], "
            f"this is {describe(given.dimension)}"
        )
    if why := counts_otherwise(given.unit, unit):
        raise SettingError(f"{name}={short(given.text)}: {why}")


def seconds(option: str, text: str | None) -> float | None:
    """The value of an option that takes a time: `10` or `500 ms`. Raises SettingError."""
    if text is None:
        return None
    given = literal(option, text, "10 or 500 ms")
    require_dimension(option, given, TIME, "s")
    return given.value
