"""A run of the C runtime, seen from Python: steps, projection and rows in C, as far as nothing needs a closer look."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref

import numpy as np

from lagdsl.record import record
from lagdsl.runtime.engine import Floats
from lagdsl.runtime.load import INPUTS, Library, RunOptions, RunReport

_ALIGNED = 16


@record()
class Places:
    """Entries of w with the truth of each relation and the state of each contact, and the rows of constraints of the
    contacts; `strict` flags relations that do not hold at zero. Whole numbers, as floats.

    `slack` (2,), which may be changed: what is round-off of gaps, as a part of the size of the state, and of forces.
    """

    truth: Floats
    strict: Floats
    closed: Floats
    row: Floats
    slack: Floats


@record()
class RunSettings:
    """`method` is a name of `lagdsl.runtime.load.METHODS`, or None for the automatic choice. `inputs` is the constant
    input vector, or a function of time. `group`, `natural`, `cap` (2 nq + nz,) and `row_sizes` (nc,): lag/accuracy.h.
    Of the rows flagged in `lasting` (nc,) `general` are independent in general.
    `rows` (times, 2 nq + nz) receives the states at `times`. The arrays `invariant_...` (ni,) are kept up to date; all
    of them must be contiguous."""

    tolerance: float
    part: float
    method: str | None
    p: Floats
    inputs: Floats | Callable[[float], Floats]
    group: Floats
    natural: Floats
    cap: Floats
    row_sizes: Floats
    lasting: Floats
    general: int
    places: Places
    times: Floats
    rows: Floats
    invariant_tolerance: Floats
    invariant_start: Floats
    invariant_size: Floats
    invariant_drift: Floats


class CRun:
    """One run of a model with so many `inputs`, in one block of memory of its own. `trouble` is what they raised, if
    they did."""

    def __init__(self, library: Library, settings: RunSettings, inputs: int) -> None:
        self._library = library
        self._settings = settings  # C points into its arrays
        self._nothing = np.full(inputs, np.nan)
        self.trouble: BaseException | None = None
        options = self._options(settings)
        size = int(library.run_size(library.model, byref(options)))
        self._block = np.zeros(size // 8 + _ALIGNED, dtype=np.float64)
        start = -(-self._block.ctypes.data // _ALIGNED) * _ALIGNED
        self._run = library.run_place(start, library.model, byref(options))
        self.report = RunReport()
        library.run_tell(self._run, byref(self.report))

    def _options(self, settings: RunSettings) -> RunOptions:
        options = RunOptions(
            tolerance=settings.tolerance,
            part=settings.part,
            careful=1,
            general=settings.general,
            count=len(settings.times),
            continued=1,
            method=None if settings.method is None else self._library.methods[settings.method],
        )
        for name in ("p", "group", "natural", "cap", "row_sizes", "lasting", "times", "rows"):
            setattr(options, name, getattr(settings, name).ctypes.data)
        for name in ("truth", "strict", "closed", "row", "slack"):
            setattr(options, name, getattr(settings.places, name).ctypes.data)
        for name in ("tolerance", "start", "size", "drift"):
            setattr(options, f"invariant_{name}", getattr(settings, f"invariant_{name}").ctypes.data)
        if callable(settings.inputs):
            self._inputs = options.inputs = INPUTS(self._tell_inputs)
        else:
            options.u = settings.inputs.ctypes.data
        return options

    def _tell_inputs(self, _context: object, t: float, u: object) -> None:
        """Called from C, where nothing may be raised: values that are not numbers stop it."""
        assert callable(self._settings.inputs)
        try:
            values = self._settings.inputs(t)
        except BaseException as problem:
            self.trouble = problem
            values = self._nothing
        for index, value in enumerate(values.tolist()):
            u[index] = value  # type: ignore[index]

    def leap(self, t: float, y: Floats, w: Floats, h: float, stop: float, *, row: int, steps: int) -> int:
        """On from y with discretes w at time t towards `stop`, at most so many steps.

        h is the length of the first, 0 to find it; `row` is the next to be recorded. Returns a lag_status; `report` and
        `state` tell where it ended: at the last good state.
        """
        self.trouble = None
        library = self._library
        status = int(library.run_move(self._run, t, y.ctypes.data, h))
        library.run_skip(self._run, row)
        library.run_discretes(self._run, w.ctypes.data)
        if status == 0:
            status = int(library.run_to(self._run, stop, steps))
        library.run_tell(self._run, byref(self.report))
        return status

    def state(self) -> Floats:
        """Where it is now, a copy."""
        return np.array(self.report.x[: self._settings.rows.shape[1]])
