"""Numbers of an exported model that its text declares: parameters, constants, inputs, outputs, definitions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from lagdsl.derivation.mechanics.named import definitions as named_values
from lagdsl.derivation.program.program import Program
from lagdsl.exchange.fmi.variables.attributes import attributes_of, bounds
from lagdsl.exchange.fmi.variables.names import belonging, named
from lagdsl.exchange.fmi.variables.parameter_use import parameters_of, tunable
from lagdsl.exchange.fmi.variables.scalar import Attributes, Causality, Role, Scalar, Variability
from lagdsl.exchange.fmi.variables.settings import Settings
from lagdsl.language.flat import quantity as fq
from lagdsl.language.flat.events import Contact, Discrete, Friction, entries
from lagdsl.language.flat.listing import discrete_outputs
from lagdsl.language.flat.model import Definition, FlatModel, Output


def parameters(flat: FlatModel, program: Program, settings: Settings) -> Iterator[Scalar]:
    """Independent ones, in the order of the vector p; texts there have no effect. Initialization solves for free ones:
    the start value of these is a guess (`approx`)."""
    changeable = tunable(flat, program)
    independent = [item for item in flat.parameters if not item.structural]
    for index, (item, value) in enumerate(zip(independent, settings.parameters, strict=True)):
        if item.kind == "String":
            continue
        variability: Variability = "tunable" if index in changeable else "fixed"
        attributes = replace(
            attributes_of(item, Role.FREE if item.free else Role.PARAMETER),
            causality="calculatedParameter" if item.free else "parameter",
            variability=variability,
            setting="TUNABLE" if variability == "tunable" else "START",
            **bounds(item, value),
        )
        yield Scalar(
            name=named(item.name),
            first=index,
            attributes=attributes,
            initial="approx" if item.free else "exact",
            start=value,
            key=_but_for_tuning(attributes),
            protected=item.protected,
        )


def constants(flat: FlatModel) -> Iterator[Scalar]:
    """Structural parameters, constants and texts. Numbers and texts are counted each for themselves."""
    counts = {False: 0, True: 0}
    for item in flat.parameters:
        text = item.kind == "String"
        if item.structural or text:
            attributes = replace(attributes_of(item, Role.CONSTANT), variability="constant", **bounds(item, item.value))
            yield Scalar(
                name=named(item.name),
                first=counts[text],
                attributes=attributes,
                initial="exact",
                start=(item.text or "") if text else item.value,
                key=None if text else attributes,
                protected=item.protected,
            )
            counts[text] += 1


def inputs(flat: FlatModel, settings: Settings) -> Iterator[Scalar]:
    for index, (item, value) in enumerate(zip(flat.inputs, settings.inputs, strict=True)):
        real = item.base == "Real"
        variability: Variability = "continuous" if real else "discrete"
        attributes = replace(
            attributes_of(item, Role.INPUT), causality="input", variability=variability, setting="ALWAYS"
        )
        if item.derivative_of is not None:  # of another type than the input itself
            attributes = replace(attributes, type_name=None, doc=f"time derivative of {item.derivative_of}")
        attributes = replace(attributes, **bounds(item, float(value)), nominal=item.nominal if real else None)
        yield Scalar(
            name=named(item.name), first=index, attributes=attributes, initial=None, start=value, key=attributes
        )


def outputs(flat: FlatModel) -> Iterator[Scalar]:
    """Discrete variables among them change at events only."""
    discrete = discrete_outputs(flat)
    for index, item in enumerate(flat.outputs):
        variability: Variability = "discrete" if item.name in discrete else "continuous"
        yield _computed(item, Role.OUTPUT, index, "output", variability)


def definitions(flat: FlatModel, program: Program) -> Iterator[Scalar]:
    """Dependent parameters, then what changes. The coordinates of cut joints are outputs already."""
    told = {item.name for item in flat.outputs}
    changeable = tunable(flat, program)
    (block,) = program.function("definition").results
    for index, (item, node) in enumerate(zip(named_values(flat), block.elements, strict=True)):
        if item.name in told:
            continue
        match item.variability:
            case fq.Variability.CONTINUOUS | fq.Variability.DISCRETE:
                variability: Variability = "discrete" if item.variability is fq.Variability.DISCRETE else "continuous"
                yield _computed(item, Role.LOCAL, index, "local", variability)
            case fq.Variability.CONSTANT | fq.Variability.STRUCTURAL | fq.Variability.PARAMETER:
                moved = bool(parameters_of(program, [node]) & changeable)
                yield _computed(item, Role.LOCAL, index, "calculatedParameter", "tunable" if moved else "fixed")
            case _:
                assert_never(item.variability)


def discretes(flat: FlatModel) -> Iterator[Scalar]:
    """Variables of the vector w that are no outputs."""
    outputs = discrete_outputs(flat)
    for index, entry in enumerate(entries(flat.events)):
        if isinstance(entry.item, Discrete) and entry.name not in outputs:
            attributes = replace(attributes_of(entry.item, Role.DISCRETE), variability="discrete")
            yield Scalar(
                name=named(entry.name),
                first=index,
                attributes=attributes,
                initial="calculated",
                key=attributes,
                protected=entry.item.protected,
            )


def contacts(flat: FlatModel) -> Iterator[Scalar]:
    """Two variables of each contact: closed or not, and the number of impacts."""
    closed = Attributes(role=Role.DISCRETE, type="BOOLEAN", variability="discrete", doc="whether the contact is closed")
    impacts = replace(closed, type="INTEGER", doc="impacts so far", minimum=0.0)
    for index, entry in enumerate(entries(flat.events)):
        if isinstance(entry.item, Contact):
            what, attributes = ("closed", closed) if entry.kind == "contact" else ("impacts", impacts)
            yield Scalar(
                name=belonging(entry.item.name, what),
                first=index,
                attributes=attributes,
                initial="calculated",
                key=attributes,
            )


def frictions(flat: FlatModel) -> Iterator[Scalar]:
    """A variable of each dry friction: whether it holds its slip at zero."""
    doc = "whether the friction sticks"
    attributes = Attributes(role=Role.DISCRETE, type="BOOLEAN", variability="discrete", doc=doc)
    for index, entry in enumerate(entries(flat.events)):
        if isinstance(entry.item, Friction) and entry.kind == "sticks":
            name = belonging(entry.item.name, "sticks")
            yield Scalar(name=name, first=index, attributes=attributes, initial="calculated", key=attributes)


def _computed(
    item: Definition | Output, role: Role, index: int, causality: Causality, variability: Variability
) -> Scalar:
    """A computed variable. Variables of other types than Real change at events only."""
    if item.base != "Real" and variability == "continuous":
        variability = "discrete"
    attributes = replace(attributes_of(item, role), causality=causality, variability=variability)
    if isinstance(item, Output):
        attributes = replace(attributes, **bounds(item, None), nominal=item.nominal if item.base == "Real" else None)
    return Scalar(
        name=named(item.name),
        first=index,
        attributes=attributes,
        initial="calculated",
        key=_but_for_tuning(attributes),
        protected=item.protected,
    )


def _but_for_tuning(attributes: Attributes) -> object:
    """Attributes that entries of an array share, also where only some of them have an effect after the start."""
    tuned = attributes.variability in ("tunable", "fixed")
    return replace(attributes, variability="tunable", setting="TUNABLE") if tuned else attributes
