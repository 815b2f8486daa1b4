"""Parts that the descriptions of both versions of FMI share."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from lagdsl.exchange.fmi.description.unit_definitions import unit_definitions
from lagdsl.exchange.fmi.description.xml import Element, Value, element, one_line
from lagdsl.exchange.fmi.variables.scalar import Type, Variable
from lagdsl.exchange.fmi.variables.structure import Unknown
from lagdsl.exchange.fmi.variables.variables import Table
from lagdsl.foundation.record import record
from lagdsl.foundation.version import __version__

# The log categories of the standard.
_LOG_CATEGORIES = {
    "logEvents": "what happens at instants",
    "logStatusWarning": "warnings",
    "logStatusDiscard": "steps and values that are refused",
    "logStatusError": "errors",
    "logStatusFatal": "errors after which the instance cannot continue",
    "logAll": "everything",
}
# Rows of an experiment that does not tell its interval.
_ROWS = 500


@record(kw_only=True)
class Attribution:
    """Attributes of the description that the model does not have: whose it is, under which terms, which version."""

    author: str | None = None
    license: str | None = None
    version: str | None = None

    def attributes(self) -> dict[str, str | None]:
        """As the standard calls them."""
        return {"author": self.author, "version": self.version, "license": self.license}


TypeKey: TypeAlias = tuple[object, ...]


@record(kw_only=True)
class NamedType:
    """A type of the model's text, with its unit or its literals."""

    name: str
    type: Type
    quantity: str
    unit: str | None
    doc: str | None
    literals: tuple[str, ...]
    literal_docs: tuple[str | None, ...]


def root_of(
    table: Table, version: str, token: Mapping[str, str], attribution: Attribution | None, **more: Value
) -> Element:
    """The root with its attributes in the order of the standard; `token` by its name in this version."""
    return element(
        "fmiModelDescription",
        None,
        fmiVersion=version,
        modelName=one_line(table.flat.name),
        **token,
        description=table.flat.doc,
        **(attribution or Attribution()).attributes(),
        generationTool=f"lagdsl {__version__}",
        variableNamingConvention="structured",
        **more,
    )


def literal_items(parent: Element, kind: NamedType) -> None:
    """The literals of an enumeration, counted from one."""
    for value, (literal, doc) in enumerate(zip(kind.literals, kind.literal_docs, strict=True), 1):
        element("Item", parent, name=literal, value=value, description=doc)


def categories_and_experiment(root: Element, table: Table) -> None:
    """LogCategories, and DefaultExperiment with the defaults of the language where the model does not tell."""
    categories = element("LogCategories", root)
    for name, description in _LOG_CATEGORIES.items():
        element("Category", categories, name=name, description=description)
    given = table.flat.experiment
    element(
        "DefaultExperiment",
        root,
        startTime=given.start_time,
        stopTime=given.stop_time,
        tolerance=given.tolerance,
        stepSize=given.interval or (given.stop_time - given.start_time) / _ROWS,
    )


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


def named_types(table: Table) -> dict[TypeKey, NamedType]:
    """Types by what tells them apart: texts may have two of one name. Here their names are none of a variable and
    differ from each other, as FMI asks."""
    taken = {name for v in table.variables for name in (v.name, *(other for other, _ in v.others))}
    found: dict[TypeKey, NamedType] = {}
    for variable in table.variables:
        key, attributes = _key(variable), variable.attributes
        if key is None or key in found:
            continue
        quantity = one_line(attributes.type_name or "")
        name = quantity
        while name in taken:
            name += "_"
        taken.add(name)
        found[key] = NamedType(
            name=name,
            type=attributes.type,
            quantity=quantity,
            unit=attributes.unit,
            doc=attributes.type_doc,
            literals=attributes.literals,
            literal_docs=attributes.literal_docs,
        )
    return found


def identity_of(variable: Variable, reference: int) -> dict[str, str | int | None]:
    """The attributes that both versions begin with."""
    attributes = variable.attributes
    return {
        "name": variable.name,
        "valueReference": reference,
        "description": attributes.doc,
        "causality": attributes.causality,
        "variability": attributes.variability,
        "initial": variable.initial,
    }


def range_of(variable: Variable, types: Mapping[TypeKey, NamedType]) -> dict[str, str | float | None]:
    """The attributes of type, units and range."""
    attributes, key = variable.attributes, _key(variable)
    return {
        "declaredType": None if key is None else types[key].name,
        "unit": attributes.unit,
        "displayUnit": attributes.display_unit,
        "min": _bound(attributes.minimum, attributes.type),
        "max": _bound(attributes.maximum, attributes.type),
        "nominal": attributes.nominal,
    }


def _bound(value: float | None, kind: Type) -> float | int | None:
    """`min` or `max`."""
    match kind:
        case "REAL":
            return value
        case "INTEGER":
            return None if value is None else int(value)
        case "BOOLEAN" | "STRING" | "ENUMERATION" | "CLOCK":
            return None


def _key(variable: Variable) -> TypeKey | None:
    """None for variables without a type of their own; those of Integers and Booleans tell nothing more."""
    attributes = variable.attributes
    if attributes.type_name is None or attributes.type not in ("REAL", "ENUMERATION"):
        return None
    return attributes.type_name, attributes.type, attributes.unit, attributes.literals


def needs_completed_steps(table: Table) -> bool:
    """True if anything is to be done after steps of the importer's integrator."""
    flat = table.flat
    watched = flat.assertions or flat.invariants or any(output.turn is not None for output in flat.outputs)
    return bool(flat.constraints or watched or has_events(table))


def has_events(table: Table) -> bool:
    return bool(table.program.layout.discretes)


def dependencies_of(unknown: Unknown, shift: int) -> dict[str, str]:
    """The attributes that tell them; indices count from `shift`."""
    return {
        "dependencies": " ".join(str(index + shift) for index, _ in unknown.dependencies),
        "dependenciesKind": " ".join(kind for _, kind in unknown.dependencies),
    }
