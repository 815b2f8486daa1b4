"""A run of the C runtime, seen from Python: steps, projection and rows in C, as far as nothing needs a closer look."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from lagdsl.record import record
from lagdsl.runtime.engine import Floats
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.native_model import NativeModel
from lagdsl.runtime.structures import INPUTS, TELL, WHAT, RunOptions, RunReport

_ALIGNED = 16


class Status(IntEnum):
    """lag_status of runs."""

    OK = 0
    TOO_LONG = 5
    ATTENTION = 7
    VIOLATED = 8
    STOPPED = 9
    CHATTER = 10
    UNSETTLED = 12
    CONFLICT = 13
    REFUSED = 14
    PIERCED = 15
    TORN = 16


@dataclass(slots=True)
class Told:
    """What happened: `what` is one of `lagdsl.runtime.structures.WHAT`, `which` the number of the clock, relation,
    contact, reset or `terminate`. `row` is the number of the next row then; of what is "before" or "after" an event the
    state y and the discretes w."""

    t: float
    what: str
    which: int
    row: int
    y: Floats
    w: Floats


@record()
class RunSettings:
    """`method` is a name of `lagdsl.runtime.structures.METHODS`, or None for the automatic choice. `inputs` is the
    constant input vector, or a function of time. `group`, `natural`, `cap` (2 nq + nz,) and `row_sizes` (nc,):
    lag/accuracy.h. Of the rows flagged in `lasting` (nc,) `general` are independent in general; `length` is that of the
    experiment [s]. `rows` (times, 2 nq + nz) receives the states at `times`. The arrays `invariant_...` (ni,) are kept
    up to date; all of them must be contiguous."""

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
    length: float
    times: Floats
    rows: Floats
    invariant_tolerance: Floats
    invariant_start: Floats
    invariant_size: Floats
    invariant_drift: Floats


class CRun:
    """One run of a model with so many `inputs` and `discretes`, in one block of memory of its own.

    `told` is what happened in the last call; `before` is called with the time of an event before anything happens,
    `after` with the state and the discretes afterwards: the run stops there where it says no. What inputs raise
    is raised by the call.
    """

    def __init__(self, model: NativeModel, settings: RunSettings, inputs: int, discretes: int) -> None:
        self._library = library = runtime_library()
        self._model = model  # C reads it
        self._settings = settings  # C points into its arrays
        self._nothing = np.full(inputs, np.nan)
        self._size, self._discretes = settings.rows.shape[1], discretes
        self.told: list[Told] = []
        self.before: Callable[[float], None] | None = None
        self.after: Callable[[float, Floats, Floats], bool] | None = None
        self.trouble: BaseException | None = None
        options = self._options(settings)
        size = int(library.run_size(model.model, byref(options)))
        self._block = np.zeros(size // 8 + _ALIGNED, dtype=np.float64)
        start = -(-self._block.ctypes.data // _ALIGNED) * _ALIGNED
        self._run = library.run_place(start, model.model, byref(options))
        self.report = RunReport()
        library.run_tell(self._run, byref(self.report))

    def _options(self, settings: RunSettings) -> RunOptions:
        options = RunOptions(
            tolerance=settings.tolerance,
            part=settings.part,
            careful=1,
            general=settings.general,
            length=settings.length,
            count=len(settings.times),
            continued=1,
            method=None if settings.method is None else self._library.methods[settings.method],
        )
        for name in ("p", "group", "natural", "cap", "row_sizes", "lasting", "times", "rows"):
            setattr(options, name, getattr(settings, name).ctypes.data)
        self._tell = options.tell = TELL(self._happened)
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

    def _happened(self, _context: object, _run: object, happening: object) -> int:
        """Called from C, where nothing may be raised."""
        try:
            told = happening.contents  # type: ignore[attr-defined]
            what = WHAT[told.what]
            whole = what in ("before", "after")
            y = np.array(told.x[: self._size if whole else 0])
            w = np.array(told.w[: self._discretes if whole else 0])
            if what == "before" and self.before is not None:
                self.before(told.t)
            if what == "after" and self.after is not None and not self.after(told.t, y, w):
                return Status.STOPPED
            self.told.append(Told(told.t, what, told.which, told.row, y, w))
        except BaseException as problem:
            self.trouble = problem
            return Status.STOPPED
        return Status.OK

    # ---- what it does ------------------------------------------------------------------------------------------------

    def leap(self, t: float, y: Floats, h: float, stop: float, *, row: int, steps: int) -> int:
        """On from y at time t towards `stop`, at most so many steps.

        h is the length of the first, 0 to find it; `row` is the next to be recorded. Returns a lag_status; `report` and
        `state` tell where it ended: at the last good state, or after an event.
        """
        library = self._library

        def run() -> int:
            library.run_skip(self._run, row)
            return int(library.run_to(self._run, stop, steps))

        return self._at(t, y, h, run)

    def enter(self, t: float, y: Floats) -> int:
        """What happens at the start of the motion."""
        return self._at(t, y, 0.0, lambda: int(self._library.run_enter(self._run)))

    def end(self, t: float, y: Floats) -> int:
        """What happens at its end."""
        return self._at(t, y, 0.0, lambda: int(self._library.run_end(self._run)))

    def event(self, t: float, y: Floats, step: float, changed: Floats) -> int:
        """Relations, then contacts, flagged in `changed` did so in a step of this length."""
        run = self._library.run_event
        return self._at(t, y, 0.0, lambda: int(run(self._run, step, changed.ctypes.data)))

    def ticks(self, t: float, y: Floats) -> int:
        """The clocks that tick at t, if any do."""
        return self._at(t, y, 0.0, lambda: int(self._library.run_ticks(self._run)))

    def due(self, t: float) -> bool:
        """Whether a clock ticks at t."""
        return bool(self._library.run_due(self._run, t))

    def _at(self, t: float, y: Floats, h: float, run: Callable[[], int]) -> int:
        self.trouble = None
        self.told.clear()
        y = np.ascontiguousarray(y)
        status = int(self._library.run_move(self._run, t, y.ctypes.data, h)) or run()
        self._library.run_tell(self._run, byref(self.report))
        if self.trouble is not None:
            raise self.trouble
        return status

    # ---- where it is -------------------------------------------------------------------------------------------------

    def state(self) -> Floats:
        """Where it is now, a copy."""
        return np.array(self.report.x[: self._size])

    def discretes(self) -> Floats:
        """The discretes now, a copy."""
        return np.array(self.report.w[: self._discretes])

    def guilty(self) -> list[int]:
        """The discretes because of which an event came to no good end."""
        return [k for k in range(self._discretes) if self.report.guilty[k] != 0.0]
