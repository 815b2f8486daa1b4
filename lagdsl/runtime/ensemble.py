"""Many runs of one model in C, each as if it were alone: lag/ensemble.h."""

from __future__ import annotations

from ctypes import addressof, byref, c_int

import numpy as np
from numpy.typing import NDArray

from lagdsl.record import record
from lagdsl.runtime.engines.buffers import aligned
from lagdsl.runtime.engines.engine import Floats
from lagdsl.runtime.engines.native_model import NativeModel
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.run_options import Flags, RunSettings, address, shared_options
from lagdsl.runtime.structures import Ensemble, Status


@record(kw_only=True)
class EnsembleSettings:
    """Settings of many runs. Of `settings` p (runs, np) and natural (runs, 2 nq + nz) are those of every run, and u
    (runs, nu) stands for its inputs. Start values x (runs, 2 nq + nz) are given where `given` (2 nq + nz,) says so.
    Inputs may jump at `breaks`; `equations`: with the initial equations. The first `first_piece` steps
    are taken together, then `piece` steps at a time."""

    settings: RunSettings
    t: float
    stop: float
    breaks: tuple[float, ...]
    u: Floats
    x: Floats
    given: Flags
    equations: bool
    first_piece: int
    piece: int
    most_steps: int


@record(kw_only=True)
class Made:
    """Of every run: rows (runs, count, width) at the times asked for, of which `kept` are filled; the time of the last
    row; how it ended. Rows of a run whose status is neither OK nor STOPPED are of no use."""

    rows: Floats
    kept: NDArray[np.uintp]
    ended: Floats
    status: NDArray[np.intc]

    def went_well(self, run: int) -> bool:
        return self.status[run] in (Status.OK, Status.STOPPED)


class Stop:
    """A sign for runs in other threads to end soon."""

    def __init__(self) -> None:
        self.flag = c_int(0)

    def set(self) -> None:
        self.flag.value = 1

    @property
    def is_set(self) -> bool:
        return self.flag.value != 0


class Bench:
    """Memory in which one thread makes runs; no two threads may use it at once. Its memory serves one call after the
    other."""

    def __init__(self) -> None:
        self._block = aligned(1)

    def run(self, model: NativeModel, told: EnsembleSettings, stop: Stop) -> Made | None:
        """All runs, one after the other; None where `stop` was set before they had ended."""
        library, kept = runtime_library(), list[object]()
        runs, count = len(told.x), len(told.settings.times)
        options = shared_options(library, told.settings, kept)
        ensemble = Ensemble(
            model=model.address,
            options=addressof(options),
            t=told.t,
            stop=told.stop,
            breaks=len(told.breaks),
            first_piece=told.first_piece,
            piece=told.piece,
            most_steps=told.most_steps,
            equations=told.equations,
            stopped=addressof(stop.flag),
        )
        if told.given.any():
            ensemble.set = address(told.given, kept, np.uint8)
        if told.settings.turning is not None:
            ensemble.turning = address(told.settings.turning, kept, np.uint8)
        own = told.settings
        numbers = {"at": np.array(told.breaks), "p": own.p, "u": told.u, "natural": own.natural, "x": told.x}
        for name, values in numbers.items():
            setattr(ensemble, name, address(values, kept))
        made = Made(
            rows=np.empty((runs, count, int(library.ensemble_width(model.model)))),
            kept=np.zeros(runs, dtype=np.uintp),
            ended=np.full(runs, np.nan),
            status=np.zeros(runs, dtype=np.intc),
        )
        for name in ("rows", "kept", "ended", "status"):
            setattr(ensemble, name, getattr(made, name).ctypes.data)
        size = int(library.ensemble_size(byref(ensemble))) // 8 + 1
        if len(self._block) < size:
            self._block = aligned(size)
        done = library.ensemble_run(byref(ensemble), 0, runs, self._block.ctypes.data)
        return made if done == runs else None
