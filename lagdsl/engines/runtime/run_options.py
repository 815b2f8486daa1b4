"""Options of a run, and their form in C."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import addressof
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.backends.start import Start as StartTold
from lagdsl.engines.runtime.called_along import CalledAlong
from lagdsl.engines.runtime.called_inputs import INPUTS, CalledInputs
from lagdsl.engines.runtime.engines.buffers import place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.library import Runtime, runtime_library
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.engines.runtime.structures import RunOptions, Start
from lagdsl.foundation.record import record, remembered

Flags = NDArray[np.bool_]
RunInputs: TypeAlias = "Floats | TabledInputs | HeldInputs | Callable[[float, bool], Floats]"


_NO_INPUTS = INPUTS()


def _no_directions() -> None:
    """For a run that nobody moves."""


@record(kw_only=True)
class Measures:
    """Settings that follow from the model, its start values and their time; nobody can write to the arrays. `group`,
    `natural`, `cap`: (2 nq + nz,), see lag/methods/accuracy.h. Of the rows whose `lasting` (nc,) is not zero `general`
    are independent in general."""

    start: StartTold
    group: Floats
    natural: Floats
    cap: Floats
    lasting: Floats
    general: int


@record(kw_only=True)
class RunSettings:
    """Options of a run: lag_run_options. `inputs` are the constant inputs (nu,), tables, inputs that are held over
    steps, or a function of time and of whether the value before a jump is wanted. `method` is the name of one of the
    runtime, or None for the automatic choice; `step` is the length of the steps of those that do not choose it. Rows
    are wanted at `times`; `invariant_tolerance` (ni,) None: nothing is watched."""

    p: Floats
    inputs: RunInputs
    measures: Measures
    times: Floats
    tolerance: float
    part: float
    method: str | None = None
    step: float = 0.0
    length: float = 0.0
    invariant_tolerance: Floats | None = None


def shared_options(library: Runtime, settings: RunSettings, kept: list[object]) -> RunOptions:
    """lag_run_options without parameters, natural sizes, inputs and results; what they point at is appended to
    `kept`."""
    options = RunOptions(careful=1, count=len(settings.times), times=address(settings.times, kept))
    tell_measures(options, settings.measures, kept)
    tell(options, library, settings)
    if settings.invariant_tolerance is not None:
        # one number more, so that it is not null where there are assertions only
        options.invariants.tolerance = address([*settings.invariant_tolerance.tolist(), 0.0], kept)
    return options


class ToldOptions:
    """Options of a run as C reads them, in memory of their own: the settings of the next run take their place."""

    def __init__(self, layout: Layout, along: Callable[[], NativeModel | None]) -> None:
        """`along` makes the functions of several directions of derivatives."""
        self.along = CalledAlong(along)
        self._p, self._times = np.zeros(layout.size(Group.P) + 1), np.zeros(0)
        self._u, self._tolerance = _placed(layout.size(Group.U)), _placed(len(layout.invariants))
        self._measures: tuple[Measures, list[object]] | None = None
        self.structure = RunOptions(careful=1, p=place_of(self._p))
        self.structure.callbacks.along = self.along.called

    def take(self, settings: RunSettings) -> None:
        """These from now on."""
        self.settings, self.kept = settings, list[object]()  # what C has the address of
        self.called: list[CalledInputs | CalledAlong] = [self.along]  # what C calls
        options = self.structure
        tell(options, runtime_library(), settings)
        self._p[:-1] = settings.p
        self._take_times(settings.times)
        self._take_tolerance(settings.invariant_tolerance)
        self._take_inputs(settings.inputs)
        if self._measures is None or self._measures[0] is not settings.measures:
            self._measures = settings.measures, list[object]()
            tell_measures(options, *self._measures)
            options.sizes.natural = address(settings.measures.natural, self._measures[1])

    def forget(self) -> None:
        """Arrays and functions of others, and the engine, need not live any longer."""
        self.along.make = _no_directions
        del self.settings, self.kept, self.called

    def _take_inputs(self, inputs: RunInputs) -> None:
        options = self.structure
        u, options.u = self._u
        if options.callbacks.inputs:
            options.callbacks.context, options.callbacks.inputs = None, _NO_INPUTS
        if isinstance(inputs, np.ndarray):
            u[:-1] = inputs
        elif isinstance(inputs, TabledInputs):
            inputs.tell(options, runtime_library(), self.kept)
            u[:-1] = inputs.u
        elif isinstance(inputs, HeldInputs):
            inputs.tell(options, runtime_library())
            self.called += [inputs.called] if inputs.called is not None else []
        else:
            asked = CalledInputs(inputs, range(len(u) - 1))
            options.callbacks.inputs, options.u = asked.called, None
            self.called.append(asked)

    def _take_times(self, times: Floats) -> None:
        if len(times) >= len(self._times):
            self._times = np.zeros(2 * len(times) + 1)
            self.structure.times = place_of(self._times)
        self._times[: len(times)], self.structure.count = times, len(times)

    def _take_tolerance(self, tolerance: Floats | None) -> None:
        """That of invariants, with one number more, so that it is not null where there are assertions only."""
        own, place = self._tolerance
        self.structure.invariants.tolerance = None if tolerance is None else place
        if tolerance is not None:
            own[:-1] = tolerance


def _placed(count: int) -> tuple[Floats, int]:
    """So many numbers, and one more, so that there is a place; and where they are."""
    numbers = np.zeros(count + 1)
    return numbers, place_of(numbers)


def tell_measures(options: RunOptions, measures: Measures, kept: list[object]) -> None:
    """The measures but for natural sizes, into `options`."""
    options.sizes.group = address(measures.group, kept)
    options.sizes.cap = address(measures.cap, kept)
    options.lasting.rows, options.lasting.general = address(measures.lasting, kept), measures.general
    start = _start(measures.start)
    kept.append(start)
    options.start = addressof(start[0])


def tell(options: RunOptions, library: Runtime, settings: RunSettings) -> None:
    """Numbers and the method, into `options`."""
    options.tolerance, options.part, options.h_fixed = settings.tolerance, settings.part, settings.step
    options.length = settings.length
    options.method = None if settings.method is None else library.methods[settings.method]


def address(values: ArrayLike, kept: list[object], kind: type = np.float64) -> int:
    """Of a copy, or of an array that nobody can write to; it is appended to `kept`."""
    settled = isinstance(values, np.ndarray) and values.flags.c_contiguous and not values.flags.writeable
    own: NDArray[Any] = np.asarray(values, dtype=kind) if settled else np.array(values, dtype=kind)
    kept.append(own)
    return place_of(own)


@remembered
def _start(told: StartTold) -> tuple[Start, list[object]]:
    """The structure, and what it points at."""
    kept: list[object] = []
    flags = {name: address(getattr(told, name), kept, np.uint8) for name in ("fixed", "written")}
    numbers = {name: address(getattr(told, name), kept) for name in ("nominal", "minimum", "maximum")}
    if told.free:
        flags["free"] = address(told.free, kept, np.uint8)
        for name in ("parameter_nominal", "parameter_minimum", "parameter_maximum"):
            numbers[name] = address(getattr(told, name), kept)
    return Start(t=told.t, **flags, **numbers), kept
