"""Forward sensitivities of a run of the C runtime: columns of derivatives beside its rows and its notes."""

from __future__ import annotations

from ctypes import byref, create_string_buffer

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.runtime.engines.buffers import Buffers, aligned, place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Along, SensitivityDirections, SensitivityFault, SensitivityRows, Status
from lagdsl.foundation.record import record


@record(kw_only=True)
class Directions:
    """Quantities that a motion is differentiated by, `count` of them: directions of the parameters (count, np), of
    constant shifts of the inputs (count, nu) and of the start values (count, 2 nq + nz). `by_state` and `by_parameter`
    have the functions of several directions, None: one is followed after the other; `motion` has the derivatives of the
    motion, which stand for them."""

    p: Floats
    u: Floats
    start: Floats
    by_state: NativeModel | None
    by_parameter: NativeModel | None
    motion: NativeModel | None


class _Functions:
    """The functions of several directions of a model as C reads them; all zero without a model that has some."""

    def __init__(self, model: NativeModel | None) -> None:
        self.told, self._held = Along(), (model, None if model is None else Buffers(model))
        if model is not None and model.part and self._held[1] is not None:
            self.told.model, self.told.tangents = model.address, model.part_address
            self.told.workspace = self._held[1].workspace.ctypes.data
            self.told.memory = self._held[1].memory.ctypes.data


class RunSensitivities:
    """The lag_sensitivities of one run at `address`, with buffers as long as those of its results."""

    def __init__(self, model: NativeModel, of: Directions, most_rows: int, most_notes: int) -> None:
        library, count = runtime_library(), len(of.p)
        self._rows = np.zeros((most_rows, count, int(library.sensitivities_width(model.model))))
        self._times = np.zeros((most_notes, count))
        self._taken: list[Floats] = []
        self._noted: list[Floats] = []
        block = aligned(int(library.sensitivities_size(model.model, count)) // 8 + 1)
        arrays = [np.ascontiguousarray(each, dtype=np.float64) for each in (of.p, of.u, of.start)]
        directions = SensitivityDirections(count, *map(place_of, arrays))
        functions = [_Functions(each) for each in (of.by_state, of.by_parameter, of.motion)]
        rows = SensitivityRows(place_of(self._rows), place_of(self._times))
        told = (Along * 3)(*(each.told for each in functions))
        place = library.sensitivities_place
        self.address = int(place(place_of(block), model.model, byref(directions), byref(rows), byref(told)))
        self.of = of
        self._model = model
        self._held = block, arrays, functions

    def start(self, run: int, t: float, chosen: NDArray[np.uint8], starts: Floats) -> Status:
        """Columns at the start at time t of the run at the address `run`, found from the values `starts` with those
        that `chosen` flags as written."""
        values = np.ascontiguousarray(starts)
        at = self.address, run, t, place_of(chosen), place_of(values)
        return Status(runtime_library().sensitivities_start(*at))

    def take(self, rows: int, notes: int) -> None:
        """So many entries of the buffers."""
        if rows:
            self._taken.append(self._rows[:rows].copy())
        if notes:
            self._noted.append(self._times[:notes].copy())

    def forget_notes(self) -> None:
        """Times of notes so far."""
        self._noted = []

    def rows(self) -> Floats:
        """Derivatives of all rows so far (rows, count, width)."""
        return self._taken[0] if len(self._taken) == 1 else np.concatenate([self._rows[:0], *self._taken])

    def times(self) -> Floats:
        """Derivatives of the times of all notes so far (notes, count)."""
        return np.concatenate([self._times[:0], *self._noted])

    def present(self, run: int) -> Floats:
        """Derivatives of the present row of the run at the address `run`, (count, width)."""
        found = np.zeros(self._rows.shape[1:])
        status = Status(runtime_library().sensitivities_row(run, place_of(found)))
        return found if status is Status.OK else np.full_like(found, np.nan)

    def command(self, u: Floats) -> None:
        """The inputs that the caller sets have these derivatives from now on, (count, nu)."""
        runtime_library().sensitivities_inputs(self.address, self._model.model, place_of(u))

    def saved(self) -> bytes:
        """The columns between two calls."""
        buffer = create_string_buffer(self._saved_size())
        runtime_library().sensitivities_save(self.address, self._model.model, buffer)
        return buffer.raw

    def load(self, saved: bytes) -> None:
        """Takes the columns of other sensitivities along the same directions."""
        assert len(saved) == self._saved_size(), "internal error: these are columns along other directions"
        runtime_library().sensitivities_load(self.address, self._model.model, saved)

    def _saved_size(self) -> int:
        return int(runtime_library().sensitivities_saved_size(self.address, self._model.model))

    @property
    def fault(self) -> SensitivityFault:
        """Why there are no more of them, and how many instants have several."""
        told = SensitivityFault()
        runtime_library().sensitivities_fault(self.address, byref(told))
        return told
