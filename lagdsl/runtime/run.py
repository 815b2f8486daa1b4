"""A run of the C runtime: one model, in one block of memory, from a start that it finds to wherever it ends."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import addressof, byref, c_double
from typing import Any
from weakref import WeakMethod

import numpy as np

from lagdsl.graph.operation import Group
from lagdsl.program.program import Layout
from lagdsl.runtime.engines.buffers import Buffers
from lagdsl.runtime.engines.engine import Floats
from lagdsl.runtime.engines.native_model import NativeModel
from lagdsl.runtime.run_options import RunSettings, address, shared_options
from lagdsl.runtime.run_view import Found, RunView, found_of
from lagdsl.runtime.signal_tables import TabledInputs
from lagdsl.runtime.structures import (
    WHAT,
    Extremes,
    Initial,
    Note,
    Results,
    RunOptions,
    Status,
)

# Types of the functions that C calls.
_CALLED: dict[str, Any] = {field[0]: field[1] for structure in (RunOptions, Results) for field in structure._fields_}
_ALIGNED = 16
# Rows and notes that C keeps before Python takes them.
_ROWS, _NOTES = 256, 1024


def _weakly(method: Callable[..., Any]) -> Callable[..., Any]:
    """The method for C, which keeps no run alive: its block of memory is free as soon as nobody else needs it."""
    found = WeakMethod(method)

    def called(*arguments: object) -> Any:
        bound = found()
        assert bound is not None
        return bound(*arguments)

    return called


class Run(RunView):
    """Not to be used by several threads at once. The call that asked for inputs raises their exceptions.

    `p` are the parameters, those that are found with the start too. `notes` are what happened: time, kind (one of
    WHAT), number of the clock, relation, contact, reset or `terminate`.
    """

    def __init__(self, model: NativeModel, layout: Layout, settings: RunSettings) -> None:
        super().__init__(0, layout, 2 * layout.size(Group.Q) + layout.size(Group.Z), settings.p)
        self._model = model
        self.settings = settings
        self._problem: BaseException | None = None
        self._nothing = np.full(layout.size(Group.U), np.nan)
        self._kept: list[object] = []
        count = len(layout.constraints)
        self._row_sizes = np.ones(count)
        self._drifts = np.zeros((3, len(layout.invariants)))
        self._width = int(self._library.results_width(model.model))
        self._row_buffer = np.zeros((_ROWS, self._width))
        self._note_buffer = (Note * _NOTES)()
        self._parts: list[Floats] = []
        self.notes: list[tuple[float, str, int]] = []
        options = self._options(settings)
        size = int(self._library.run_size(model.model, byref(options)))
        self._block = np.zeros(size // 8 + _ALIGNED, dtype=np.float64)
        start = -(-self._block.ctypes.data // _ALIGNED) * _ALIGNED
        self._run = self._library.run_place(start, model.model, byref(options))

    def _options(self, settings: RunSettings) -> RunOptions:
        options = shared_options(self._library, settings, self._kept)
        for name in ("p", "natural"):
            setattr(options, name, address(getattr(settings, name), self._kept))
        options.row_sizes = self._row_sizes.ctypes.data
        if settings.invariant_tolerance is not None:
            for name, values in zip(("start", "size", "drift"), self._drifts, strict=True):
                setattr(options, f"invariant_{name}", values.ctypes.data)
        inputs = settings.inputs
        if isinstance(inputs, TabledInputs):
            inputs.tell(options, self._library, self._kept)
            options.u = address(inputs.u, self._kept)
        elif callable(inputs):
            self._inputs = options.inputs = _CALLED["inputs"](_weakly(self._tell_inputs))
        else:
            options.u = address(inputs, self._kept)
        self._full = _CALLED["full"](_weakly(self._empty))
        self._results = Results(
            most_rows=_ROWS,
            most_notes=_NOTES,
            rows=self._row_buffer.ctypes.data,
            notes=addressof(self._note_buffer),
            full=self._full,
        )
        if settings.turning is not None:
            self._results.turning = address(settings.turning, self._kept, np.uint8)
            self._results.angle = address(np.full(len(settings.turning), np.nan), self._kept)
        self._extremes = Extremes()
        self._extreme_memory = np.zeros(int(self._library.extremes_memory(self._model.model)) + 1)
        self._library.extremes_place(byref(self._extremes), self._model.model, self._extreme_memory.ctypes.data)
        self._results.extremes = addressof(self._extremes)
        options.results = addressof(self._results)
        return options

    # ---- called from C, where nothing may be raised ------------------------------------------------------------------

    def _tell_inputs(self, _context: object, t: float, before: int, u: object) -> None:
        """Values that are not numbers end the run."""
        assert callable(self.settings.inputs)
        values = self._nothing
        if self._problem is None:
            try:
                values = self.settings.inputs(t, bool(before))
            except BaseException as problem:
                self._problem = problem
        for index, value in enumerate(values.tolist()):
            u[index] = value  # type: ignore[index]

    def _empty(self, _context: object, _results: object) -> int:
        self._take()
        return Status.OK

    def _take(self) -> None:
        """Contents of the buffers."""
        self._parts.append(self._row_buffer[: self._results.row].copy())
        for note in self._note_buffer[: self._results.note]:
            self.notes.append((note.t, WHAT[note.what], note.which))
        self._results.row = self._results.note = 0

    # ---- what it does ------------------------------------------------------------------------------------------------

    def find(self, t: float, given: dict[int, float], *, equations: bool) -> Found:
        """The start at time t: from the start values of the model, with those `given` by their place in x instead; with
        or without the initial equations of the model."""
        layout, count = self._layout, len(self._layout.constraints)
        starts = np.zeros(self.size)
        self._checked(self._library.run_start(self._run, t, starts.ctypes.data))
        chosen = np.zeros(self.size + 1, dtype=np.uint8)
        for place, value in given.items():
            starts[place], chosen[place] = value, 1
        x, dependent = starts.copy(), np.array(layout.redundant, dtype=np.uint8)
        pattern = np.zeros((count, len(layout.coordinates)))
        told = Initial(
            given=not equations,
            dependent=dependent.ctypes.data,
            row_sizes=self._row_sizes.ctypes.data,
            pattern=pattern.ctypes.data,
        )
        at = chosen.ctypes.data if given else None
        self._checked(self._library.run_find(self._run, t, at, x.ctypes.data, byref(told)))
        if self.settings.start.free:
            self.p = np.array((c_double * len(layout.parameters)).from_address(told.p))
        return found_of(told, starts, x, self.p, dependent, self._row_sizes, pattern)

    def begin(self, t: float, x: Floats) -> Status:
        """The motion begins at the state x, with what happens there."""
        return self._done(self._library.run_begin(self._run, t, self._state(x)))

    def enter(self, t: float, x: Floats) -> Status:
        """Carries out the events at the start of a motion, and no more."""
        moved = self._done(self._library.run_move(self._run, t, self._state(x), 0.0))
        return moved or self._done(self._library.run_enter(self._run))

    def to(self, stop: float, steps: int) -> Status:
        """On to `stop`, with inputs as they are before a jump there, in at most so many steps."""
        return self._done(self._library.run_to(self._run, stop, steps))

    def jump(self) -> Status:
        """Carries out the changes that inputs which jump now cause."""
        return self._done(self._library.run_jump(self._run))

    def change(self, model: NativeModel) -> None:
        """The functions of `model`, another filling of the same equations, from now on."""
        self._changed = Buffers(model)
        status = self._library.run_change(self._run, model.model, self._changed.workspace.ctypes.data)
        assert status == Status.OK, "internal error: the compiled model is another one than the tape"
        self._model = model

    def end(self) -> Status:
        """Evaluates the end of the motion."""
        return self._done(self._library.run_end(self._run))

    def _checked(self, status: int) -> Status:
        raised = [self._problem] if self._problem is not None else self._model.raised
        if raised:
            raise raised.pop(0)
        return Status(status)

    def _done(self, status: int) -> Status:
        self._take()
        return self._checked(status)

    # ---- where it is -------------------------------------------------------------------------------------------------

    def rows(self) -> Floats:
        """All rows so far, as lag/run/results.h tells them."""
        return np.concatenate(self._parts) if self._parts else np.zeros((0, self._width))

    def extremes(self) -> tuple[Floats, Floats]:
        """The lowest and the highest values of state, discrete variables and outputs along the motion so far; infinite
        where there was no number."""
        count = self._extremes.count
        return self._extreme_memory[:count].copy(), self._extreme_memory[count : 2 * count].copy()

    def turns(self) -> Floats:
        """Number of reversals of every number of the state."""
        first = 2 * self._extremes.count
        return self._extreme_memory[first : first + self.size].copy()

    def invariants(self) -> tuple[Floats, Floats, Floats]:
        """Of every invariant: its value at the start, its scale, its largest drift."""
        start, size, drift = self._drifts.copy()
        return start, size, drift
