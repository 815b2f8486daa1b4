"""Numbers that every exported model has beside those of its text: time, multipliers, energies, residuals, options."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lagdsl.derivation.program.program import Program
from lagdsl.exchange.fmi.variables.held_relations import held_relations
from lagdsl.exchange.fmi.variables.names import Name, aside, belonging
from lagdsl.exchange.fmi.variables.parameter_use import parameters_of
from lagdsl.exchange.fmi.variables.scalar import Attributes, Role, Scalar
from lagdsl.exchange.fmi.variables.settings import Settings
from lagdsl.foundation.units.dimension import ENERGY, POWER
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.model import FlatModel


def time() -> Scalar:
    attributes = Attributes(role=Role.TIME, causality="independent", unit="s", doc="time")
    return Scalar(name=Name("time"), first=0, attributes=attributes, initial=None)


def multipliers(flat: FlatModel) -> Iterator[Scalar]:
    """Of every row of constraints. The power of a row as written, or the work of a row of positions, is J/s or J."""
    rows = [(row, constraint) for constraint in flat.constraints for row in constraint.rows]
    for index, (row, constraint) in enumerate(rows):
        work = ENERGY if constraint.level == "position" else POWER
        doc = f"multiplier of {constraint.name}"
        if constraint.friction:
            doc = f"force of {constraint.name} while it sticks, zero while it slides"
        attributes = Attributes(role=Role.MULTIPLIER, unit=unit_text(work / constraint.dimension), doc=doc)
        yield Scalar(
            name=belonging(row, "multiplier"), first=index, attributes=attributes, initial="calculated", key=attributes
        )


def indicators(flat: FlatModel, program: Program, taken: Iterable[str]) -> Iterator[Scalar]:
    """Event indicators: they pass zero where something happens."""
    path = aside("indicator", taken)
    for index in range(indicator_count(flat, program)):
        attributes = Attributes(role=Role.INDICATOR, doc="event indicators")
        yield Scalar(
            name=Name(path, (index + 1,)), first=index, attributes=attributes, initial="calculated", key=attributes
        )


def indicator_count(flat: FlatModel, program: Program) -> int:
    """Relations that the motion changes, contacts, and dry friction."""
    return held_relations(flat, program).count(False) + len(flat.events.contacts) + len(flat.events.frictions)


def has_derivatives(program: Program) -> bool:
    """Directional derivatives: not where loads depend on the forces that they cause."""
    return not program.has("load")


def balance(flat: FlatModel, taken: Iterable[str]) -> Iterator[Scalar]:
    """Energies and, of models with constraints, residuals."""
    names = list(taken)
    energy, residual = aside("energy", names), aside("residual", names)
    words = {"total": "energy", "kinetic": "kinetic energy", "potential": "potential energy"}
    for index, (which, doc) in enumerate(words.items()):
        attributes = Attributes(role=Role.ENERGY, unit="J", doc=doc)
        yield Scalar(name=Name(f"{energy}.{which}"), first=index, attributes=attributes, initial="calculated")
    for index, which in enumerate(("position", "velocity") if flat.constraints else ()):
        doc = f"largest residual of constraints of {which} level over the sizes of their rows"
        attributes = Attributes(role=Role.RESIDUAL, unit="1", doc=doc)
        yield Scalar(name=Name(f"{residual}.{which}"), first=index, attributes=attributes, initial="calculated")


def clocks(flat: FlatModel, program: Program, known: Settings, taken: Iterable[str]) -> Iterator[Scalar]:
    """Of `sample`: periodic clocks, whose intervals are constant, or fixed where they follow parameters."""
    if not flat.events.clocks:
        return
    path = aside("clock", taken)
    firsts, periods = program.function("clock").results
    for index, (item, values) in enumerate(zip(flat.events.clocks, known.clocks, strict=True)):
        settled = not parameters_of(program, [firsts.elements[index], periods.elements[index]])
        attributes = Attributes(
            role=Role.CLOCK,
            type="CLOCK",
            causality="input",
            variability="discrete",
            setting="NEVER" if settled else "START",
            doc=item.name,
            interval=values if settled else None,
        )
        yield Scalar(name=Name(f"{path}.sample{index + 1}"), first=index, attributes=attributes, initial=None)


def options(taken: Iterable[str]) -> Iterator[Scalar]:
    """Settings of the integrator of co-simulation."""
    doc = "length of steps of fixed length; 0: steps with error control"
    attributes = Attributes(
        role=Role.OPTION,
        causality="parameter",
        variability="fixed",
        setting="START",
        unit="s",
        minimum=0.0,
        doc=doc,
    )
    name = Name(f"{aside('solver', taken)}.step")
    yield Scalar(name=name, first=0, attributes=attributes, initial="exact", start=0.0)
