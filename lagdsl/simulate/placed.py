"""A run of the runtime for a flat model: what the model says, in the terms of lag/run.h."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.backends.start import start_of
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import contact_rows
from lagdsl.runtime.engine import Engine
from lagdsl.runtime.run import Run, RunSettings
from lagdsl.simulate.scales import scales_of

# Language reference, section 6.4: residuals below this part of the tolerance need no projection.
PROJECTION_PART = 1e-3
# Ruling 32: the default tolerance of an invariant in integration tolerances.
_INVARIANT_FACTOR = 1e3


def placed(
    flat: FlatModel,
    engine: Engine,
    p: Floats,
    inputs: Floats | Callable[[float, bool], Floats],
    *,
    t0: float | None = None,
    times: Floats | None = None,
    tolerance: float | None = None,
    solver: str = "auto",
    step: float | None = None,
) -> Run:
    """A run that has not begun. Without `times` no rows are wanted; the rest that is left out says the experiment."""
    layout, experiment = engine.layout, flat.experiment
    relative = experiment.tolerance if tolerance is None else tolerance
    t = experiment.start_time if t0 is None else t0
    scales = scales_of(flat, engine.evaluate("start", t, p)[0])
    loose = contact_rows(flat)
    invariants = [_INVARIANT_FACTOR * relative if i.tolerance is None else i.tolerance for i in flat.invariants]
    asked = np.zeros(0) if times is None else times
    length = float(asked[-1] - asked[0]) if len(asked) > 1 else max(experiment.stop_time - t, np.spacing(abs(t)))
    settings = RunSettings(
        p=p,
        inputs=inputs,
        start=start_of(flat, t, ()),
        group=scales.groups,
        natural=scales.sizes,
        cap=scales.caps,
        lasting=np.array([row not in loose for row in range(len(layout.constraints))], dtype=np.bool_),
        general=sum(not (flag or row in loose) for row, flag in enumerate(layout.redundant)),
        times=asked,
        tolerance=relative,
        part=PROJECTION_PART,
        method=None if solver == "auto" else solver,
        step=step or 0.0,
        length=length,
        invariant_tolerance=np.array(invariants),
    )
    return Run(engine.native, layout, settings)
