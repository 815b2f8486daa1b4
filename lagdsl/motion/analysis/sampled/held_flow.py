"""The motion between ticks: linear in the minimal state, the signals that are held, and the inputs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.linearize import Reduced
from lagdsl.motion.analysis.point import Directions, Explicit, Flow, Point, System, changes, constraint_changes
from lagdsl.motion.analysis.sampled.moved import Borders, Place, moved
from lagdsl.motion.analysis.sampled.signals import Signals

_PARTS = {
    "position_constraint": 1,
    "velocity_constraint": 1,
    "residual": 2,
    "state_derivative": 1,
    "output": 1,
    "load": 1,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldFlow:
    """dx/dt = F + `rates` (x, w, u), y = `outputs` (x, w, u), of the deviations of minimal state, signals and inputs;
    `along` are the directions of these, one a row, in coordinates, rates, states and inputs. `borders` are
    those on which the derivatives by signals depend."""

    at: Reduced
    along: Directions
    rates: Floats
    outputs: Floats
    borders: Borders


def held_flow(system: System, at: Reduced, signals: Signals) -> HeldFlow:
    """`at` with the columns of the signals between those of the states and those of the inputs."""
    point, states = at.flow.point, len(at.value)
    if not len(signals):
        return HeldFlow(
            at=at, along=at.along, rates=np.hstack([at.a, at.b]), outputs=np.hstack([at.c, at.d]), borders=frozenset()
        )
    unit = np.zeros((len(signals), len(point.w)))
    unit[np.arange(len(signals)), list(signals.places)] = 1.0
    parts, borders = by_signals(system, at.flow, unit)
    phi, drift, motion, rows, zd, y, load = parts
    zeros = [np.zeros((len(signals), size)) for size in (len(point.q), len(point.qd), len(point.z), len(point.u))]
    chosen = at.partition
    q, qd = zeros[0], zeros[1]
    if len(chosen.jacobian):
        q = chosen.position_following(-phi.T[list(chosen.held)]).T
        followed = constraint_changes(system, point, Directions(q=q, qd=zeros[1], z=zeros[2], u=zeros[3]))[1]
        qd = chosen.rate_following(-(followed + drift).T).T
    own = Directions(q=q, qd=qd, z=zeros[2], u=zeros[3])
    found = changes(system, at.flow, own, Explicit(motion=motion, rows=rows, zd=zd, y=y, load=load))
    rates = np.hstack([qd[:, list(chosen.position)], found.qdd[:, list(chosen.rate)], found.zd]).T
    along = at.along
    stacked = [
        np.vstack([each[:states], mine, each[states:]])
        for each, mine in ((along.q, q), (along.qd, qd), (along.z, zeros[2]), (along.u, zeros[3]))
    ]
    return HeldFlow(
        at=at,
        along=Directions(q=stacked[0], qd=stacked[1], z=stacked[2], u=stacked[3]),
        rates=np.hstack([at.a, rates, at.b]),
        outputs=np.hstack([at.c, found.y.T, at.d]),
        borders=borders,
    )


def by_signals(system: System, flow: Flow, directions: Floats) -> tuple[list[Floats], Borders]:
    """Derivatives of phi, J qd + b, r, s, zd, y and loads along directions in w alone (k, nw), each (k, length)."""
    program = system.program
    blocks: list[Sequence[int]] = []
    for name, count in _PARTS.items():
        results = program.function(name).results if program.has(name) else ()
        blocks += [results[k].elements if results else () for k in range(count)]
    place = Place(values=values_at(flow.point, flow.qdd, flow.lam), tangents={Group.W: directions})
    found = moved(program.graph, [node for block in blocks for node in block], place)
    ends = np.cumsum([len(block) for block in blocks])[:-1]
    return list(np.split(found.tangents, ends, axis=1)), frozenset().union(*found.borders)


def values_at(point: Point, qdd: Floats, lam: Floats) -> dict[Group, Any]:
    """The symbols at a solved point."""
    return {
        Group.TIME: np.float64(point.t),
        Group.Q: point.q,
        Group.QD: point.qd,
        Group.Z: point.z,
        Group.U: point.u,
        Group.W: point.w,
        Group.P: point.p,
        Group.QDD: qdd,
        Group.LAMBDA: lam,
    }
