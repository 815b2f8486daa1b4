"""What a run is given, and the tools that its parts share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_points import Geometry, geometry
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.initialize import InitialState
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.signals import Signals
from lagdsl.simulate.watch import Watch

# Language reference, section 6.4: residuals below this part of the tolerance need no projection.
PROJECTION_PART = 1e-3
EPSILON = float(np.finfo(np.float64).eps)


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """Everything one run needs. `step`: length of the steps of methods that do not choose it."""

    flat: FlatModel
    engine: Engine
    p: Floats
    signals: Signals
    initial: InitialState
    times: Floats
    sink: Sink
    tolerance: float
    solver: str
    max_steps: int
    progress: Callable[[float], None] | None
    step: float | None = None

    @property
    def first(self) -> float:
        return float(self.times[0])

    @property
    def last(self) -> float:
        return float(self.times[-1])

    def too_short(self, t: float, step: float) -> bool:
        """Whether a step is no longer than the round-off of time."""
        return step < 16.0 * EPSILON * max(abs(t), self.last - self.first)


@dataclass(frozen=True, slots=True)
class Tools:
    """`exact` projects as well as the arithmetic allows, `projection` as well as the tolerance asks."""

    system: RightHandSide
    space: Geometry
    projection: Projection
    exact: Projection
    watch: Watch


@dataclass(frozen=True, slots=True)
class Reached:
    """A state from which no stepper has been started."""

    t: float
    y: Floats
    h_abs: float


def tools_of(task: Task) -> Tools:
    w = np.zeros(0)
    if task.engine.layout.discretes:
        w = task.engine.evaluate("discrete_start", task.initial.t, task.p)[0].copy()
    system = RightHandSide(task.engine, task.signals, w, task.p)
    space = replace(geometry(task.flat, task.engine, task.p), t=task.initial.t, q=task.initial.q, qd=task.initial.qd)
    return Tools(
        system=system,
        space=space,
        projection=Projection(system, space, PROJECTION_PART * task.tolerance),
        exact=Projection(system, space, 0.0),
        watch=Watch(task.flat, task.engine, system, task.tolerance),
    )
