"""E0501, E0508, E0513, W0514, W0525: everything declared must do something."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lagdsl.diagnostics import Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence, Orders
from lagdsl.flat.quantity import Item
from lagdsl.flat.spans import around, place
from lagdsl.flat.traversal import postorder
from lagdsl.record import record
from lagdsl.source import Span


def check_unused_coordinates(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0501 for coordinates in no physics item: outputs and drawings only look at them."""
    used = set(dependence.nothing.merged(*_physics(flat, dependence)))
    for coordinate in flat.coordinates:
        if coordinate.name not in used:
            sink.report("E0501", place(coordinate), *around(coordinate), name=coordinate.name)


def _physics(flat: fm.FlatModel, dependence: Dependence) -> Iterator[Orders]:
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


def load_expressions(load: fm.Load) -> list[fx.FlatExpression]:
    """The expressions of a load, its value first."""
    match load:
        case fm.PointForce():
            return [load.force, load.point] + ([load.origin] if load.origin is not None else [])
        case fm.FrameTorque():
            return [load.torque]
        case fm.GeneralizedForce():
            return [load.value, load.target] + ([load.origin] if load.origin is not None else [])


def load_frames(load: fm.Load) -> list[str]:
    """The frames a load acts on or refers to."""
    match load:
        case fm.PointForce():
            return [frame for frame in (load.frame, load.origin_frame) if frame is not None]
        case fm.FrameTorque():
            return [frame for frame in (load.frame, load.origin) if frame is not None]
        case fm.GeneralizedForce():
            return []


def check_effects(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """E0513 for a model in which nothing moves, E0508 for positions made of rates, W0514 for items without effect."""
    if not flat.coordinates and not flat.states:
        sink.report("E0513", _anywhere(flat))
        return
    for mass in flat.masses:
        _check_place(flat, mass, _Place("mass", "position of this mass", dependence.of(mass.position)), sink)
    for body in flat.bodies:
        _check_place(flat, body, _Place("body", "frame of this body", dependence.of_frame(body.frame)), sink)
    for load in flat.loads:
        keyword, displaced = _displaced(load, dependence)
        idle = _idle(load)
        if idle is not None:
            sink.report("W0514", place(load), *around(load), keyword=keyword, reason=idle)
            continue
        _check_place(flat, load, _Place(keyword, "place of this load", displaced), sink)


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
    orders: Orders


def _displaced(load: fm.Load, dependence: Dependence) -> tuple[str, Orders]:
    """Keyword of a load and what its virtual displacement depends on."""
    match load:
        case fm.PointForce():
            # A material point of a frame moves with the frame, wherever the force finds it.
            at = dependence.of(load.point) if load.frame is None else dependence.of_frame(load.frame)
            reaction = dependence.nothing if load.origin is None else dependence.of(load.origin)
            if load.origin_frame is not None:
                reaction = dependence.of_frame(load.origin_frame)
            return "force", at.merged(reaction)
        case fm.FrameTorque():
            frames = [frame for frame in (load.frame, load.origin) if frame is not None]
            turnings = (dependence.of_frame(frame, turning_only=True) for frame in frames)
            return "torque", dependence.nothing.merged(*turnings)
        case fm.GeneralizedForce():
            scalars = [load.target] + ([load.origin] if load.origin is not None else [])
            return load.keyword, dependence.of_all(scalars)


def _check_place(flat: fm.FlatModel, item: Item, where: _Place, sink: Sink) -> None:
    rates = set(where.orders.differentiated())
    rate = next((coordinate.name for coordinate in flat.coordinates if coordinate.name in rates), None)
    if rate is not None:
        sink.report("E0508", place(item), *around(item), what=where.words, rate=f"der({rate})", base=rate)
    elif not any(coordinate.name in where.orders for coordinate in flat.coordinates):
        reason = "no coordinate moves the place where it acts"
        sink.report("W0514", place(item), *around(item), keyword=where.keyword, reason=reason)


def check_reactions(flat: fm.FlatModel, sink: Sink) -> None:
    """W0525 where nothing that has mass, load or constraint is reached through a point whose reaction is asked for."""
    for point, item in _asked(flat).items():
        released = replace(flat, named=tuple(_as_variable(each) if each.name == point else each for each in flat.named))
        if not any(point in orders for orders in _physics(released, Dependence(released))):
            sink.report("W0525", place(item), *around(item), name=point)


def _as_variable(named: fm.Named) -> fm.Named:
    """A point that depends on nothing but itself."""
    return replace(named, position=fx.Variable(named.name)) if isinstance(named, fm.Point) else named


def _asked(flat: fm.FlatModel) -> dict[str, Item]:
    """Points whose reaction is asked for, each with the item that asks first."""
    definitions = (item for item in flat.named if isinstance(item, fm.Definition))
    asking: tuple[fm.Output | fm.Invariant | fm.Definition, ...] = (*flat.outputs, *flat.invariants, *definitions)
    asked: dict[str, Item] = {}
    seen: set[int] = set()
    for item in asking:
        for node in postorder(item.value, seen):
            seen.add(id(node))
            if isinstance(node, fx.ReactionAlong):
                asked.setdefault(node.point, item)
    return asked


def _anywhere(flat: fm.FlatModel) -> Span | None:
    items: tuple[Item, ...] = (
        *flat.parameters,
        *flat.inputs,
        *flat.named,
        *flat.masses,
        *flat.bodies,
        *flat.outputs,
    )
    return next((item.spans[-1] for item in items if item.spans), None)
