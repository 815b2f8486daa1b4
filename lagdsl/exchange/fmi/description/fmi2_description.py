"""modelDescription.xml of FMI 2.0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from lagdsl.exchange.fmi.description.description import (
    Attribution,
    NamedType,
    TypeKey,
    categories_and_experiment,
    dependencies_of,
    identity_of,
    literal_items,
    named_types,
    needs_completed_steps,
    range_of,
    root_of,
    unit_elements,
)
from lagdsl.exchange.fmi.description.xml import Element, document, element, start_text
from lagdsl.exchange.fmi.variables.builtin_variables import has_derivatives, indicator_count
from lagdsl.exchange.fmi.variables.scalar import Variable
from lagdsl.exchange.fmi.variables.structure import Unknown
from lagdsl.exchange.fmi.variables.variables import Table

_TAGS = {"REAL": "Real", "INTEGER": "Integer", "BOOLEAN": "Boolean", "STRING": "String", "ENUMERATION": "Enumeration"}


def fmi2_description(
    table: Table, *, identifier: str, source_files: Sequence[str], token: str, attribution: Attribution | None = None
) -> str:
    """`identifier` is the stem of the binaries' names, `source_files` what lies in `sources/`, `token` the guid."""
    indicators = indicator_count(table.flat, table.program)
    root = root_of(table, "2.0", {"guid": token}, attribution, numberOfEventIndicators=indicators)
    _interfaces(root, table, identifier, source_files)
    types = named_types(table)
    unit_elements(root, table)
    _types(root, types)
    categories_and_experiment(root, table)
    variables = element("ModelVariables", root)
    for reference, variable in enumerate(table.variables):
        _variable(variables, reference, variable, types)
    for reference, variable in enumerate(table.variables):
        for name, doc in variable.others:
            other = replace(variable, name=name, attributes=replace(variable.attributes, causality="local", doc=doc))
            _alias(variables, reference, other, types)
    _structure(root, table)
    return document(root)


def _interfaces(root: Element, table: Table, identifier: str, source_files: Sequence[str]) -> None:
    exchange: dict[str, int] = {"completedIntegratorStepNotNeeded": not needs_completed_steps(table)}
    simulation: dict[str, int] = {
        "canHandleVariableCommunicationStepSize": True,
        "canInterpolateInputs": True,
        "maxOutputDerivativeOrder": int(has_derivatives(table.program)),
    }
    interfaces: dict[str, tuple[str, dict[str, int]]] = {
        "me": ("ModelExchange", exchange),
        "cs": ("CoSimulation", simulation),
    }
    for kind in table.kinds:
        tag, own = interfaces[kind]
        interface = element(
            tag,
            root,
            modelIdentifier=identifier,
            **own,
            canGetAndSetFMUstate=True,
            canSerializeFMUstate=True,
            providesDirectionalDerivative=has_derivatives(table.program),
        )
        if source_files:
            files = element("SourceFiles", interface)
            for name in source_files:
                element("File", files, name=name)


def _types(root: Element, types: Mapping[TypeKey, NamedType]) -> None:
    if not types:
        return
    definitions = element("TypeDefinitions", root)
    for kind in types.values():
        defined = element("SimpleType", definitions, name=kind.name, description=kind.doc)
        inner = element(_TAGS[kind.type], defined, quantity=kind.quantity, unit=kind.unit)
        literal_items(inner, kind)


def _variable(parent: Element, reference: int, variable: Variable, types: Mapping[TypeKey, NamedType]) -> None:
    attributes = variable.attributes
    scalar = element(
        "ScalarVariable",
        parent,
        **identity_of(variable, reference),
    )
    element(
        _TAGS[attributes.type],
        scalar,
        **range_of(variable, types),
        start=start_text(attributes.type, variable.starts),
        derivative=None if variable.derivative_of is None else variable.derivative_of + 1,
        reinit=True if variable.reinit else None,
    )


def _alias(parent: Element, reference: int, variable: Variable, types: Mapping[TypeKey, NamedType]) -> None:
    """Another name of a variable, with its reference. Its start value stands at the variable itself, since at most one
    variable of an alias set has one (FMI 2.0.4, 2.2.7)."""
    scalar = element("ScalarVariable", parent, **identity_of(replace(variable, initial="calculated"), reference))
    element(_TAGS[variable.attributes.type], scalar, **range_of(variable, types))


def _structure(root: Element, table: Table) -> None:
    structure = element("ModelStructure", root)
    parts: dict[str, tuple[Unknown, ...]] = {
        "Outputs": table.structure.outputs,
        "Derivatives": table.structure.derivatives,
        "InitialUnknowns": table.structure.initial,
    }
    for tag, unknowns in parts.items():
        if not unknowns:
            continue
        part = element(tag, structure)
        for unknown in unknowns:
            element("Unknown", part, index=unknown.variable + 1, **dependencies_of(unknown, 1))
