"""Discrete-time matrices: of a sampled loop, or of a model without clocks whose inputs are held."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.analysis.linearization import Linearization, linear_of
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.sampled.loop import Loop, loop_at
from lagdsl.motion.analysis.sampled.modes import changes_with_time
from lagdsl.motion.analysis.sampled.schedule import no_clocks, schedule_of
from lagdsl.motion.analysis.sampled.verdict import ignored, lasting


def sampled_linearization(system: System, point: Point, every: float, sink: Sink) -> Linearization | None:
    """Discrete-time A, B, C, D at instants `every` [s] apart, inputs held in between; None after errors.

    In a model with clocks the states are those just before the first tick of a period, with the signals that it reads;
    outputs are those behind it.
    """
    clocks = bool(system.flat.events.clocks)
    schedule = schedule_of(system, point.p, every, sink) if clocks else no_clocks(every)
    loop = None if schedule is None else loop_at(system, point, schedule, sink, with_outputs=True)
    if loop is None:
        return None
    if changes_with_time(system, loop, with_outputs=True):
        sink.report("W0854", None, reason="time acts on the sampled system")
    return _linearization(system, loop, every)


def _linearization(system: System, loop: Loop, every: float) -> Linearization:
    layout = system.engine.layout
    plain = linear_of(system, loop.at)
    count, inputs = len(loop.names), len(layout.inputs)
    idle = {each.name for each in plain.left_out}
    anew = set(range(len(loop.still), count)) - set(lasting(loop.matrix, loop.outputs))
    left_out = [k for k, named in enumerate(loop.names) if named.name in idle or k in anew]
    kept = [k for k in range(count) if k not in left_out]
    return Linearization(
        model=plain.model,
        point=plain.point,
        states=tuple(loop.names[k] for k in kept),
        inputs=plain.inputs,
        outputs=plain.outputs,
        left_out=tuple(loop.names[k] for k in left_out),
        A=loop.matrix[np.ix_(kept, kept)],
        B=loop.matrix[kept, count : count + inputs],
        C=loop.outputs[:, kept],
        D=loop.outputs[:, count : count + inputs],
        rate=loop.matrix[kept, -1],
        steadiness=plain.steadiness,
        every=every,
        without=tuple(each.name for each in ignored(system, loop)),
    )
