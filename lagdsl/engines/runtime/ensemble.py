"""Many runs of one model in C, each as if it were alone: lag/ensemble.h."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import addressof, byref, c_double, c_int, c_ubyte
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.buffers import aligned
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.run_options import Flags, RunSettings, address, shared_options
from lagdsl.engines.runtime.run_view import Found, RunView, found_of
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.engines.runtime.structures import Ensemble, Initial, Status
from lagdsl.foundation.record import record

_FAILED: Any = next(field[1] for field in Ensemble._fields_ if field[0] == "failed")


@record(kw_only=True)
class EnsembleSettings:
    """Settings of many runs. Of `settings` p (runs, np), natural sizes (runs, 2 nq + nz) and constant inputs (runs, nu)
    are those of every run. Start values x (runs, 2 nq + nz) are given where `given` (2 nq + nz,) says so.
    Inputs may jump at `breaks`; `equations`: with the initial equations. The first `first_piece` steps
    are taken together, then `piece` steps at a time."""

    settings: RunSettings
    t: float
    stop: float
    breaks: tuple[float, ...]
    x: Floats
    given: Flags
    equations: bool
    first_piece: int
    piece: int
    most_steps: int


@record(kw_only=True)
class Made:
    """Of every run: rows (runs, count, width) at the times asked for, of which `kept` are filled; the time of the last
    row; how it ended; its parameters p (runs, np), those that were found too."""

    rows: Floats
    kept: NDArray[np.uintp]
    ended: Floats
    status: NDArray[np.intc]
    p: Floats

    @property
    def went_well(self) -> Flags:
        return np.isin(self.status, (Status.OK, Status.STOPPED))


@record(kw_only=True)
class Failed:
    """A run that failed, while it is there; `found` is None where it had a start."""

    run: RunView
    status: Status
    starts: Floats
    found: Found | None


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

    def run(
        self,
        model: NativeModel,
        layout: Layout,
        told: EnsembleSettings,
        stop: Stop,
        hear: Callable[[int, Failed], None],
    ) -> Made | None:
        """All runs, one after the other; None where `stop` was set before they had ended. `hear` is told of each that
        fails by its number, and raises nothing."""
        library, kept = runtime_library(), list[object]()
        runs, count = len(told.x), len(told.settings.times)
        options = shared_options(library, told.settings, kept)
        ensemble = Ensemble(
            model=model.address,
            states=model.part_address,
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
        own, inputs = told.settings, told.settings.inputs
        if isinstance(inputs, TabledInputs):
            inputs.tell(options, library, kept)
            inputs = inputs.u
        assert isinstance(inputs, np.ndarray), "functions of Python are called for one run at a time"
        numbers = {"at": np.array(told.breaks), "p": own.p, "u": inputs, "natural": own.measures.natural, "x": told.x}
        for name, values in numbers.items():
            setattr(ensemble, name, address(values, kept))
        made = Made(
            rows=np.empty((runs, count, int(library.ensemble_width(model.model)))),
            kept=np.zeros(runs, dtype=np.uintp),
            ended=np.full(runs, np.nan),
            status=np.zeros(runs, dtype=np.intc),
            p=np.array(own.p, dtype=np.float64),
        )
        for name, field in {"rows": "rows", "kept": "kept", "ended": "ended", "status": "status", "found": "p"}.items():
            setattr(ensemble.results, name, getattr(made, field).ctypes.data)
        ensemble.failed = failed = _FAILED(_teller(layout, made, hear))
        kept.append(failed)
        size = int(library.ensemble_size(byref(ensemble))) // 8 + 1
        if len(self._block) < size:
            self._block = aligned(size)
        done = library.ensemble_run(byref(ensemble), 0, runs, self._block.ctypes.data)
        return made if done == runs else None


def _teller(layout: Layout, made: Made, hear: Callable[[int, Failed], None]) -> Callable[..., None]:
    """The function that C calls after the failure of a run."""
    size = 2 * layout.size(Group.Q) + layout.size(Group.Z)
    count = len(layout.constraints)

    def tell(_context: object, i: int, run: int, status: int, starts: Any, x: Any, told: int | None) -> None:
        view = RunView(run, layout, size, made.p[i])
        begun, found = np.array(starts[:size]), None
        if told is not None:
            initial = Initial.from_address(told)
            dependent = np.array((c_ubyte * count).from_address(initial.dependent))
            row_sizes = np.array((c_double * count).from_address(initial.row_sizes))
            found = found_of(initial, begun, np.array(x[:size]), view.p, dependent, row_sizes)
        hear(i, Failed(run=view, status=Status(status), starts=begun, found=found))

    return tell
