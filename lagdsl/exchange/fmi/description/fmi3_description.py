"""modelDescription.xml of FMI 3.0."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.exchange.fmi.description.description import (
    Attribution,
    NamedType,
    TypeKey,
    categories_and_experiment,
    dependencies_of,
    has_events,
    identity_of,
    literal_items,
    named_types,
    needs_completed_steps,
    range_of,
    root_of,
    unit_elements,
)
from lagdsl.exchange.fmi.description.xml import Element, document, element, start_text
from lagdsl.exchange.fmi.variables.builtin_variables import has_derivatives
from lagdsl.exchange.fmi.variables.scalar import Attributes, Role, Variable
from lagdsl.exchange.fmi.variables.structure import Unknown
from lagdsl.exchange.fmi.variables.variables import Table

_TAGS = {
    "REAL": "Float64",
    "INTEGER": "Int32",
    "BOOLEAN": "Boolean",
    "STRING": "String",
    "ENUMERATION": "Enumeration",
    "CLOCK": "Clock",
}
# Roles of variables that can be read inside a communication step.
_INTERMEDIATE = (Role.STATE, Role.DEPENDENT, Role.DERIVATIVE, Role.OUTPUT)


def fmi3_description(table: Table, *, identifier: str, token: str, attribution: Attribution | None = None) -> str:
    """`identifier` is the stem of the binaries' names, `token` the instantiation token."""
    root = root_of(table, "3.0", {"instantiationToken": token}, attribution)
    _interfaces(root, table, identifier)
    types = named_types(table)
    unit_elements(root, table)
    if types:
        definitions = element("TypeDefinitions", root)
        for kind in types.values():
            tag = f"{_TAGS[kind.type]}Type"
            defined = element(
                tag, definitions, name=kind.name, description=kind.doc, quantity=kind.quantity, unit=kind.unit
            )
            literal_items(defined, kind)
    categories_and_experiment(root, table)
    variables = element("ModelVariables", root)
    for reference, variable in enumerate(table.variables):
        _variable(variables, reference, variable, types)
    _structure(root, table)
    return document(root)


def _interfaces(root: Element, table: Table, identifier: str) -> None:
    events = has_events(table)
    tags = {"me": "ModelExchange", "cs": "CoSimulation"}
    own: dict[str, dict[str, int]] = {
        "me": {"needsCompletedIntegratorStep": needs_completed_steps(table)},
        "cs": {
            "canHandleVariableCommunicationStepSize": True,
            "maxOutputDerivativeOrder": int(has_derivatives(table.program)),
            "providesIntermediateUpdate": True,
            "mightReturnEarlyFromDoStep": events,
            "canReturnEarlyAfterIntermediateUpdate": True,
            "hasEventMode": events,
        },
    }
    for kind in table.kinds:
        element(
            tags[kind],
            root,
            modelIdentifier=identifier,
            canGetAndSetFMUState=True,
            canSerializeFMUState=True,
            providesDirectionalDerivatives=has_derivatives(table.program),
            providesAdjointDerivatives=has_derivatives(table.program),
            providesPerElementDependencies=True,
            **own[kind],
        )


def _variable(parent: Element, reference: int, variable: Variable, types: Mapping[TypeKey, NamedType]) -> None:
    attributes = variable.attributes
    if attributes.type == "CLOCK":
        _clock(parent, reference, variable)
        return
    text = attributes.type == "STRING"
    defined = element(
        _TAGS[attributes.type],
        parent,
        **identity_of(variable, reference),
        intermediateUpdate=_moves_within_steps(attributes) or None,
        **range_of(variable, types),
        derivative=variable.derivative_of,
        reinit=True if variable.reinit else None,
        start=None if text else start_text(attributes.type, variable.starts),
    )
    for extent in variable.shape:
        element("Dimension", defined, start=extent)
    for start in variable.starts if text else ():
        element("Start", defined, value=str(start))
    for name, doc in variable.others:
        element("Alias", defined, name=name, description=doc)


def _moves_within_steps(attributes: Attributes) -> bool:
    """True if a step of the importer may ask for it while it is under way."""
    moving = attributes.type == "REAL" and attributes.variability == "continuous"
    return moving and attributes.role in _INTERMEDIATE


def _clock(parent: Element, reference: int, variable: Variable) -> None:
    """Intervals that follow parameters are asked for in initialization mode."""
    known = variable.attributes.interval
    element(
        "Clock",
        parent,
        **identity_of(variable, reference),
        intervalVariability="fixed" if known is None else "constant",
        intervalDecimal=None if known is None else known[0],
        shiftDecimal=None if known is None else known[1],
    )


def _structure(root: Element, table: Table) -> None:
    structure = element("ModelStructure", root)
    parts: dict[str, tuple[Unknown, ...]] = {
        "Output": table.structure.outputs,
        "ContinuousStateDerivative": table.structure.derivatives,
        "InitialUnknown": table.structure.initial,
        "EventIndicator": table.structure.indicators,
    }
    for tag, unknowns in parts.items():
        for unknown in unknowns:
            element(tag, structure, valueReference=unknown.variable, **dependencies_of(unknown, 0))
