"""Lines on exported FMUs: the motion by an importer against that of the runtime."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.fmi.round_trip import FmuRunFailed, motion_by_fmpy
from lagdsl.exchange.fmi.variables.variables import Kind, Version
from lagdsl.exchange.verify.certificate import Line
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate

_ROWS = 51
_PART = 0.1  # of the experiment: a chaotic motion shows rounding at its end
# Co-simulation brings the runtime along; in model exchange CVODE keeps its tolerance at every step only.
_LIMITS: dict[Kind, float] = {"cs": 1e-6, "me": 1e-3}
_VERSIONS: tuple[Version, ...] = (2, 3)
_WORDS: dict[Kind, str] = {"cs": "co-simulation", "me": "model exchange"}


def round_trips(compilation: Compilation, engine: Engine) -> Iterator[Line]:
    """One for each version and kind of FMI."""
    for version in _VERSIONS:
        for kind in _WORDS:
            yield _round_trip(compilation, engine, version, kind)


def _round_trip(compilation: Compilation, engine: Engine, version: Version, kind: Kind) -> Line:
    flat = compilation.flat
    name = f"FMI {version}.0 {_WORDS[kind]}"
    says = "exported, imported and run by FMPy: a tenth of the motion, coordinates as a part of their range"
    names = [item.name for item in flat.coordinates] or [item.name for item in flat.states]
    start = flat.experiment.start_time
    stop = start + _PART * (flat.experiment.stop_time - start)
    try:
        own = simulate(engine, flat, stop=stop, interval=(stop - start) / (_ROWS - 1))
        times, values = motion_by_fmpy(compilation, version, kind, stop, _ROWS, names)
    except (CompilationFailed, SimulationFailed) as failure:
        return Line(name=name, says=says, note=failure.diagnostics[0].message)
    except FmuRunFailed as failure:
        return Line(name=name, says=says, figure=1.0, limit=0.0, note=str(failure))
    worst, where = 0.0, ""
    if not abs(times[-1] - stop) <= 1e-9 * abs(stop):
        return Line(name=name, says=says, figure=1.0, limit=0.0, note=f"FMPy ends at {times[-1]:g} s")
    for k, each in enumerate(names):
        mine = np.interp(times, own.time, own[each])
        spread = max(float(np.ptp(mine)), 1e-3 * float(np.max(np.abs(mine))), 1e-12)
        part = float(np.max(np.abs(values[:, k] - mine))) / spread
        if part > worst:
            worst, where = part, f"largest in {each}"
    return Line(name=name, says=says, figure=worst, limit=_LIMITS[kind], note=where)
