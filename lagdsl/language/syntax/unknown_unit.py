"""Words after a number that are no unit (E0105)."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Edit, Sink
from lagdsl.foundation.diagnostics.catalog.syntax import foreign_unit, unit_help
from lagdsl.foundation.source import Span


def report_unknown_unit(sink: Sink, span: Span, number: str, unit: str, *, called: bool = False) -> None:
    """Report `unit` at `span`, with the unit that was meant if it resembles one, else with the product.

    With `called` a bracket follows: a function was meant.
    """
    quantity = None if called else _converted(number, unit) or _joined(number, unit)
    if quantity is not None:
        same = quantity.removeprefix(f"{number} ")
        edit = Edit(span, same) if same != quantity else None
        sink.report("E0105", span, help=f"write `{quantity}`", edit=edit, unit=unit)
        return
    suggestion = None if called or unit == "do" else _suggestion(unit)
    edit = None if suggestion is None else Edit(span, suggestion)
    if len(unit) == 1:  # more likely a factor
        edit = Edit(Span(span.file, span.start, span.start), "*")
    sink.report("E0105", span, help=unit_help(suggestion, number, unit), edit=edit, unit=unit)


def _converted(number: str, unit: str) -> str | None:
    """`2 ft/s` as `0.6096 m/s`, too."""
    from lagdsl.foundation.units.parse import UnknownUnit, parse_unit

    whole, (head, slash, tail) = foreign_unit(number, unit), unit.partition("/")
    if whole is not None or not slash:
        return whole
    quantity = foreign_unit(number, head)
    if quantity is None or "/" in quantity:
        return None
    try:
        parse_unit(f"{quantity.partition(' ')[2]}/{tail}")
    except UnknownUnit:
        return None
    return f"{quantity}/{tail}"


def _joined(number: str, unit: str) -> str | None:
    """`1 N.m` for `1_N.m`."""
    from lagdsl.foundation.units.parse import UnknownUnit, parse_unit

    if unit[0] != "_":
        return None
    try:
        parse_unit(unit.strip("_"))
    except UnknownUnit:
        return None
    return f"{number} {unit.strip('_')}"


def _suggestion(unit: str) -> str | None:
    from lagdsl.foundation.units.parse import UnknownUnit, parse_unit

    try:
        parse_unit(unit)
    except UnknownUnit as fault:
        return fault.suggestion
    return None
