"""The part of a motion that a certificate looks at: stiff systems without damping take millions of steps."""

from __future__ import annotations

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate

_TOO_MANY_STEPS, _TOO_MANY_TICKS = "E0812", "E0858"


def first_steps(engine: Engine, flat: FlatModel, most: int, tolerance: float) -> float:
    """The time [s] that the motion of the experiment reaches with `most` steps, at the latest the stop time; where a
    clock ticks more often, less. Raises SimulationFailed and CompilationFailed where there is no motion up to there.
    """
    begin, end = flat.experiment.start_time, flat.experiment.stop_time
    while True:
        try:
            simulate(engine, flat, stop=end, interval=end - begin, tolerance=tolerance, max_steps=most, sink=Sink())
        except SimulationFailed as failure:
            if failure.diagnostic.code != _TOO_MANY_STEPS:
                raise
            return failure.time
        except CompilationFailed as refused:
            if [each.code for each in refused.diagnostics] != [_TOO_MANY_TICKS]:
                raise
            end = begin + (end - begin) / 2.0
        else:
            return end
