"""Faults at the start of a motion: found without a step."""

from __future__ import annotations

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.initialize import InitialState
from lagdsl.motion.simulate.messages import Course, report_fault
from lagdsl.motion.simulate.placed import placed
from lagdsl.motion.simulate.unknown_outputs import UnknownOutputs


def check_first_instant(flat: FlatModel, engine: Engine, initial: InitialState, sink: Sink) -> None:
    """Faults that prevent a motion: no accelerations (E0806, E0808, E0813), an assertion that is false (E0810), a
    contact that is pierced (E0834), clauses that come to no end; an output that is no number (E0857).

    With the parameters as given; a model with inputs is left alone, for nobody knows their values yet.
    """
    if flat.inputs:
        return
    with np.errstate(all="ignore"):
        run = placed(flat, engine, initial.p, np.zeros(0), t0=initial.t)
        status = run.begin(initial.t, initial.x)
        if status not in (Status.OK, Status.STOPPED):
            course = Course(flat, engine.layout, run, flat.experiment.stop_time, 0)
            report_fault(course, status, run.explain(status), np.zeros(0), sink)
        elif flat.outputs:
            values = run.evaluate("output", initial.t, initial.x, len(flat.outputs))
            outputs = UnknownOutputs(flat, engine)
            state = (initial.x, np.zeros(0), initial.p)
            unknown = outputs.first(values[None, :], np.array([initial.t]), lambda _: state)
            if unknown is not None:
                outputs.report(unknown[1], initial.t, float(values[unknown[1]]), sink)
