"""Everything declared must do something (E0501, E0508, W0514)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence, Orders
from lagdsl.language.flat.spans import around, place
from lagdsl.language.semantics.wellformed.readings import Readings, read_by


def check_unused_coordinates(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0501 for coordinates in no physics item: outputs and drawings only look at them."""
    used = set(dependence.nothing.merged(*physics(flat, dependence)))
    for coordinate in flat.coordinates:
        if coordinate.name not in used:
            sink.report("E0501", place(coordinate), *around(coordinate), name=coordinate.name)


def physics(flat: fm.FlatModel, dependence: Dependence) -> Iterator[Orders]:
    """Of each item of the physics, the quantities that it depends on."""
    for term in flat.energies:
        yield dependence.of(term.value)
    for mass in flat.masses:
        yield dependence.of(mass.position)
    for body in flat.bodies:
        yield dependence.of_frame(body.frame)
    for constraint in flat.constraints:
        if not constraint.normalisation:
            yield dependence.of_all(constraint.residuals)
    for state in flat.states:
        yield dependence.of(state.derivative)
    for load in flat.loads:
        yield dependence.of_all(load_expressions(load))
        yield from (dependence.of_frame(frame) for frame in load_frames(load))
    for feedback in flat.events.feedbacks:
        yield dependence.of(feedback.value)
    for delay in flat.events.delays:
        yield dependence.of(delay.value)


def load_expressions(load: fm.Load) -> list[fx.FlatExpression]:
    """The expressions of a load, its value first."""
    match load:
        case fm.PointForce():
            return [load.force, load.point] + ([load.origin] if load.origin is not None else [])
        case fm.FrameTorque():
            return [load.torque]
        case fm.GeneralizedForce():
            return [load.value, load.target] + ([load.origin] if load.origin is not None else [])
        case fm.RateForce():
            return [load.value, load.rate]


def load_frames(load: fm.Load) -> list[str]:
    """The frames a load acts on or refers to."""
    match load:
        case fm.PointForce():
            return [frame for frame in (load.frame, load.origin_frame) if frame is not None]
        case fm.FrameTorque():
            return [frame for frame in (load.frame, load.origin) if frame is not None]
        case fm.GeneralizedForce() | fm.RateForce():
            return []


def check_effects(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0508 for positions made of rates, W0514 for items that change neither the motion nor what the model reads of
    reactions and energies."""
    readings = cache(lambda: read_by(flat))
    coordinates = {coordinate.name: number for number, coordinate in enumerate(flat.coordinates)}
    for mass in flat.masses:
        where = _Place("mass", "position of this mass", partial(_place_of_mass, mass))
        _check_place(coordinates, mass, where, dependence, readings, sink)
    for body in flat.bodies:
        where = _Place("body", "frame of this body", partial(_place_of_body, body))
        _check_place(coordinates, body, where, dependence, readings, sink)
    for load in flat.loads:
        keyword = load_keyword(load)
        idle = _idle(load)
        if idle is not None:
            sink.report("W0514", place(load), *around(load), keyword=keyword, reason=idle)
            continue
        where = _Place(keyword, "place of this load", partial(displaced, load))
        _check_place(coordinates, load, where, dependence, readings, sink)


def _place_of_mass(mass: fm.PointMass, dependence: Dependence) -> Orders:
    return dependence.of(mass.position)


def _place_of_body(body: fm.RigidBody, dependence: Dependence) -> Orders:
    return dependence.of_frame(body.frame)


def _idle(load: fm.Load) -> str | None:
    """Why a load does nothing whatever moves: it is written as zero, or it acts from a place on that place."""
    value, *places = load_expressions(load)
    same = not isinstance(load, fm.FrameTorque) and len(places) == 2 and places[0] == places[1]
    if isinstance(load, fm.PointForce):
        same = same and load.frame == load.origin_frame
    if isinstance(load, fm.FrameTorque):
        same = load.frame == load.origin
    if value in (fx.ZERO, fx.ZERO_VECTOR):
        return "it is zero"
    return "it acts from a place on the same place" if same else None


@record()
class _Place:
    """Place at which an item acts: its keyword, the place in words, and the quantities that the place depends on."""

    keyword: str
    words: str
    orders: Callable[[Dependence], Orders]


def load_keyword(load: fm.Load) -> str:
    """The statement that a load is."""
    match load:
        case fm.PointForce():
            return "force"
        case fm.FrameTorque():
            return "torque"
        case fm.GeneralizedForce():
            return load.keyword
        case fm.RateForce():
            return "friction"


def displaced(load: fm.Load, dependence: Dependence) -> Orders:
    """The quantities on which the virtual displacement of a load depends."""
    match load:
        case fm.PointForce():
            # A material point of a frame moves with the frame, wherever the force finds it.
            at = dependence.of(load.point) if load.frame is None else dependence.of_frame(load.frame)
            reaction = dependence.nothing if load.origin is None else dependence.of(load.origin)
            if load.origin_frame is not None:
                reaction = dependence.of_frame(load.origin_frame)
            return at.merged(reaction)
        case fm.FrameTorque():
            frames = [frame for frame in (load.frame, load.origin) if frame is not None]
            turnings = (dependence.of_frame(frame, turning_only=True) for frame in frames)
            return dependence.nothing.merged(*turnings)
        case fm.GeneralizedForce():
            scalars = [load.target] + ([load.origin] if load.origin is not None else [])
            return dependence.of_all(scalars)
        case fm.RateForce():
            return dependence.of(load.rate)


def _check_place(
    coordinates: Mapping[str, int],
    item: fm.PointMass | fm.RigidBody | fm.Load,
    where: _Place,
    dependence: Dependence,
    readings: Callable[[], Readings],
    sink: Sink,
) -> None:
    orders = where.orders(dependence)
    if isinstance(item, fm.RateForce):
        if coordinates.keys().isdisjoint(orders.differentiated()):
            reason = "no coordinate changes the rate on which it acts"
            sink.report("W0514", place(item), *around(item), keyword=where.keyword, reason=reason)
        return
    rates = (name for name in orders.differentiated() if name in coordinates)
    rate = min(rates, key=coordinates.__getitem__, default=None)
    if rate is not None:
        sink.report("E0508", place(item), *around(item), what=where.words, rate=f"der({rate})", base=rate)
        return
    if not coordinates.keys().isdisjoint(orders):
        return
    read = readings()
    of_all_masses = read.masses and isinstance(item, fm.PointMass | fm.RigidBody)
    if not of_all_masses and read.released.isdisjoint(where.orders(read.dependence)):
        reason = "no coordinate moves the place where it acts"
        sink.report("W0514", place(item), *around(item), keyword=where.keyword, reason=reason)
