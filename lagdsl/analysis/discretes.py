"""Truths and contacts at an equilibrium."""

from __future__ import annotations

from lagdsl.analysis.point import Point, System
from lagdsl.diagnostics import Sink, failed
from lagdsl.flat.events import Contact, entries
from lagdsl.numerics.rank import Floats
from lagdsl.simulate.standing import standing
from lagdsl.simulate.state_words import time_text

_MOST_TOLD = 4


def discretes_at(system: System, point: Point) -> Floats:
    """w (nw,) as it is at the point; contacts that it lies beyond are closed in it."""
    state = (point.q, point.qd, point.z)
    found = standing(system.flat, system.engine, point.t, state, point.u, point.p)
    w = found.w.copy()
    w[list(found.pierced)] = 1.0
    return w


def refuse_pierced(system: System, point: Point) -> None:
    """E0834, as CompilationFailed, for contacts whose gap is negative: no motion begins there."""
    if not system.flat.events.contacts:
        return
    state = (point.q, point.qd, point.z)
    known = entries(system.flat.events)
    pierced = standing(system.flat, system.engine, point.t, state, point.u, point.p).pierced
    contacts = [item for item in (known[k].item for k in pierced) if isinstance(item, Contact)]
    if contacts:
        sink = Sink()
        names = ", ".join(f"`{contact.name}`" for contact in contacts)
        sink.report("E0834", contacts[0].spans[0] if contacts[0].spans else None, text=names, time=time_text(point.t))
        raise failed(sink.diagnostics)


def open_contacts(system: System, point: Point) -> list[str]:
    """A note on which contacts are open, if any: something may be meant to rest on one."""
    layout = system.engine.layout
    truths = zip(layout.discretes, layout.kinds, point.w.tolist(), strict=True)
    open_ = [slot.name[len("closed(") : -1] for slot, kind, value in truths if kind == "contact" and value == 0.0]
    if not open_:
        return []
    names = ", ".join(f"`{name}`" for name in open_[:_MOST_TOLD])
    return [f"open contacts: {names}; what is to rest on one starts where its gap is zero"]
