"""Inputs that tables tell, as the C runtime reads them: lag/signals.h."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import addressof, byref, cast
from typing import Any

import numpy as np

from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.library import Runtime, runtime_library
from lagdsl.engines.runtime.structures import RunCallbacks, RunOptions, Signal, SignalKind, Signals
from lagdsl.foundation.record import record

_INPUTS: Any = next(field[1] for field in RunCallbacks._fields_ if field[0] == "inputs")


class SignalTable:
    """lag_signal: a function of time in pieces, with `times` (count,) and `values` (count,); those of a POLYNOMIAL are
    coefficients (count - 1, terms), the highest power first."""

    def __init__(self, kind: SignalKind, times: Floats, values: Floats) -> None:
        self._held = [np.array(each, dtype=np.float64, order="C") for each in (times, values)]
        time, value = (each.ctypes.data for each in self._held)
        self.last = float(times[-1])
        self.told = Signal(kind=kind, count=len(times), terms=values.shape[-1], time=time, value=value)

    def __call__(self, t: float, before: bool) -> float:
        """The value at time t [s], or before a jump there."""
        return float(runtime_library().signal_at(byref(self.told), t, before))


@record()
class TabledInputs:
    """Inputs by their tables; those without one stay as they are in `u`, (nu,) or (runs, nu)."""

    u: Floats
    tables: Sequence[SignalTable | None]

    def tell(self, options: RunOptions, library: Runtime, kept: list[object]) -> None:
        """Sets them in `options`; memory that these point at is appended to `kept`."""
        signals = (Signal * len(self.tables))(*(Signal() if table is None else table.told for table in self.tables))
        every = Signals(count=len(signals), signal=addressof(signals))
        kept += [self.tables, signals, every]
        options.callbacks.inputs = cast(library.signals_tell, _INPUTS)
        options.callbacks.context = addressof(every)
