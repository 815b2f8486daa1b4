"""A run of the runtime for a flat model: what the model says, in the terms of lag/run.h."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.derivation.structure.scales import scales_of
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.run import Run, run_of
from lagdsl.engines.runtime.run_options import Measures, RunInputs, RunSettings
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import remembered
from lagdsl.language.flat.model import FlatModel

# Residuals below this part of the tolerance need no projection.
PROJECTION_PART = 1e-3
# The default tolerance of an invariant in integration tolerances.
_INVARIANT_FACTOR = 1e3
_NO_TIMES = np.zeros(0)


def placed(
    flat: FlatModel,
    engine: Engine,
    p: Floats,
    inputs: RunInputs,
    *,
    t0: float | None = None,
    q: Floats | None = None,
    times: Floats | None = None,
    tolerance: float | None = None,
    solver: str = "auto",
    step: float | None = None,
) -> Run:
    """A run that has not begun. Without `times` no rows are wanted, `q` (nq,) are the start values at t0 where they are
    known; the rest that is left out says the experiment."""
    t = flat.experiment.start_time if t0 is None else t0
    if q is None:
        q = start_values(engine, t, p)[0]
    settings = settings_of(
        flat, engine.layout, p, q, inputs, t=t, times=times, tolerance=tolerance, solver=solver, step=step
    )
    return run_of(engine.native, engine.layout, settings, engine.along)


def start_values(engine: Engine, t: float, p: Floats) -> tuple[Floats, Floats]:
    """Start values of coordinates (nq,) and defaults of inputs (nu,) for the parameters p at time t. Nobody may change
    them."""
    known, key = engine.native.starts, (t, p.tobytes())
    for before, found in known[:1]:
        if before == key:
            return found
    q, _, _, u = engine.evaluate("start", t, p)
    known[:] = [(key, (q, u))]
    return q, u


def settings_of(
    flat: FlatModel,
    layout: Layout,
    p: Floats,
    q: Floats,
    inputs: RunInputs,
    *,
    t: float,
    times: Floats | None,
    tolerance: float | None,
    solver: str,
    step: float | None,
) -> RunSettings:
    """Settings of a run; q (nq,) are the start values for the parameters p. With leading axes of p, q and the inputs
    those of many runs."""
    experiment = flat.experiment
    relative = experiment.tolerance if tolerance is None else tolerance
    factors, own = _tolerances(flat)
    asked = _NO_TIMES if times is None else times
    length = float(asked[-1] - asked[0]) if len(asked) > 1 else max(experiment.stop_time - t, np.spacing(abs(t)))
    return RunSettings(
        p=p,
        inputs=inputs,
        measures=_measures(flat, layout, q, t),
        times=asked,
        tolerance=relative,
        part=PROJECTION_PART,
        method=None if solver == "auto" else solver,
        step=step or 0.0,
        length=length,
        invariant_tolerance=factors * relative + own if len(own) else own,
    )


@remembered
def _tolerances(flat: FlatModel) -> tuple[Floats, Floats]:
    """Tolerances of the invariants, as parts of the tolerance of the integration, and in numbers of their own."""
    own = [i.tolerance for i in flat.invariants]
    factors = [_INVARIANT_FACTOR if tolerance is None else 0.0 for tolerance in own]
    return np.array(factors), np.array([tolerance or 0.0 for tolerance in own])


@remembered
def _last(flat: FlatModel) -> list[tuple[tuple[Layout, float, Floats], Measures]]:
    """Settings for the last start values, with these."""
    return []


def _measures(flat: FlatModel, layout: Layout, q: Floats, t: float) -> Measures:
    known = _last(flat)
    for (before, time, starts), measures in known[:1]:
        if before is layout and time == t and (starts is q or np.array_equal(starts, q)):
            return measures
    loose = contact_rows(flat)
    scales = scales_of(flat, layout.components, q)
    lasting = np.array([row not in loose for row in range(len(layout.constraints))], dtype=np.float64)
    for array in (scales.groups, scales.sizes, scales.caps, lasting):
        array.flags.writeable = False
    general = sum(not (flag or row in loose) for row, flag in enumerate(layout.redundant))
    measures = Measures(
        start=start_of(flat, t, ()),
        group=scales.groups,
        natural=scales.sizes,
        cap=scales.caps,
        lasting=lasting,
        general=general,
    )
    known[:] = [((layout, t, q), measures)]
    return measures
