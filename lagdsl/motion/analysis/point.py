"""The state that a model is linearized at, and what the program says there, derivatives along directions included."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.points import natural_sizes
from lagdsl.engines.backends.python.sizes import motion_sizes
from lagdsl.engines.backends.python.support.feedback import LoadsNotFound, changes_with_loads, with_loads
from lagdsl.engines.backends.python.support.linear import factorize
from lagdsl.engines.backends.start import free_parameters
from lagdsl.engines.runtime.engines.broadcast import BatchEngine, solving
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.initialize import initial_state
from lagdsl.motion.simulate.standing import standing


@dataclass(frozen=True, slots=True)
class System:
    """A compiled model and what computes it."""

    flat: FlatModel
    program: Program
    engine: BatchEngine


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """A state, inputs and parameters in the order of the layout, SI units."""

    t: float
    q: Floats
    qd: Floats
    z: Floats
    u: Floats
    w: Floats
    p: Floats

    @property
    def arguments(self) -> tuple[float, Floats, Floats, Floats, Floats, Floats, Floats]:
        return (self.t, self.q, self.qd, self.z, self.u, self.w, self.p)


def point_of(
    system: System,
    *,
    t: float | None = None,
    start: Mapping[str, float] | None = None,
    u: Floats | None = None,
    p: Floats | None = None,
    given: bool = False,
    begins: bool = True,
    sink: Sink | None = None,
) -> Point:
    """The state that a motion begins with: the consistent one nearest to the starts, of which `start` replaces some by
    name, `theta` or `der(theta)`, behind the events of the start. Contacts that carry are closed, all others open.

    Not `begins`: these events set discretes only, no rates and states. `given`: the starts are chosen by the caller,
    and initial equations are left out; free parameters are then those that the start of the model asks for. Raises
    CompilationFailed, also where these events fail: inside of a contact, at an assertion.
    """
    flat, own = system.flat, Sink()
    parameters = np.array(system.engine.layout.defaults, dtype=np.float64) if p is None else p
    if given and free_parameters(flat):
        parameters = initial_state(flat, system.engine, parameters, u=u, sink=own).p
        own.raise_if_errors()
    if given:
        flat = replace(flat, initial_equations=(), parameters=tuple(replace(p, free=False) for p in flat.parameters))
    state = initial_state(flat, system.engine, parameters, t0=t, u=u, start=start, sink=own)
    parameters = state.p
    if sink is not None:
        for diagnostic in own.diagnostics:
            sink.add(diagnostic)
    own.raise_if_errors()
    defaults = system.engine.evaluate("start", state.t, parameters)[3]
    inputs = defaults if u is None else u
    failing = Sink()
    at = (state.q, state.qd, state.z)
    found = standing(flat, system.engine, state.t, at, inputs, parameters, failing if begins else None)
    failing.raise_if_errors()
    n = len(state.q)
    q, qd, z = np.split(found.x if begins else state.x, [n, 2 * n])
    return Point(t=state.t, q=q, qd=qd, z=z, u=inputs, w=found.w, p=parameters)


def coordinate_sizes(system: System, p: Floats) -> Floats:
    """Natural sizes of the coordinates, from the start values of the model: they do not depend on the point."""
    start = system.engine.evaluate("start", system.flat.experiment.start_time, p)[0]
    return natural_sizes(system.flat.coordinates, system.engine.layout.components, start)


@dataclass(frozen=True, slots=True)
class Flow:
    """The solved motion at a point: accelerations, multipliers, rates of states, outputs."""

    point: Point
    qdd: Floats
    lam: Floats
    zd: Floats
    y: Floats


def flow(system: System, point: Point, sink: Sink) -> Flow | None:
    """The solved motion at `point`; E0851 where it is not determined, E0855 where it is not finite."""
    engine, count = system.engine, motion_sizes(system.program).loads
    try:
        if count:
            solve = solving(system.program, engine)
            *_, w, _ = with_loads(engine.evaluate_many, solve, count, *map(np.asarray, point.arguments))
            point = replace(point, w=w)
        qdd, lam = engine.solve(*point.arguments)
    except LoadsNotFound:
        sink.report("E0855", None, name=f"the load `{system.flat.events.feedbacks[0].name}`")
        return None
    except SingularSystem as singular:
        slot = engine.layout.coordinates[singular.coordinate]
        sink.report("E0851", system.flat.coordinates[singular.coordinate].spans[0], name=slot.name)
        return None
    (zd,) = engine.evaluate("state_derivative", *point.arguments, qdd, lam)
    (y,) = engine.evaluate("output", *point.arguments, qdd, lam)
    return Flow(point, qdd, lam, zd, y)


@dataclass(frozen=True, slots=True, kw_only=True)
class Directions:
    """`count` directions in the space of states and inputs, one per row: (count, nq), (count, nq), (count, nz) ..."""

    q: Floats
    qd: Floats
    z: Floats
    u: Floats

    @property
    def count(self) -> int:
        return len(self.q)

    def arguments(self, parameters: int) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        return (self.q, self.qd, self.z, self.u, np.zeros((self.count, parameters)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Changes:
    """Derivatives of the flow along directions, one per row."""

    qdd: Floats
    lam: Floats
    zd: Floats
    y: Floats


@dataclass(frozen=True, slots=True, kw_only=True)
class Explicit:
    """Derivatives along directions of what the model does not differentiate itself, as by discretes; one per row: of r
    and s at fixed accelerations and multipliers, of rates of states, outputs and loads."""

    motion: Floats
    rows: Floats
    zd: Floats
    y: Floats
    load: Floats


def constraint_changes(system: System, point: Point, along: Directions) -> tuple[Floats, Floats]:
    """Derivatives of phi and of J qd + b along directions, both (count, nc)."""
    found = system.engine.evaluate_many("constraint_tangent", *point.arguments, *along.arguments(len(point.p)))
    return found[0], found[1]


def changes(system: System, at: Flow, along: Directions, explicit: Explicit | None = None) -> Changes:
    """Exact derivatives of accelerations, multipliers, rates of states and outputs.

    With r = M qdd - f - J'lam = 0 and s = J qdd - gamma = 0, differentiated by the model at fixed qdd and lam:
    M dqdd - J'dlam = -dr and J dqdd = -ds. The part of dr that holds lam is the stiffness of the constraint forces.
    Loads that depend on accelerations or multipliers follow these. `explicit` is added.
    """
    engine, point = system.engine, at.point
    directions = along.arguments(len(point.p))
    solved = (*point.arguments, at.qdd, at.lam)
    motion, rows = engine.evaluate_many("residual_tangent", *solved, *directions)
    if explicit is not None:
        motion, rows = motion + explicit.motion, rows + explicit.rows
    mass, _, jacobian, _ = engine.evaluate("dynamics", *point.arguments)
    sizes = motion_sizes(system.program)

    def evaluate(name: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        found = engine.evaluate_many(name, *arguments)
        asked = name == "load_tangent" and explicit is not None
        return (found[0] + explicit.load,) if asked and explicit is not None else found

    factors, _ = factorize(mass, jacobian, sizes.rank)
    dqdd, dlam = (np.ascontiguousarray(part.T) for part in factors.solve(-motion.T, -rows.T))
    loads = np.zeros((along.count, 0))
    if sizes.loads:
        here = tuple(map(np.asarray, solved))
        dqdd, dlam, loads = changes_with_loads(evaluate, factors, here, directions, (dqdd, dlam))
    (zd,) = engine.evaluate_many("state_derivative_tangent", *solved, *directions, dqdd, dlam)
    (y,) = engine.evaluate_many("output_tangent", *solved, *directions, dqdd, dlam)
    if sizes.loads:
        _, of_rates, of_outputs, _ = engine.evaluate("load_gain", *solved)
        zd, y = zd + loads @ of_rates.T, y + loads @ of_outputs.T
    if explicit is not None:
        zd, y = zd + explicit.zd, y + explicit.y
    return Changes(qdd=dqdd, lam=dlam, zd=zd, y=y)
