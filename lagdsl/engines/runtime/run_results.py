"""Results of a run of the C runtime along its way: rows, notes, extremes and the drift of invariants."""

from __future__ import annotations

from ctypes import addressof, byref
from functools import partial
from typing import Any

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.buffers import place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import Runtime
from lagdsl.engines.runtime.run_sensitivities import Directions, RunSensitivities
from lagdsl.engines.runtime.structures import WHAT, Extremes, Note, Results, Status

_FULL: Any = dict(field[:2] for field in Results._fields_)["full"]
# Rows and notes that C keeps before Python takes them.
_ROWS, _NOTES = 256, 1024


class _Ends:
    """Extremes of a run as C keeps them, lag_extremes, in `memory`."""

    def __init__(self, library: Runtime, model: NativeModel) -> None:
        self.told = Extremes()
        self.memory = np.zeros(int(library.extremes_memory(model.model)) + 1)
        self._model = model  # lives as long
        self._place = partial(library.extremes_place, byref(self.told), model.model, place_of(self.memory))
        self._place()

    def forget(self) -> None:
        """Everything so far."""
        self.memory[:] = 0.0
        self._place()


class RunResults:
    """`structure` is their form in C, lag_results; `drifts` (3, ni) the start, the size and the largest drift of every
    invariant. `notes` are what happened: time, kind (one of WHAT), number of the clock, relation, contact, reset or
    `terminate`."""

    def __init__(self, library: Runtime, model: NativeModel, layout: Layout) -> None:
        self.notes: list[tuple[float, str, int]] = []
        self.keeps = True  # False: rows and notes are of use until they are taken the next time
        self.drifts = np.zeros((3, len(layout.invariants)))
        self._taken: list[Floats] = []
        self.sensitivities: RunSensitivities | None = None
        self._rows = np.zeros((_ROWS, int(library.results_width(model.model))))
        self._notes = (Note * _NOTES)()
        self._full = _FULL(self._empty)
        self._ends = _Ends(library, model)
        self.structure = Results(
            most_rows=_ROWS,
            most_notes=_NOTES,
            rows=place_of(self._rows),
            notes=addressof(self._notes),
            full=self._full,
            extremes=addressof(self._ends.told),
        )

    @property
    def width(self) -> int:
        """Numbers of a row."""
        return self._rows.shape[1]

    def differentiate(self, model: NativeModel, of: Directions) -> RunSensitivities:
        """Rows have derivatives along these directions from now on."""
        self.sensitivities = RunSensitivities(model, of, _ROWS, _NOTES)
        self.structure.companion = self.sensitivities.address
        return self.sensitivities

    def leave_out_extremes(self) -> None:
        """Nobody looks for extremes and reversals from now on."""
        self.structure.extremes = None

    def _empty(self, _context: object, _results: object) -> int:
        """Called from C, where nothing may be raised."""
        self.take()
        return Status.OK

    def take(self) -> None:
        """Contents of the buffers."""
        structure = self.structure
        if self.keeps and structure.row:
            self._taken.append(self._rows[: structure.row].copy())
        if self.sensitivities is not None:
            self.sensitivities.take(structure.row if self.keeps else 0, structure.note)
        if structure.note:
            self.notes += [(note.t, WHAT[note.what], note.which) for note in self._notes[: structure.note]]
        structure.row = structure.note = 0

    def forget_notes(self) -> None:
        """Notes so far."""
        self.notes.clear()
        if self.sensitivities is not None:
            self.sensitivities.forget_notes()

    def forget(self) -> None:
        """Everything so far: a run begins that has nothing of the one before."""
        self._taken, self.notes = [], []
        self.sensitivities = None
        structure = self.structure
        structure.companion = None
        structure.row = structure.note = structure.any = 0
        structure.last = structure.after = 0.0
        self.drifts[:] = 0.0
        self._ends.forget()

    def rows(self) -> Floats:
        """All rows so far, as lag/run/results.h tells them. Nobody may change them."""
        self.take()
        if len(self._taken) != 1:
            self._taken = [np.concatenate([self._rows[:0], *self._taken])]
        return self._taken[0]

    def derivatives(self) -> RunSensitivities:
        """Derivatives of all rows and notes so far."""
        self.take()
        assert self.sensitivities is not None, "internal error: nobody asked for derivatives"
        return self.sensitivities

    def extremes(self) -> Floats:
        """(2, count): the lowest and the highest values of state, discrete variables and outputs along the motion so
        far; infinite where there was no number."""
        count = self._ends.told.count
        return self._ends.memory[: 2 * count].reshape(2, count).copy()

    def turns(self, size: int) -> list[float]:
        """Number of reversals of every number of a state of this size."""
        first = 2 * self._ends.told.count
        found: list[float] = self._ends.memory[first : first + size].tolist()
        return found
