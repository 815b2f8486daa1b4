"""A model through an FMU and back: exported, read by FMPy, run by FMPy."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from lagdsl.exchange.fmi.export import export
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.exchange.fmi.variables.variables import Kind, Version
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.pipeline import Compilation

_FMPY = {"me": "ModelExchange", "cs": "CoSimulation"}


class FmuRunFailed(Exception):  # noqa: N818 named after what it says
    """FMPy ended the run with this message."""


def motion_by_fmpy(
    compilation: Compilation, version: Version, kind: Kind, stop: float, rows: int, names: Sequence[str]
) -> tuple[Floats, Floats]:
    """Times (rows,) and values (rows, names) of the FMU of the model. Model exchange is integrated by CVODE of FMPy.

    Raises CompilationFailed (E09xx) where there is no FMU, FmuRunFailed where FMPy does not come to the end.
    """
    from fmpy import simulate_fmu

    experiment = compilation.flat.experiment
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.fmu"
        # with entries of arrays as variables of their own: `names` are scalars
        ports = Ports(scalar=True)
        export(compilation, path, version=version, kinds=(kind,), documented=False, ports=ports, sink=Sink())
        try:
            found = simulate_fmu(
                str(path),
                start_time=experiment.start_time,
                stop_time=stop,
                output_interval=(stop - experiment.start_time) / (rows - 1),
                relative_tolerance=experiment.tolerance,
                fmi_type=_FMPY[kind],
                output=list(names),
            )
        except Exception as problem:  # FMPy raises Exception itself for what an FMU reports
            raise FmuRunFailed(str(problem)) from problem
    return np.array(found["time"]), np.stack([np.array(found[name]) for name in names], axis=1)
