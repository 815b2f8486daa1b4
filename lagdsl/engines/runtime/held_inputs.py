"""Inputs that are held over a step and jump where the next one begins, beside others that follow time: lag/hold.h."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import addressof, cast

import numpy as np

from lagdsl.engines.runtime.called_inputs import INPUTS, CalledInputs
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.library import Runtime
from lagdsl.engines.runtime.signal_tables import SignalTable
from lagdsl.engines.runtime.structures import Hold, RunOptions, Signal, Signals


class HeldInputs:
    """`u` (nu,) is used where it lies: whoever steps changes it. `functions` are those of Python and the `tables` of
    the inputs that follow time, None for the others; these may jump at `breaks`. `hold` is the lag_hold of one run."""

    def __init__(
        self,
        u: Floats,
        tables: Sequence[SignalTable | None] = (),
        functions: Sequence[Callable[[float, bool], float] | None] = (),
        breaks: Sequence[float] = (),
    ) -> None:
        self.u, self.before = u, u.copy()
        self._given = (tables, functions, breaks)
        self.hold = Hold(count=len(u), u=u.ctypes.data, before=self.before.ctypes.data, jumped=np.nan)
        self.called: CalledInputs | None = None
        self._at = np.array(breaks, dtype=np.float64)
        self.hold.breaks, self.hold.at = len(self._at), self._at.ctypes.data
        self._tables = self._signals = None
        if any(table is not None for table in tables):
            self._tables = (Signal * len(tables))(*(Signal() if each is None else each.told for each in tables))
            self._signals = Signals(count=len(tables), signal=addressof(self._tables))
            self.hold.signals = addressof(self._signals)
        places = [place for place, function in enumerate(functions) if function is not None]
        if places:
            wanted = [function for function in functions if function is not None]
            self.called = CalledInputs(lambda t, before: np.array([each(t, before) for each in wanted]), places)
            self.hold.inputs = self.called.called

    def beside(self, u: Floats) -> HeldInputs:
        """The same for another run, whose held inputs are `u`."""
        return HeldInputs(u, *self._given)

    @property
    def address(self) -> int:
        return addressof(self.hold)

    def tell(self, options: RunOptions, library: Runtime) -> None:
        """Sets them in `options`."""
        options.u = self.u.ctypes.data
        if len(self.u):
            options.callbacks.inputs = cast(library.hold_tell, INPUTS)
            options.callbacks.context = self.address

    def begin(self, run: int, t: float) -> None:
        """The run at this address begins at time t with the present values."""
        self.before[:] = self.u
        self.hold.run, self.hold.goal, self.hold.jumped = run, t, np.nan
