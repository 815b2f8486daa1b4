"""The state x = (q, qd, z) of an exported model, and its time derivatives. Dependent coordinates and their rates are
entries of x, and no states of the FMU."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import replace

from lagdsl.derivation.program.program import Program
from lagdsl.exchange.fmi.variables.attributes import attributes_of, bounds, rate_units
from lagdsl.exchange.fmi.variables.names import named
from lagdsl.exchange.fmi.variables.parameter_use import start_parameters
from lagdsl.exchange.fmi.variables.scalar import Attributes, Initial, Other, Role, Scalar
from lagdsl.exchange.fmi.variables.settings import Settings
from lagdsl.language.flat.model import Alias, Coordinate, FlatModel, State


def states(flat: FlatModel, program: Program, settings: Settings, dependent: Collection[int] = ()) -> Iterator[Scalar]:
    """q, qd and z. The rate of a coordinate is its derivative and a state itself. `dependent` are places of q."""
    n, x, others = len(flat.coordinates), settings.start.x, others_of(flat)
    initial, reset = _initials(flat, program), _reset(flat, program)

    def state(place: int, item: Coordinate | State) -> Scalar:
        follows = place in dependent
        attributes = _state_attributes(item, settings.nominal[place], x[place], follows=follows)
        return Scalar(
            name=named(item.name),
            first=place,
            attributes=attributes,
            initial=initial[place],
            start=x[place],
            key=attributes,
            reinit=reset[place] and not follows,
            others=others(item, 0),
        )

    yield from (state(place, item) for place, item in enumerate(flat.coordinates))
    for index, item in enumerate(flat.coordinates):
        follows = index in dependent
        attributes = _state_attributes(item, settings.nominal[index], x[index], follows=follows)
        yield Scalar(
            name=named(item.name, 1),
            first=n + index,
            attributes=_rate(item, attributes, 1, settings.nominal[n + index]),
            initial=initial[n + index],
            start=x[n + index],
            key=(attributes, settings.nominal[n + index]),
            derivative_of=None if follows else index,
            reinit=reset[n + index] and not follows,
            others=others(item, 1),
        )
    yield from (state(place, item) for place, item in enumerate(flat.states, 2 * n))


def derivatives(flat: FlatModel, settings: Settings, dependent: Collection[int] = ()) -> Iterator[Scalar]:
    """Of rates and of first-order states; `dependent` are places of q."""
    n, x, others = len(flat.coordinates), settings.start.x, others_of(flat)
    every: list[tuple[Coordinate | State, int, int]] = [
        *((item, index, 2) for index, item in enumerate(flat.coordinates)),
        *((item, 2 * n + index, 1) for index, item in enumerate(flat.states)),
    ]
    for item, own, order in every:
        follows = own in dependent
        attributes = _state_attributes(item, settings.nominal[own], x[own], follows=follows)
        of = own + n if order == 2 else own
        yield Scalar(
            name=named(item.name, order),
            first=of,
            attributes=replace(_rate(item, attributes, order, None), role=Role.DERIVATIVE, setting="NEVER"),
            initial="calculated",
            key=(attributes, settings.nominal[of]),
            derivative_of=None if follows else of,
            others=others(item, order),
        )


def others_of(flat: FlatModel) -> Callable[[Coordinate | State, int], tuple[Other, ...]]:
    """Other names of a coordinate, of its rate and of its acceleration."""
    found: dict[str, list[Alias]] = {}
    for alias in flat.aliases:
        found.setdefault(alias.of, []).append(alias)

    def others(item: Coordinate | State, order: int) -> tuple[Other, ...]:
        return tuple(
            Other(named(each.name, order), each.doc if order == 0 else _rate_text(each.name, order), each.protected)
            for each in found.get(item.name, ())
        )

    return others


def _rate_text(name: str, order: int) -> str:
    words = {1: "rate of change", 2: "second time derivative"}[order]
    return f"{words} of {name}"


def _state_attributes(item: Coordinate | State, nominal: float, start: float, *, follows: bool) -> Attributes:
    role = Role.DEPENDENT if follows else Role.STATE
    return replace(attributes_of(item, role), setting="START", nominal=nominal, **bounds(item, start))


def _rate(item: Coordinate | State, of: Attributes, order: int, nominal: float | None) -> Attributes:
    """Of the `order`-th time derivative of what has the attributes `of`."""
    unit, display_unit = rate_units(item, order)
    return replace(
        of,
        unit=unit,
        display_unit=display_unit,
        minimum=None,
        maximum=None,
        nominal=nominal,
        type_name=None,
        doc=_rate_text(item.name, order),
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
