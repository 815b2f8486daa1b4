"""Lines on the motion: constraints, friction, invariants, conserved quantities, a smaller tolerance."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.conserved.along import along
from lagdsl.exchange.verify.conserved.find import conserved_quantities
from lagdsl.exchange.verify.first_steps import first_steps
from lagdsl.exchange.verify.friction import friction
from lagdsl.exchange.verify.states import coordinate_sizes
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.initialize import initial_state
from lagdsl.motion.simulate.simulate import simulate

_ROWS = 201
# Of the motion that is looked at, with a tenth of its tolerance.
_MOST_STEPS = 100_000
_ON_CONSTRAINTS = 1e-6
_FINER = 0.1
# A coordinate with a range of this part of its natural size rests; its range is round-off.
_RESTS = 1e-12


def motion(compilation: Compilation, engine: Engine) -> Iterator[Line]:
    """The motion of the model's experiment, as far as _MOST_STEPS lead, and that with a tenth of its tolerance."""
    flat = compilation.flat
    name, says = "motion", "the motion of the experiment runs to its end"
    experiment = flat.experiment
    begin, tolerance = experiment.start_time, experiment.tolerance
    try:
        end = first_steps(engine, flat, _MOST_STEPS, _FINER * tolerance)
        interval = (end - begin) / (_ROWS - 1)
        found = simulate(engine, flat, stop=end, interval=interval)
        finer = simulate(engine, flat, stop=end, interval=interval, tolerance=_FINER * tolerance)
    except (CompilationFailed, SimulationFailed) as failure:
        yield Line(name=name, says=says, figure=1.0, limit=0.0, note=failure.diagnostics[0].message)
        return
    if end < experiment.stop_time:
        note = f"it takes more than {_MOST_STEPS} steps: the lines below are those of its part up to t = {end:.6g} s"
        yield Line(name=name, says=says, note=note)
    if flat.constraints:
        yield _on_constraints(found)
    yield from friction(compilation, interval, end)
    for invariant in found.invariants:
        yield Line(
            name=f"invariant {invariant.name}",
            says="what is claimed to be constant stays so along the motion",
            figure=invariant.drift,
            limit=invariant.limit,
        )
    quantities = conserved_quantities(compilation)
    if quantities:
        yield from along(compilation, quantities, found, initial_state(flat, engine).p, tolerance)
    yield _against_finer(found, finer, coordinate_sizes(flat, compilation.program, initial_state(flat, engine).p))


def _on_constraints(found: Trajectory) -> Line:
    size = max(
        (float(np.max(np.abs(c.values), initial=0.0)) for c in found.columns if c.kind == "coordinate"), default=1.0
    )
    residual = float(np.max(found.position_residual, initial=0.0))
    return Line(
        name="constraints",
        says="positions stay on the constraints; as a part of the largest coordinate",
        figure=residual / (size or 1.0),
        limit=_ON_CONSTRAINTS,
    )


def _against_finer(found: Trajectory, finer: Trajectory, sizes: Floats) -> Line:
    """The largest difference of a coordinate at the times that both have, as a part of its range, or of its natural
    size where it rests."""
    largest, where = 0.0, ""
    pairs = [pair for pair in zip(found.columns, finer.columns, strict=True) if pair[0].kind == "coordinate"]
    for (mine, other), size in zip(pairs, sizes.tolist(), strict=True):
        at = np.interp(found.time, finer.time, other.values)
        spread = mine.highest - mine.lowest
        spread = spread if spread > _RESTS * size else size
        part = float(np.max(np.abs(mine.values - at), initial=0.0)) / spread
        if part > largest:
            largest, where = part, f"largest in {mine.name}"
    return Line(
        name="a tenth of the tolerance",
        says="difference of a coordinate from the motion with a tenth of the tolerance, as a part of its range",
        figure=largest,
        note=where,
    )
