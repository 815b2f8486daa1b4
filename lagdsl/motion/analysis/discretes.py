"""Truths and contacts at an equilibrium."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.simulate.standing import standing

_MOST_TOLD = 4


def discretes_at(system: System, point: Point) -> Floats:
    """w (nw,) as it is at the point; contacts that it lies beyond are closed in it."""
    state = (point.q, point.qd, point.z)
    found = standing(system.flat, system.engine, point.t, state, point.u, point.p)
    w = found.w.copy()
    w[list(found.pierced)] = 1.0
    return w


def opened(system: System, point: Point, contact: str) -> Point:
    """The point with this contact open, and friction under it without a force."""
    places = {slot.name: place for place, slot in enumerate(system.engine.layout.discretes)}
    under = [friction for friction in system.flat.events.frictions if friction.contact == contact]
    w = point.w.copy()
    for name in (f"closed({contact})", *(n for friction in under for n in (friction.sticks, *friction.directions))):
        w[places[name]] = 0.0
    return replace(point, w=w)


def open_contacts(system: System, point: Point) -> list[str]:
    """A note on which contacts are open, if any: something may be meant to rest on one."""
    layout = system.engine.layout
    truths = zip(layout.discretes, layout.kinds, point.w.tolist(), strict=True)
    open_ = [slot.name[len("closed(") : -1] for slot, kind, value in truths if kind == "contact" and value == 0.0]
    if not open_:
        return []
    names = ", ".join(f"`{name}`" for name in open_[:_MOST_TOLD])
    return [f"open contacts: {names}; what is to rest on one starts where its gap is zero"]
