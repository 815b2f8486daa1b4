"""A run of the C runtime as it stands: what can be asked of it, also after it failed."""

from __future__ import annotations

from ctypes import byref, c_size_t, sizeof

import numpy as np

from lagdsl.derivation.program.functions import ALONG_MANY, OPTIONAL, SIGNATURES
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.buffers import place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.run_options import Flags
from lagdsl.engines.runtime.structures import Initial, InitialFault, RunFault, RunOptions, RunReport, Status
from lagdsl.foundation.record import record

# Place of lag_motion in lag_run, which begins with its options.
_MOTION = sizeof(RunOptions)
_FUNCTIONS = [name for name in (*SIGNATURES, *OPTIONAL) if name not in ALONG_MANY]


@record(kw_only=True)
class Found:
    """The start that was found, or what stands in the way: lag_initial. x (2 nq + nz,), `starts` are the values that
    it was looked for from, which the search may have `moved`; `dependent`, `row_sizes` (nc,) of the rows; `p` are the
    parameters, those that were found too."""

    starts: Floats
    x: Floats
    fault: InitialFault
    which: int
    residual: float
    rank: int
    freedom: int
    excess: int
    general: int
    dependent: Flags
    moved: bool
    row_sizes: Floats
    p: Floats


def found_of(told: Initial, starts: Floats, x: Floats, p: Floats, dependent: np.ndarray, row_sizes: Floats) -> Found:
    """`told` with the arrays that it points at."""
    return Found(
        starts=starts,
        x=x,
        fault=InitialFault(told.fault),
        which=told.which,
        residual=told.residual,
        rank=told.rank,
        freedom=told.freedom,
        excess=told.excess,
        general=told.general,
        dependent=dependent.astype(np.bool_),
        moved=bool(told.moved),
        row_sizes=row_sizes.copy(),
        p=p,
    )


@record(kw_only=True)
class Fault:
    """Why a run ended: lag_fault."""

    t: float
    x: Floats
    which: int
    value: float
    limit: float


class RunView:
    """The lag_run at the address `run`, with parameters p (np,) in the end."""

    def __init__(self, run: int, layout: Layout, size: int, p: Floats) -> None:
        self._library, self._run, self._layout = runtime_library(), run, layout
        self.size, self.p = size, p
        self._report = RunReport()
        self._at = np.zeros(size + 1)  # one number more, so that there is a place where there is no state
        self._at_place = place_of(self._at)

    @property
    def report(self) -> RunReport:
        self._library.run_tell(self._run, byref(self._report))
        return self._report

    @property
    def t(self) -> float:
        return float(self.report.t)

    @property
    def x(self) -> Floats:
        """The present state, a copy."""
        return np.array(self.report.x[: self.size])

    @property
    def w(self) -> Floats:
        """The discretes, a copy."""
        return np.array(self.report.w[: len(self._layout.discretes)])

    def guilty(self) -> list[int]:
        """The discretes because of which an event failed."""
        report = self.report
        return [k for k in range(len(self._layout.discretes)) if report.guilty[k] != 0.0]

    def doubted(self, relations: int) -> list[float]:
        """For each relation the first time [s] at which it turned by what may be the method's error, or infinity."""
        return [float(time) for time in self.report.doubted[:relations]] if relations else []

    def changes(self) -> list[tuple[float, bool]]:
        """Time and kind (to an implicit one) of the first changes of the method."""
        report = self.report
        return [(float(report.change[i].t), bool(report.change[i].implicit)) for i in range(min(report.changes, 16))]

    def explain(self, status: Status) -> Fault:
        """Why it ended with this status."""
        told = RunFault()
        self._library.run_explain(self._run, status, byref(told))
        x = np.array(told.x[: self.size])
        return Fault(t=told.t, x=x, which=told.which, value=told.value, limit=told.limit)

    def rank(self) -> tuple[int, int, int]:
        """Independent rows of constraints now and in general, and the row with the largest share in what is lost."""
        general, weakest = c_size_t(0), c_size_t(0)
        rank = int(self._library.run_rank(self._run, byref(general), byref(weakest)))
        return rank, general.value, weakest.value

    def evaluate(self, function: str, t: float, x: Floats, count: int) -> Floats:
        """The results of a function of the model, `count` numbers one after the other, at the state x with the present
        discretes."""
        results = np.zeros(count + 1)
        self._library.run_evaluate(self._run, _FUNCTIONS.index(function), t, self._state(x), results.ctypes.data)
        return results[:count]

    def take_parameters(self, p: Floats) -> None:
        """Evaluations take the parameters p (np,) from now on: for a run that has failed."""
        self.p = p
        self._library.motion_parameters(self._run + _MOTION, p.ctypes.data)

    def _state(self, x: Floats) -> int:
        self._at[:-1] = x
        return self._at_place
