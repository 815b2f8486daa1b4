"""The discretes of a model that stands at a state: as they would be where a motion begins there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_points import geometry
from lagdsl.record import record
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.events.contacts import Contacts
from lagdsl.simulate.events.discretes import Discretes
from lagdsl.simulate.events.happenings import Happenings
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.signals import steady


@record()
class Standing:
    """w (nw,), and the contacts whose gap is negative, by their place in the list of contacts."""

    w: Floats
    pierced: tuple[int, ...] = ()


def standing(
    flat: FlatModel, engine: Engine, t: float, state: tuple[Floats, Floats, Floats], u: Floats, p: Floats
) -> Standing:
    """At t and `state` (q, qd, z): relations as they stand, contacts that carry closed, clauses of the start and clocks
    that tick there gone through. What they would do to rates and states is left out."""
    w = np.zeros(len(engine.layout.discretes))
    if not len(w):
        return Standing(w)
    q, qd, z = state
    y = np.concatenate([q, qd, z])
    with np.errstate(all="ignore"):
        system = RightHandSide(engine, steady(u), w, p)
        space = replace(geometry(flat, engine, p), t=t, q=q, qd=qd)
        end = max(flat.experiment.stop_time, float(np.nextafter(t, np.inf)))
        found = Happenings(flat, system, Projection(system, space, 0.0), (t, end)).begin(t, y).w
        pierced = Contacts(Discretes(flat, system), end - t).pierced(t, y, found)
    return Standing(found, tuple(pierced))
