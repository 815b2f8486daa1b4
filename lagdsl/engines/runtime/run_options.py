"""Options of a run, and their form in C."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import addressof
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.start import Start as StartTold
from lagdsl.engines.runtime.engines.buffers import place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.library import Runtime
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.engines.runtime.structures import RunOptions, Start
from lagdsl.foundation.record import record, remembered

Flags = NDArray[np.bool_]
RunInputs: TypeAlias = "Floats | TabledInputs | HeldInputs | Callable[[float, bool], Floats]"


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
