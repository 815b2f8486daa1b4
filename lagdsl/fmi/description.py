"""What the descriptions of both versions of FMI have in common."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.fmi.structure import Unknown
from lagdsl.fmi.variables import Table
from lagdsl.fmi.xml import one_line
from lagdsl.record import record

# What instances tell, by category: those of the standard.
LOG_CATEGORIES = {
    "logEvents": "what happens at instants",
    "logStatusWarning": "warnings",
    "logStatusDiscard": "steps and values that are refused",
    "logStatusError": "errors",
    "logStatusFatal": "errors after which nothing goes on",
    "logAll": "everything",
}
# Rows of an experiment that does not tell its interval.
_ROWS = 500


@record(kw_only=True)
class NamedType:
    """A type of the model's text and its unit."""

    name: str
    quantity: str
    unit: str | None


@record(kw_only=True)
class Experiment:
    start: float
    stop: float
    tolerance: float
    step: float


def experiment(table: Table) -> Experiment:
    """With the defaults of the language where the model does not tell."""
    given = table.flat.experiment
    step = given.interval or (given.stop_time - given.start_time) / _ROWS
    return Experiment(start=given.start_time, stop=given.stop_time, tolerance=given.tolerance, step=step)


def named_types(table: Table) -> dict[tuple[str, str | None], NamedType]:
    """By name of the type and unit. The names are none of a variable and differ from each other, as FMI 2 asks."""
    taken = {variable.name for variable in table.variables}
    found: dict[tuple[str, str | None], NamedType] = {}
    for variable in table.variables:
        attributes = variable.attributes
        key = (attributes.type_name or "", attributes.unit)
        if attributes.type_name is None or attributes.type != "REAL" or key in found:
            continue
        name = one_line(attributes.type_name)
        while name in taken:
            name += "_"
        taken.add(name)
        found[key] = NamedType(name=name, quantity=one_line(attributes.type_name), unit=attributes.unit)
    return found


def needs_completed_steps(table: Table) -> bool:
    """Whether anything is to be done after steps of the importer's integrator."""
    flat = table.flat
    watched = flat.assertions or flat.invariants or any(output.turning for output in flat.outputs)
    return bool(flat.constraints or watched or has_events(table))


def has_events(table: Table) -> bool:
    return bool(table.program.layout.discretes)


def dependencies_text(unknown: Unknown, shift: int) -> tuple[str | None, str | None]:
    """Attributes `dependencies`, indices counted from `shift`, and `dependenciesKind`."""
    if unknown.dependencies is None:
        return None, None
    indices, kinds = zip(*unknown.dependencies, strict=True) if unknown.dependencies else ((), ())
    return _joined(index + shift for index in indices), _joined(kinds)


def _joined(values: Iterable[object]) -> str:
    return " ".join(str(value) for value in values)
