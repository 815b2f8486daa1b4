"""A model that stands at a state, as where a motion begins there: its discretes, and the state behind the events."""

from __future__ import annotations

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.messages import Course, report_fault
from lagdsl.motion.simulate.placed import placed

_SOUND = (Status.OK, Status.STOPPED, Status.SINGULAR, Status.NOT_FINITE)


@record()
class Standing:
    """w (nw,) and x = (q, qd, z) behind the events of the start; the contacts whose gap is negative, by their entry in
    w. Where these events fail, x is as it was given."""

    w: Floats
    x: Floats
    pierced: tuple[int, ...] = ()


def standing(
    flat: FlatModel,
    engine: Engine,
    t: float,
    state: tuple[Floats, Floats, Floats],
    u: Floats,
    p: Floats,
    sink: Sink | None = None,
) -> Standing:
    """At t and `state` (q, qd, z): relations as they stand, contacts that carry closed, clauses of the start and clocks
    that tick there gone through. Events that fail are told to `sink`; nothing is said of missing accelerations."""
    x = np.concatenate(state)
    if not engine.layout.discretes:
        return Standing(np.zeros(0), x)
    with np.errstate(all="ignore"):
        run = placed(flat, engine, p, u, t0=t)
        status = run.enter(t, x)
        if sink is not None and status not in _SOUND:
            report_fault(Course(flat, engine.layout, run, t, 0), status, run.explain(status), u, sink)
        pierced = tuple(run.guilty()) if status is Status.PENETRATION else ()
        return Standing(run.w, run.x if status in (Status.OK, Status.STOPPED) else x, pierced)
