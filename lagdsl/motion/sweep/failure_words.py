"""Words for the runs of an ensemble that fail: those of a run that is made by itself."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.engines.backends.start import free_parameters
from lagdsl.engines.runtime.ensemble import EnsembleSettings, Failed
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.simulate.initial_words import report_found, report_no_start, report_numbers
from lagdsl.motion.simulate.messages import Course, report_fault
from lagdsl.motion.simulate.stepping import MOST_STEPS
from lagdsl.motion.sweep.run import first_error

# Of so many runs it is looked for what contradicts each other at the start, which takes as long as many runs.
_MOST_SEARCHED = 8


class FailureWords:
    """`told` has, by the number of a run, its message and the time of its end [s], None where it did not begin.
    `inputs` tells the inputs (nu,) of a run by its number at a time."""

    def __init__(
        self, flat: FlatModel, layout: Layout, settings: EnsembleSettings, inputs: Callable[[int, float], Floats]
    ) -> None:
        self._flat, self._layout, self._settings, self._inputs = flat, layout, settings, inputs
        self.told: dict[int, tuple[str, float | None]] = {}
        self._finds = bool(free_parameters(flat))

    def hear(self, row: int, failed: Failed) -> None:
        """Of a run as it fails. One that cannot be told here is made by itself."""
        try:
            with np.errstate(all="ignore"):
                self.told[row] = self._words(row, failed)
        except Exception:  # nothing may be raised through C
            self.told.pop(row, None)

    def wrong(self, p: Floats) -> str | None:
        """Why a motion with the parameters p (np,), those that were found too, must not be."""
        if not self._finds:
            return None
        sink = Sink()
        report_found(self._flat, self._layout, p, sink)
        return first_error(sink.diagnostics)

    def _words(self, row: int, failed: Failed) -> tuple[str, float | None]:
        flat, layout, run, t0, sink = self._flat, self._layout, failed.run, self._settings.t, Sink()
        if failed.found is not None:
            if not report_numbers(flat, failed.starts, self._inputs(row, t0), sink):
                searched = len(self.told) < _MOST_SEARCHED
                report_no_start(flat, layout, run, t0, failed.found, sink, searched=searched)
            return _message(first_error(sink.diagnostics)), None
        limit = self.wrong(run.p)
        if limit is not None:
            return limit, None
        fault = run.explain(failed.status)
        course = Course(flat, layout, run, self._settings.stop, MOST_STEPS)
        report_fault(course, failed.status, fault, self._inputs(row, fault.t), sink)
        return _message(first_error(sink.diagnostics[-1:])), fault.t


def _message(found: str | None) -> str:
    if found is None:
        raise AssertionError("a run failed, and nothing is wrong with it")
    return found
