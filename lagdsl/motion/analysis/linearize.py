"""Linearization on the minimal state x = (y, v, z): independent coordinates and rates, and first-order states.

dx/dt = F(x, u, t) is the flow in the chart of `partition`; A, B, C, D are its exact derivatives and those of the
outputs. Since the chart is made of coordinates of the model, d(dy)/dt and d(dv)/dt are the same entries of dqd and
dqdd, at an equilibrium as well as at any other point.
Sources: Negrut and Ortiz, A practical approach for the linearization of the constrained multibody dynamics equations,
Journal of Computational and Nonlinear Dynamics 1 (2006) 230-239; with rows of velocity level: Meijaard, Papadopoulos,
Ruina and Schwab, Linearized dynamics equations for the balance and steer of a bicycle, Proceedings of the Royal
Society A 463 (2007) 1955-1982, appendix.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.naming import rate_text
from lagdsl.motion.analysis.partition import Partition, directions, partition
from lagdsl.motion.analysis.point import Directions, Flow, Point, System, changes, flow


@dataclass(frozen=True, slots=True)
class Named:
    """One entry of a vector: its name and its coherent SI unit."""

    name: str
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Reduced:
    """The reduced flow at a point: F (nx,), and A, B, C, D; `along` are the directions of states, then inputs.

    y, C and D have no rows where outputs were not asked for.
    """

    flow: Flow
    partition: Partition
    along: Directions
    value: Floats
    a: Floats
    b: Floats
    c: Floats
    d: Floats


def holonomic_rows(system: System) -> list[int]:
    """Rows that restrict positions by themselves."""
    return [row for row, level in enumerate(system.engine.layout.position_level) if level]


def reduce(
    system: System,
    point: Point,
    held: Sequence[int],
    sink: Sink,
    chart: Partition | None = None,
    *,
    outputs: bool = True,
) -> Reduced | None:
    """A, B, C, D at `point`, in the best chart there or in that of `chart`; None after E0850, E0851, E0855.

    Small motions have no need of `outputs`, which may have no derivative, as the norm of a vector that is zero.
    """
    with np.errstate(all="ignore"):
        here = flow(system, point, sink)
        chosen = None if here is None else partition(system, point, held, sink)
        if here is None or chosen is None:
            return None
        if chart is not None:
            chosen = Partition(chart.position, chart.rate, chart.held, chosen.jacobian, chart.sizes)
        along = directions(system, point, chosen, len(point.u))
        found = changes(system, here, along)
    position, rate = list(chosen.position), list(chosen.rate)
    value = np.concatenate([point.qd[position], here.qdd[rate], here.zd])
    rates = np.hstack([along.qd[:, position], found.qdd[:, rate], found.zd]).T
    states = len(value)
    told = len(here.y) if outputs else 0
    whole = np.vstack([rates, found.y.T[:told]])
    if not np.all(np.isfinite(whole)) or not np.all(np.isfinite(value)):
        _report_infinite(system, chosen, whole, value, sink)
        return None
    return Reduced(
        flow=replace(here, y=here.y[:told]),
        partition=chosen,
        along=along,
        value=value,
        a=whole[:states, :states],
        b=whole[:states, states:],
        c=whole[states:, :states],
        d=whole[states:, states:],
    )


def state_names(system: System, chosen: Partition) -> tuple[Named, ...]:
    """Names and units of the minimal state: `theta`, `der(theta)`, first-order states."""
    coordinates, states = system.flat.coordinates, system.flat.states
    return (
        *(Named(coordinates[j].name, coordinates[j].unit) for j in chosen.position),
        *(Named(f"der({c.name})", rate_text(c.dimension, c.unit)) for c in (coordinates[j] for j in chosen.rate)),
        *(Named(state.name, state.unit) for state in states),
    )


def _report_infinite(system: System, chosen: Partition, whole: Floats, value: Floats, sink: Sink) -> None:
    """E0855 at the first entry that is not finite."""
    names = [*(f"the rate of `{n.name}`" for n in state_names(system, chosen))]
    names += [f"the output `{slot.name}`" for slot in system.engine.layout.outputs]
    finite = np.all(np.isfinite(whole), axis=1)
    finite[: len(value)] &= np.isfinite(value)
    sink.report("E0855", None, name=names[int(np.argmin(finite))])
