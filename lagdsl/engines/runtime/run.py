"""A run of the C runtime: one model, in one block of memory, from a start that it finds to wherever it ends."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import addressof, byref, c_double, c_size_t, create_string_buffer

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.buffers import Buffers, place_of, zeros_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.run_options import Flags, RunSettings, ToldOptions
from lagdsl.engines.runtime.run_results import RunResults
from lagdsl.engines.runtime.run_sensitivities import Directions
from lagdsl.engines.runtime.run_view import Found, RunView, found_of
from lagdsl.engines.runtime.structures import Initial, Status

_STATUSES = tuple(Status)  # in their order, from 0 on: found faster than by `Status(...)`
# Bytes of a run that is kept for the next one; memory as large as this is made as fast as it is used.
_LARGEST = 1 << 23


def run_of(model: NativeModel, layout: Layout, settings: RunSettings, along: Callable[[], NativeModel | None]) -> Run:
    """A run that has not begun, in the memory of one that is over where there is one. `layout` and `along` are those
    of the model."""
    try:
        run = model.idle.pop()
    except IndexError:
        return Run(model, layout, settings, along)
    assert isinstance(run, Run), "runs alone are left idle"
    return run if run.renew(settings, along) else Run(model, layout, settings, along)


class _Search:
    """The memory of a search for a start: addresses, and what is read from there."""

    def __init__(self, size: int, layout: Layout) -> None:
        self._redundant = np.array(layout.redundant, dtype=np.uint8)
        self._x, self._row_sizes = np.zeros(size), np.ones(len(layout.constraints))
        self._chosen, self._dependent = np.zeros(size + 1, dtype=np.uint8), self._redundant.copy()
        self.x, self.chosen, self.row_sizes = place_of(self._x), place_of(self._chosen), place_of(self._row_sizes)
        self._told = Initial(dependent=place_of(self._dependent), row_sizes=self.row_sizes)

    def begin(self, given: dict[int, float], equations: bool) -> tuple[Floats, Initial]:
        """The start values with those `given`, and what the search is told."""
        if given:
            self._chosen[:] = 0
        for place, value in given.items():
            self._x[place], self._chosen[place] = value, 1
        self._told.given, self._told.p = not equations, None
        self._row_sizes[:], self._dependent[:] = 1.0, self._redundant
        return self._x.copy(), self._told

    def again(self, row_sizes: Floats, dependent: Sequence[bool] | Flags) -> int:
        """Lets a start found before be that of now; returns the place of the flags of rows that depend on others."""
        self._row_sizes[:], self._dependent[:] = row_sizes, dependent
        return place_of(self._dependent)

    def sizes_of_rows(self) -> Floats:
        return self._row_sizes.copy()

    def found(self, starts: Floats, p: Floats) -> Found:
        return found_of(self._told, starts, self._x.copy(), p, self._dependent, self._row_sizes)


class Run(RunView):
    """Not to be used by several threads at once. The call that asked for inputs raises their exceptions.

    `p` are the parameters, those that are found with the start too. `along` makes the functions of several directions
    of derivatives, when the run needs them.
    """

    def __init__(
        self, model: NativeModel, layout: Layout, settings: RunSettings, along: Callable[[], NativeModel | None]
    ) -> None:
        super().__init__(0, layout, 2 * layout.size(Group.Q) + layout.size(Group.Z), settings.p)
        self._model, self._search = model, _Search(self.size, layout)
        self.results = RunResults(self._library, model, layout)
        self._told = ToldOptions(layout, along)
        options = self._told.structure
        options.results, options.sizes.row_sizes = addressof(self.results.structure), self._search.row_sizes
        for name, values in zip(("start", "size", "drift"), self.results.drifts, strict=True):
            setattr(options.invariants, name, place_of(values))
        self._told.take(settings)
        options.zeroed = 1
        self._sized = model.model
        self._block = zeros_of(int(self._library.run_size(model.model, byref(options))))
        self._run = self._library.run_place(place_of(self._block), model.model, byref(options))

    @property
    def settings(self) -> RunSettings:
        """The settings that it was made with."""
        return self._told.settings

    def renew(self, settings: RunSettings | None = None, along: Callable[[], NativeModel | None] | None = None) -> bool:
        """Lets it be a run that has not begun, with these settings and directions or the same; False if the model that
        it goes on with now does not fit into its memory."""
        if settings is not None:
            self._told.take(settings)
        self._told.along.make = along or self._told.along.make
        options, model = self._told.structure, self._model.model
        options.zeroed = 0
        if model is not self._sized and self._library.run_size(model, byref(options)) > self._block.nbytes:
            return False
        self._sized = model
        self._library.run_place(self._run, model, byref(options))
        self.p = self.settings.p
        self.results.forget()
        return True

    def leave(self) -> None:
        """It is over, and nobody asks it any more: the next run of the model may have its memory."""
        self._told.forget()
        if self._block.nbytes <= _LARGEST:
            self._model.idle.append(self)

    # ---- what it does ------------------------------------------------------------------------------------------------

    def find(self, t: float, given: dict[int, float], *, equations: bool) -> Found:
        """The start at time t: from the start values of the model, with those `given` by their place in x instead; with
        or without the initial equations of the model."""
        search, library = self._search, self._library
        self._checked(library.run_start(self._run, t, search.x))
        starts, told = search.begin(given, equations)
        self._checked(library.run_find(self._run, t, search.chosen if given else None, search.x, byref(told)))
        if self.settings.measures.start.free:
            self.p = np.array((c_double * len(self._layout.parameters)).from_address(told.p))
        return search.found(starts, self.p)

    def differentiate(self, t: float, starts: Floats, chosen: NDArray[np.uint8], of: Directions) -> Status:
        """The motion is differentiated along these directions, from the start that was found from `starts` at time t,
        of which those flagged in `chosen` (2 nq + nz,) were given."""
        return self.results.differentiate(self._model, of).start(self._run, t, chosen, starts)

    def find_again(self, t: float, found: Found) -> None:
        """The start that was found before, for the same model, parameters, inputs and start values, none of them free:
        without a search."""
        self.know(t, found.row_sizes, found.dependent)

    def know(self, t: float, row_sizes: Floats, dependent: Sequence[bool] | Flags) -> None:
        """The sizes of the rows (nc,) at the start at time t are known, and which depend on others."""
        search, library = self._search, self._library
        self._checked(library.run_start(self._run, t, search.x))
        if len(row_sizes):
            library.run_depend(self._run, search.again(row_sizes, dependent))

    @property
    def row_sizes(self) -> Floats:
        """Sizes of the rows (nc,) as the start has them."""
        return self._search.sizes_of_rows()

    def begin(self, t: float, x: Floats) -> Status:
        """The motion begins at the state x, with what happens there."""
        if isinstance(self.settings.inputs, HeldInputs):
            self.settings.inputs.begin(self._run, t)
        return self._done(self._library.run_begin(self._run, t, self._state(x)))

    def enter(self, t: float, x: Floats) -> Status:
        """Carries out the events at the start of a motion, and no more."""
        moved = self._done(self._library.run_move(self._run, t, self._state(x), 0.0))
        return moved or self._done(self._library.run_enter(self._run))

    def to(self, stop: float, steps: int) -> Status:
        """On to `stop`, with inputs as they are before a jump there, in at most so many steps."""
        return self._done(self._library.run_to(self._run, stop, steps))

    def over(self, stops: Floats) -> Callable[[int], Status]:
        """Goes on to each of `stops`, with the changes of inputs that jump there. A call takes about so many steps;
        the next one makes the rest."""
        passed = c_size_t(0)

        def on(steps: int) -> Status:
            return self._done(self._library.run_over(self._run, stops.ctypes.data, len(stops), steps, byref(passed)))

        return on

    def jump(self) -> Status:
        """Carries out the changes that inputs which jump now cause."""
        if isinstance(self.settings.inputs, HeldInputs):
            return self._done(self._library.hold_jump(self.settings.inputs.address))
        return self._done(self._library.run_jump(self._run))

    def change(self, model: NativeModel) -> None:
        """The functions of `model`, another filling of the same equations, from now on."""
        buffers = Buffers(model)
        self._told.kept.append(buffers)
        status = self._library.run_change(self._run, model.model, buffers.workspace.ctypes.data)
        assert status == Status.OK, "internal error: the compiled model is another one than the tape"
        self._model = model

    def saved(self) -> bytes:
        """The state of the run, as lag/serialization.h has it."""
        size = self._library.run_saved_size(self._model.model, byref(self._told.structure))
        buffer = create_string_buffer(size)
        self._library.run_save(self._run, buffer)
        return buffer.raw

    def load(self, saved: bytes) -> Status:
        """Takes the state of a run with the same settings; BAD_STATE_DATA: these bytes are none, nothing changes."""
        size = self._library.run_saved_size(self._model.model, byref(self._told.structure))
        return Status(self._library.run_load(self._run, saved)) if len(saved) == size else Status.BAD_STATE_DATA

    def end(self) -> Status:
        """Evaluates the end of the motion."""
        return self._done(self._library.run_end(self._run))

    def _checked(self, status: int) -> Status:
        for called in self._told.called:
            if called.problem is not None:
                raise called.problem
        if self._model.raised:
            raise self._model.raised.pop(0)
        return _STATUSES[status]

    @property
    def model(self) -> NativeModel:
        """The functions that it computes with."""
        return self._model

    @property
    def address(self) -> int:
        """Of the lag_run."""
        return self._run

    def _done(self, status: int) -> Status:
        if self.results.structure.note:
            self.results.take()
        return self._checked(status)
