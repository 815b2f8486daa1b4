"""A line on the integrator: the order at which its error falls with the step."""

from __future__ import annotations

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine, SingularSystem
from lagdsl.exchange.verify.certificate import Line
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.initialize import initial_state
from lagdsl.motion.simulate.simulate import simulate

_MOVING = ("coordinate", "rate", "state")
_METHOD, _ORDER = "rk4", 4
_MAY_DIFFER = 0.5
_TIMES = 4.0  # the span, in reciprocal eigenvalues at the start
_STEPS = (8, 16, 32, 64, 128, 256, 512)
_SHORTER = (1.0, 0.1, 0.01)  # where an event happens in the span
_ROUNDING = 1e-11
_PART = 1e-3
_MOST_STEPS = 5000
_LOOSE = 1e-2  # claims of the model are watched with a part of it: coarse steps break them


def order(flat: FlatModel, engine: Engine) -> Line:
    """Halving the step of the method of Runge and Kutta divides its error by 16 (Hairer, Noersett, Wanner, *Solving
    Ordinary Differential Equations I*, II.3): seen from three runs, log2 |x_h - x_h/2| / |x_h/2 - x_h/4|."""
    name = "order of the steps"
    says = f"halved steps of {_METHOD} show its order {_ORDER}; difference from it"
    if not flat.coordinates and not flat.states:
        return Line(name=name, says=says, note="nothing is free to move: no step has an error")
    try:
        span = _span(flat, engine)
        found = [each for part in _SHORTER if (each := _observed(flat, engine, part * span)) is not None]
    except (CompilationFailed, SimulationFailed, SingularSystem) as failure:
        told = failure.diagnostics[0].message if not isinstance(failure, SingularSystem) else "the start is singular"
        return Line(name=name, says=says, note=told)
    if not found:
        return Line(name=name, says=says, note="the first steps are exact, or events follow at once")
    best = min(found, key=lambda each: abs(each - _ORDER))  # a force may have a corner in one of the spans
    return Line(name=name, says=says, figure=abs(best - _ORDER), limit=_MAY_DIFFER, note=f"order {best:.2f}")


def _span(flat: FlatModel, engine: Engine) -> float:
    """Some reciprocal eigenvalues of the start, at most the experiment."""
    whole = flat.experiment.stop_time - flat.experiment.start_time
    start = initial_state(flat, engine)
    _, _, _, u = engine.evaluate("start", start.t, start.p)
    w = np.zeros(len(engine.layout.discretes))
    with np.errstate(all="ignore"):
        jacobian = engine.jacobian(start.t, start.q, start.qd, start.z, np.asarray(u), w, start.p)
    if not jacobian.size or not np.isfinite(jacobian).all():
        return 0.01 * whole
    rate = float(np.max(np.abs(np.linalg.eigvals(jacobian))))
    return min(whole, _TIMES / rate) if rate > 0.0 else whole


def _observed(flat: FlatModel, engine: Engine, span: float) -> float | None:
    """From the finest steps whose difference is no rounding; None where finer steps show another order still, or an
    event happens."""
    ends: list[Floats] = []
    scale: Floats | None = None
    seen: list[float] = []
    for steps in _STEPS:
        end = flat.experiment.start_time + span
        try:
            motion = _run(flat, engine, end, span, span / steps)
        except SimulationFailed:
            ends.clear()  # a claim of the model that coarse steps break
            continue
        if motion.events:
            return None
        scale = _scale(motion, span) if scale is None else scale
        ends.append(_end(motion))
        if len(ends) < 3:
            continue
        coarse, fine = (float(np.max(np.abs(a - b) / scale)) for a, b in ((ends[-3], ends[-2]), (ends[-2], ends[-1])))
        if not fine > _ROUNDING:
            break
        seen.append(float(np.log2(coarse / fine)) if coarse > 0.0 else -np.inf)
        if abs(seen[-1] - _ORDER) <= 0.1 * _MAY_DIFFER:
            return seen[-1]
    return seen[-1] if len(seen) > 1 and abs(seen[-1] - seen[-2]) <= _MAY_DIFFER else None


def _run(flat: FlatModel, engine: Engine, end: float, span: float, step: float) -> Trajectory:
    return simulate(
        engine,
        flat,
        stop=end,
        interval=span,
        solver=_METHOD,
        step=step,
        tolerance=_LOOSE,
        max_steps=_MOST_STEPS,
        sink=Sink(),
    )


def _end(motion: Trajectory) -> Floats:
    return np.array([float(column.values[-1]) for column in motion.columns if column.kind in _MOVING])


def _scale(motion: Trajectory, span: float) -> Floats:
    """Each by its largest value; nothing by less than a part of the largest of its kind, or a rate by less than one of
    the positions over the span."""
    found: list[float] = []
    least = 1e-30
    for kind in _MOVING:
        sizes = [max(abs(c.lowest), abs(c.highest)) for c in motion.columns if c.kind == kind]
        least = max([_PART * size for size in sizes] + [least])
        found += [max(size, least) for size in sizes]
        least = least / span if kind == "coordinate" else 1e-30
    return np.array(found)
