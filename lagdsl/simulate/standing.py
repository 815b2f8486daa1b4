"""The discretes of a model that stands at a state: as they would be where a motion begins there."""

from __future__ import annotations

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.numerics.rank import Floats
from lagdsl.record import record
from lagdsl.runtime.engines.engine import Engine
from lagdsl.runtime.structures import Status
from lagdsl.simulate.placed import placed


@record()
class Standing:
    """w (nw,), and the contacts whose gap is negative, by their entry in it."""

    w: Floats
    pierced: tuple[int, ...] = ()


def standing(
    flat: FlatModel, engine: Engine, t: float, state: tuple[Floats, Floats, Floats], u: Floats, p: Floats
) -> Standing:
    """At t and `state` (q, qd, z): relations as they stand, contacts that carry closed, clauses of the start and clocks
    that tick there gone through. Their effects on rates and states are left out."""
    if not engine.layout.discretes:
        return Standing(np.zeros(0))
    with np.errstate(all="ignore"):
        run = placed(flat, engine, p, u, t0=t)
        status = run.enter(t, np.concatenate(state))
        return Standing(run.w, tuple(run.guilty()) if status is Status.PENETRATION else ())
