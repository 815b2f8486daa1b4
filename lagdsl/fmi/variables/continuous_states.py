"""The continuous states of an exported model, x = (q, qd, z), and their time derivatives."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lagdsl.flat.model import Coordinate, FlatModel, State
from lagdsl.fmi.variables.attributes import attributes_of, bounds, rate_units
from lagdsl.fmi.variables.names import named
from lagdsl.fmi.variables.parameter_use import start_parameters
from lagdsl.fmi.variables.scalar import Attributes, Initial, Role, Scalar
from lagdsl.fmi.variables.settings import Settings
from lagdsl.program.program import Program


def states(flat: FlatModel, program: Program, settings: Settings) -> Iterator[Scalar]:
    """q, qd and z. The rate of a coordinate is its derivative and a state itself."""
    n, x = len(flat.coordinates), settings.start.x
    initial, reset = _initials(flat, program), _reset(flat, program)

    def state(place: int, item: Coordinate | State) -> Scalar:
        attributes = _state_attributes(item, settings.nominal[place], x[place])
        return Scalar(
            name=named(item.name),
            first=place,
            attributes=attributes,
            initial=initial[place],
            start=x[place],
            key=attributes,
            reinit=reset[place],
        )

    yield from (state(place, item) for place, item in enumerate(flat.coordinates))
    for index, item in enumerate(flat.coordinates):
        attributes = _state_attributes(item, settings.nominal[index], x[index])
        yield Scalar(
            name=named(item.name, 1),
            first=n + index,
            attributes=_rate(item, attributes, 1, settings.nominal[n + index]),
            initial=initial[n + index],
            start=x[n + index],
            key=(attributes, settings.nominal[n + index]),
            derivative_of=index,
            reinit=reset[n + index],
        )
    yield from (state(place, item) for place, item in enumerate(flat.states, 2 * n))


def derivatives(flat: FlatModel, settings: Settings) -> Iterator[Scalar]:
    """Of rates and of first-order states."""
    n, x = len(flat.coordinates), settings.start.x
    every: list[tuple[Coordinate | State, int, int]] = [
        *((item, index, 2) for index, item in enumerate(flat.coordinates)),
        *((item, 2 * n + index, 1) for index, item in enumerate(flat.states)),
    ]
    for item, own, order in every:
        attributes = _state_attributes(item, settings.nominal[own], x[own])
        of = own + n if order == 2 else own
        yield Scalar(
            name=named(item.name, order),
            first=of,
            attributes=replace(_rate(item, attributes, order, None), role=Role.DERIVATIVE, setting="NEVER"),
            initial="calculated",
            key=(attributes, settings.nominal[of]),
            derivative_of=of,
        )


def _state_attributes(item: Coordinate | State, nominal: float, start: float) -> Attributes:
    return replace(attributes_of(item, Role.STATE), setting="START", nominal=nominal, **bounds(item, start))


def _rate(item: Coordinate | State, of: Attributes, order: int, nominal: float | None) -> Attributes:
    """Of the `order`-th time derivative of what has the attributes `of`."""
    unit, display_unit = rate_units(item, order)
    words = {1: "rate of change", 2: "second time derivative"}[order]
    return replace(
        of,
        unit=unit,
        display_unit=display_unit,
        minimum=None,
        maximum=None,
        nominal=nominal,
        type_name=None,
        doc=f"{words} of {item.name}",
    )


def _initials(flat: FlatModel, program: Program) -> list[Initial]:
    """By entry of x: `exact` where the start value holds whatever the others are, else `approx`: it follows parameters,
    or is where the search for a consistent state begins."""
    free = not flat.constraints and not flat.initial_equations
    holds = [
        *(free or c.fixed for c in flat.coordinates),
        *(free or c.rate_fixed for c in flat.coordinates),
        *(not flat.initial_equations or s.fixed for s in flat.states),
    ]
    follows = start_parameters(program)
    return ["exact" if held and not read else "approx" for held, read in zip(holds, follows, strict=True)]


def _reset(flat: FlatModel, program: Program) -> list[bool]:
    """By entry of x: whether an event may change it. Projection onto constraints moves coordinates and rates."""
    n, count = len(flat.coordinates), len(flat.states)
    tied = bool(flat.constraints)
    struck = tied or any(f.name == "contact" and f.results[0].elements for f in program.functions)
    places = set(program.layout.instants.reset_places)
    return [moved or place in places for place, moved in enumerate([*[tied] * n, *[struck] * n, *[False] * count])]
