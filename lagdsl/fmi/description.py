"""What the descriptions of both versions of FMI have in common."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.fmi.scalar import Type, Variable
from lagdsl.fmi.structure import Unknown
from lagdsl.fmi.unit_definitions import unit_definitions
from lagdsl.fmi.variables import Table
from lagdsl.fmi.xml import Element, element, one_line
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


def experiment(table: Table) -> dict[str, float]:
    """Attributes of DefaultExperiment, the defaults of the language where the model does not tell."""
    given = table.flat.experiment
    return {
        "startTime": given.start_time,
        "stopTime": given.stop_time,
        "tolerance": given.tolerance,
        "stepSize": given.interval or (given.stop_time - given.start_time) / _ROWS,
    }


def unit_elements(root: Element, table: Table) -> None:
    """UnitDefinitions, the same in both versions."""
    used = unit_definitions((v.attributes.unit, v.attributes.display_unit) for v in table.variables)
    definitions = element("UnitDefinitions", root)
    for unit in used:
        defined = element("Unit", definitions, name=unit.name)
        if unit.exponents is not None:
            powers: dict[str, int] = dict(unit.exponents)
            element("BaseUnit", defined, **powers, factor=None if unit.factor == 1.0 else unit.factor)
        for shown in unit.display_units:
            element("DisplayUnit", defined, name=shown.name, factor=shown.factor, offset=shown.offset or None)


def bound(value: float | None, kind: Type) -> float | int | None:
    """`min` or `max`."""
    return None if value is None or kind in ("BOOLEAN", "STRING") else int(value) if kind == "INTEGER" else value


def type_of_variable(variable: Variable, types: dict[tuple[str, str | None], NamedType]) -> str | None:
    """Name of its type definition."""
    attributes = variable.attributes
    found = types.get((attributes.type_name or "", attributes.unit)) if attributes.type == "REAL" else None
    return None if found is None else found.name


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
