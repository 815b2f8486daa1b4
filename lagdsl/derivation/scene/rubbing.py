"""Places of dry friction: where its force acts as an arrow, and in which directions.

A slip that is the velocity of a point along a unit vector, or of two points towards each other, is a place: the force
acts on the point along the vector. That is seen in numbers, at random positions, so it holds for every text that says
the same. A slip of angles, of a lever or of shafts has no place.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from lagdsl.derivation.scene.machine import HELD, Machine, axes_at, fixed, in_axes, number, unit_vectors, vector
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import VELOCITY
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.events import Friction

# Parameters are changed by up to this part, so that a direction which follows one is not taken for a fixed one.
_SPREAD = 0.1
# Of so many points the velocities are looked at; pairs of these, too.
_MOST_POINTS = 48

Directions = tuple[fx.FlatExpression, ...]
_Traveling = tuple[fx.FlatExpression, Floats]
"""A point, and (positions, coordinates, 3) its velocity for a unit rate of each coordinate."""


@record()
class Place:
    """A point on which friction acts, and a unit vector for each component of its force."""

    at: fx.FlatExpression
    directions: Directions


class Rubbing:
    """Places of the frictions of a model."""

    def __init__(self, flat: fm.FlatModel) -> None:
        self._machine = Machine(flat)
        # At each position: everything at rest, then a unit rate of each coordinate.
        rates: list[dict[str, float]] = [{}, *({item.name: 1.0} for item in flat.coordinates)]
        self._at = [[self._machine.at(seed, each, parameters=_SPREAD) for each in rates] for seed in (0, 1)]
        self._frames = ["world", *(item.name for item in flat.named if isinstance(item, fm.Frame))]

    def places(self, friction: Friction) -> tuple[Place, ...]:
        """One, or two on which it acts in opposite senses; none where its slip is that of no point."""
        if friction.dimension != VELOCITY:
            return ()
        slips = self._changes([[[number(at, slip) for slip in friction.slips] for at in row] for row in self._at])
        for at, moves in (*self._known, *self._traveling(self._touching(friction))):
            directions = self._along(slips, moves)
            if directions is not None:
                return (Place(at, directions),)
        for (one, moves), (other, others) in combinations(self._known, 2):
            reached = _moves_with(moves) | _moves_with(others)
            directions = self._along(slips, moves - others) if np.all(reached[_moves_with(slips)]) else None
            if directions is not None:
                return Place(one, directions), Place(other, tuple(fx.Unary("-", each) for each in directions))
        return ()

    def _changes(self, found: list[list[Any]]) -> Floats:
        """(positions, coordinates, components) for a unit rate of each coordinate, of values at each moment."""
        values = np.array(found)
        return np.asarray(values[:, 1:] - values[:, :1])

    def _traveling(self, points: Iterable[tuple[fx.FlatExpression, fx.FlatExpression]]) -> Iterator[_Traveling]:
        """Points that move, of those with these velocities; their velocities have values."""
        for at, velocity in points:
            moves = self._changes([[vector(moment, velocity) for moment in row] for row in self._at])
            if np.isfinite(moves).all() and np.any(moves):
                yield at, moves

    @cached_property
    def _known(self) -> list[_Traveling]:
        """Named points, masses, origins of frames with a body, as far as they move."""
        places = sorted(self._machine.points, key=lambda at: not isinstance(at, fx.PointReference))
        return list(self._traveling((at, fx.Derivative(at)) for at in places[:_MOST_POINTS]))

    def _touching(self, friction: Friction) -> Iterator[tuple[fx.FlatExpression, fx.FlatExpression]]:
        """Points of bodies that touch, with the velocities of these there: the lowest one of a round shape over the
        plane of its contact, and named points of the component of the friction, as parts of each body."""
        machine, flat = self._machine, self._machine.flat
        contact = next((each for each in flat.events.contacts if each.name == friction.contact), None)
        for body in flat.bodies:
            origin = fx.FrameOrigin(body.frame)
            radius = machine.radius_at(origin)
            if contact is not None and radius is not None and not contact.one_way:
                own = machine.movers_of(contact.gap)
                normal = machine.normal_of(contact.gap, origin, own) if own else None
                if normal is not None:
                    rim = fx.Binary("+", origin, fx.Binary("*", radius, fixed(-normal)))
                    yield rim, fx.MaterialVelocity(rim, body.frame)
        component = (friction.contact or friction.name).rpartition(".")[0]
        for item in flat.named if component else ():
            if isinstance(item, fm.Point) and item.name.rpartition(".")[0] == component:
                point = fx.PointReference(item.name)
                yield from ((point, fx.MaterialVelocity(point, body.frame)) for body in flat.bodies)

    def _along(self, slips: Floats, moves: Floats) -> Directions | None:
        """Unit vectors e_k, orthogonal ones, with slip_k = e_k . velocity at all positions, fixed in a frame."""
        vectors = [each for each in map(unit_vectors, moves, slips) if each is not None]
        if len(vectors) < len(slips):
            return None
        for frame in self._frames:
            parts = [found @ axes_at(row[0], frame).T for found, row in zip(vectors, self._at, strict=True)]
            if max(float(np.abs(each - parts[0]).max()) for each in parts) <= HELD:
                return tuple(in_axes(frame, each) for each in parts[0])
        return None


def _moves_with(changes: Floats) -> Flags:
    """Coordinates (n,) that changes (positions, n, components) depend on."""
    return np.asarray(np.any(changes != 0.0, axis=(0, 2)))
