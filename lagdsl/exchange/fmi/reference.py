"""A motion of the model by lagdsl itself, for those who want to know whether their importer does the same."""

from __future__ import annotations

from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.fmi.export_model import ExportModel
from lagdsl.exchange.fmi.package.binary import Objects
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.motion.signals.table_io import csv_text, events_text
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate

# Of the tolerance of the experiment, so that what an importer finds with that one can be told from what we do.
_PART, _LEAST = 1e-2, 1e-11
_MOST_STEPS = 200_000


@record()
class Reference:
    """`ended` tells why the motion ends before the experiment does."""

    motion: Trajectory
    tolerance: float
    ended: str | None

    def files(self) -> dict[str, str]:
        """Tables as `lag run` writes them, and settings in the form of the FMI cross-check."""
        time = self.motion.time
        settings = {"StartTime": time[0], "StopTime": time[-1], "StepSize": 0.0, "RelTol": self.tolerance}
        tables = {"reference.csv": csv_text(self.motion)}
        if self.motion.events:
            tables["reference_events.csv"] = events_text(self.motion)
        return {**tables, "reference.opt": "".join(f"{name}, {float(value)!r}\n" for name, value in settings.items())}


def reference(export_model: ExportModel, objects: Objects, engine: EngineName = "auto") -> Reference | None:
    """The motion of the experiment with the chosen defaults and starts; None where there is not even a beginning.

    Without another choice of engine it comes from the same `objects` as the library for this machine, if there is one:
    nothing is compiled twice.
    """
    flat = export_model.compilation.flat
    tolerance = max(_PART * flat.experiment.tolerance, _LEAST)
    ended = None
    with objects.open_library() as library:
        compiled = library is not None and engine in ("auto", "c")
        computing = CEngine(export_model.program, library) if compiled else engine_of(export_model.plain, engine)
    try:
        motion = simulate(
            computing, flat, tolerance=tolerance, start=export_model.chosen, max_steps=_MOST_STEPS, sink=Sink()
        )
    except SimulationFailed as failed:
        motion, ended = failed.trajectory, failed.diagnostics[0].message
    except CompilationFailed:
        return None
    return Reference(motion, tolerance, ended) if len(motion) > 1 else None
