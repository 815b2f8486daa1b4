"""What already fails at the start: found without a step."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.initialize import InitialState
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.signals import signals
from lagdsl.simulate.trouble import report_trouble
from lagdsl.simulate.watch import Watch


def check_first_instant(flat: FlatModel, engine: Engine, initial: InitialState, sink: Sink) -> None:
    """E0806, E0808 or E0813 where the start has no accelerations, E0810 for an assertion that is false there.

    With the parameters as given; a model with inputs is left alone, for nobody knows their values yet.
    """
    if flat.inputs:
        return
    with np.errstate(all="ignore"):
        given = signals(flat, np.zeros(0), {}, (initial.t, np.inf), sink)
        p = np.array(engine.layout.defaults, dtype=np.float64)
        w = engine.evaluate("discrete_start", initial.t, p)[0] if engine.layout.discretes else np.zeros(0)
        system = RightHandSide(engine, given, w.copy(), p)
        y = np.concatenate([initial.q, initial.qd, initial.z])
        if not np.all(np.isfinite(system(initial.t, y))):
            if system.trouble is not None:
                report_trouble(flat, system, system.trouble, sink)
        elif flat.assertions:
            Watch(flat, engine, system, flat.experiment.tolerance).check(initial.t, y, sink)
