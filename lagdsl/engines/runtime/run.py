"""A run of the C runtime: one model, in one block of memory, from a start that it finds to wherever it ends."""

from __future__ import annotations

import os
from collections.abc import Callable
from ctypes import addressof, byref, c_double, create_string_buffer
from mmap import ACCESS_COPY, ACCESS_DEFAULT, mmap

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.called_along import CalledAlong
from lagdsl.engines.runtime.called_inputs import CalledInputs
from lagdsl.engines.runtime.engines.buffers import Buffers
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.run_options import RunSettings, address, shared_options
from lagdsl.engines.runtime.run_results import RunResults
from lagdsl.engines.runtime.run_view import Found, RunView, found_of
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.engines.runtime.structures import Initial, RunOptions, Status


def _zeros(size: int) -> Floats:
    """So many bytes, in pages of the system that are there when they are touched.

    NumPy asks for huge pages, of which an entry in each row of a matrix touches all.
    """
    own = ACCESS_COPY if os.name == "posix" else ACCESS_DEFAULT
    return np.frombuffer(mmap(-1, -(-size // 8) * 8, access=own), dtype=np.float64)


class Run(RunView):
    """Not to be used by several threads at once. The call that asked for inputs raises their exceptions.

    `p` are the parameters, those that are found with the start too. `along` makes the functions of several directions
    of derivatives, when the run needs them.
    """

    def __init__(
        self, model: NativeModel, layout: Layout, settings: RunSettings, along: Callable[[], NativeModel | None]
    ) -> None:
        super().__init__(0, layout, 2 * layout.size(Group.Q) + layout.size(Group.Z), settings.p)
        self._model, self.settings = model, settings
        self._called: list[CalledInputs | CalledAlong] = []  # what C calls
        self._kept: list[object] = []  # what C has the address of
        self._row_sizes = np.ones(len(layout.constraints))
        self.results = RunResults(self._library, model, layout, settings, self._kept)
        self._told = options = self._options(along)
        options.zeroed = 1
        self._size = size = int(self._library.run_size(model.model, byref(options)))
        block = _zeros(size)
        self._kept.append(block)
        self._run = self._library.run_place(block.ctypes.data, model.model, byref(options))

    def renew(self) -> bool:
        """Lets it be a run with the same settings that has not begun; False if the model that it goes on with now does
        not fit into its memory."""
        self._told.zeroed = 0
        if self._library.run_size(self._model.model, byref(self._told)) > self._size:
            return False
        self._library.run_place(self._run, self._model.model, byref(self._told))
        self.p = self.settings.p
        self.results.forget()
        return True

    def _options(self, along: Callable[[], NativeModel | None]) -> RunOptions:
        settings = self.settings
        options = shared_options(self._library, settings, self._kept)
        options.p = address(settings.p, self._kept)
        options.sizes.natural = address(settings.natural, self._kept)
        options.sizes.row_sizes = self._row_sizes.ctypes.data
        if settings.invariant_tolerance is not None:
            for name, values in zip(("start", "size", "drift"), self.results.drifts, strict=True):
                setattr(options.invariants, name, values.ctypes.data)
        inputs = settings.inputs
        if isinstance(inputs, TabledInputs):
            inputs.tell(options, self._library, self._kept)
            options.u = address(inputs.u, self._kept)
        elif isinstance(inputs, HeldInputs):
            inputs.tell(options, self._library)
            self._called += [inputs.called] if inputs.called is not None else []
        elif callable(inputs):
            asked = CalledInputs(inputs, range(self._layout.size(Group.U)))
            options.callbacks.inputs = asked.called
            self._called.append(asked)
        else:
            options.u = address(inputs, self._kept)
        directions = CalledAlong(along)
        options.callbacks.along = directions.called
        self._called.append(directions)
        options.results = addressof(self.results.structure)
        return options

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

    def jump(self) -> Status:
        """Carries out the changes that inputs which jump now cause."""
        if isinstance(self.settings.inputs, HeldInputs):
            return self._done(self._library.hold_jump(self.settings.inputs.address))
        return self._done(self._library.run_jump(self._run))

    def change(self, model: NativeModel) -> None:
        """The functions of `model`, another filling of the same equations, from now on."""
        buffers = Buffers(model)
        self._kept.append(buffers)
        status = self._library.run_change(self._run, model.model, buffers.workspace.ctypes.data)
        assert status == Status.OK, "internal error: the compiled model is another one than the tape"
        self._model = model

    def saved(self) -> bytes:
        """The state of the run, as lag/serialization.h has it."""
        size = self._library.run_saved_size(self._model.model, byref(self._told))
        buffer = create_string_buffer(size)
        self._library.run_save(self._run, buffer)
        return buffer.raw

    def load(self, saved: bytes) -> Status:
        """Takes the state of a run with the same settings; BAD_STATE_DATA: these bytes are none, nothing changes."""
        size = self._library.run_saved_size(self._model.model, byref(self._told))
        return Status(self._library.run_load(self._run, saved)) if len(saved) == size else Status.BAD_STATE_DATA

    def end(self) -> Status:
        """Evaluates the end of the motion."""
        return self._done(self._library.run_end(self._run))

    def _checked(self, status: int) -> Status:
        for called in self._called:
            if called.problem is not None:
                raise called.problem
        if self._model.raised:
            raise self._model.raised.pop(0)
        return Status(status)

    @property
    def model(self) -> NativeModel:
        """The functions that it computes with."""
        return self._model

    @property
    def address(self) -> int:
        """Of the lag_run."""
        return self._run

    def _done(self, status: int) -> Status:
        self.results.take()
        return self._checked(status)
