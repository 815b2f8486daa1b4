"""Places that friction holds while it sticks, and friction that holds what stands still."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.friction import friction_forces, placed_frictions
from lagdsl.motion.analysis.integrable import integrable_rows
from lagdsl.motion.analysis.point import Point, System, coordinate_sizes, flow

# Slips, accelerations and forces beyond a limit that count as none, as parts of natural sizes or of the limit.
_NONE = 1e-9
# Nodes of the integral of a slip over a way: it is smooth.
_NODES = 12
_MOST_TOLD = 4
_OF_FRICTION = ("sticks", "direction", "load")


@dataclass(frozen=True, slots=True)
class Grip:
    """Rows of friction that sticks, whose slips are the rates of positions; `anchor` are the coordinates (nq,) at which
    these positions are held."""

    rows: tuple[int, ...]
    anchor: Floats

    def way(self, system: System, point: Point) -> tuple[Floats, Floats]:
        """The positions (k,) less the held ones, by the integral of the slips over the straight way from the anchor,
        and their Jacobian (k, nq): as integrals of exact forms they depend on no other way."""
        if not self.rows:
            return np.zeros(0), np.zeros((0, len(point.q)))
        nodes, weights = np.polynomial.legendre.leggauss(_NODES)
        along, total = point.q - self.anchor, np.zeros(len(self.rows))
        for node, weight in zip((nodes + 1.0) / 2.0, weights / 2.0, strict=True):
            total += weight * self._slips(system, replace(point, q=self.anchor + node * along)) @ along
        return total, self._slips(system, point)

    def at(self, system: System, point: Point) -> Grip:
        """That of the frictions which still stick in the mode of a point."""
        sticking = _sticking_rows(system, point)
        return replace(self, rows=tuple(row for row in self.rows if row in sticking))

    def _slips(self, system: System, point: Point) -> Floats:
        return np.asarray(system.engine.evaluate("velocity_constraint", *point.arguments)[1][list(self.rows)])


def grip_at(system: System, point: Point) -> Grip:
    """The grip of what sticks at a point."""
    rows = _sticking_rows(system, point)
    return Grip(tuple(row for row in integrable_rows(system, point) if row in rows) if rows else (), point.q)


def gripping(system: System, point: Point, w: Floats) -> Point | None:
    """An equilibrium with every friction that has no slip holding there, where `w` are the discretes as a motion would
    begin with them; None where they differ in more than friction, or where the forces that hold, or an acceleration,
    contradict it."""
    frictions = system.flat.events.frictions
    if not frictions or np.any(point.qd):
        return None
    own = np.array([kind in _OF_FRICTION for kind in system.engine.layout.kinds])
    if not np.array_equal(w[~own], point.w[~own]):
        return None
    held = replace(point, w=_holding(system, replace(point, w=w)))
    with np.errstate(all="ignore"):
        here = flow(system, held, Sink())
        if here is None or np.any(np.abs(here.qdd) > _NONE * coordinate_sizes(system, point.p)):
            return None
        forces = friction_forces(system, here)
    return here.point if all(each.size <= (1.0 + _NONE) * each.limit for each in forces) else None


def unheld(system: System, point: Point) -> list[str]:
    """A note on friction that would have to hold more than it bears at the point, if any."""
    if not system.flat.events.frictions or np.any(point.qd):
        return []
    with np.errstate(all="ignore"):
        here = flow(system, replace(point, w=_holding(system, point)), Sink())
        forces = () if here is None else friction_forces(system, here)
    told = [
        f"`{each.name}` would have to hold {each.size:.4g} {each.unit} and bears {each.limit:.4g} {each.unit}"
        for each in forces
        if each.size > (1.0 + _NONE) * each.limit
    ]
    return [f"beyond dry friction: {'; '.join(told[:_MOST_TOLD])}"] if told else []


def _holding(system: System, point: Point) -> Floats:
    """The discretes with each friction sticking that acts and has no slip at rest."""
    w = point.w.copy()
    nothing = (np.zeros_like(point.q), np.zeros(len(system.engine.layout.constraints)))
    slips, jacobian, *_ = system.engine.evaluate("friction", *point.arguments, *nothing)
    fast = np.abs(slips) > _NONE * np.abs(jacobian) @ coordinate_sizes(system, point.p)
    for each in placed_frictions(system, point.w):
        if each.acts and not np.any(fast[each.slips]):
            w[each.sticks] = 1.0
            w[list(each.directions)] = 0.0
    return w


def _sticking_rows(system: System, point: Point) -> set[int]:
    rows = system.engine.layout.instants.friction_rows
    sticking = (each for each in placed_frictions(system, point.w) if point.w[each.sticks] != 0.0)
    return {row for each in sticking for row in rows[each.slips]}
