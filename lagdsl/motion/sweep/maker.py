"""Makes runs: in C, many in one call.

A run that fails, that C is not told of (inputs that are functions of Python), or that is differentiated, is made by
itself, so that its words are those of a single run.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Sequence

from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.engines.runtime.ensemble import Bench, Stop
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.motion.sweep.ensemble import Ensemble
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Interrupted, Options, Outcome, Runner, SweptModel

# Seconds that the runs of one call of C should take: long beside what Python does about them, short for people who
# look at the progress. Runs of one call, so that their rows are few.
_PART, _LARGEST = 0.25, 1024


class Ensembles:
    """The models of a sweep for all threads; each is built when it is first needed."""

    def __init__(self, subjects: Sequence[SweptModel], options: Options) -> None:
        self._subjects, self._options = subjects, options
        self._known: dict[int, Ensemble | None] = {}
        self._lock = threading.Lock()

    def of(self, swept: int) -> Ensemble | None:
        """None where nothing can be built: every run tells why."""
        with self._lock:
            if swept not in self._known:
                self._known[swept] = self._built(self._subjects[swept])
            return self._known[swept]

    def _built(self, swept: SweptModel) -> Ensemble | None:
        if swept.flat is None or swept.program is None or self._options.tangents:
            return None
        try:
            return Ensemble(swept.flat, engine_of(swept.program, self._options.engine, together=True), self._options)
        except CompilationFailed:
            return None


class Maker:
    """Makes the runs of one thread."""

    def __init__(self, subjects: Sequence[SweptModel], options: Options, ensembles: Ensembles, stop: Stop) -> None:
        self._ensembles, self._stop, self._bench = ensembles, stop, Bench()
        self._runner = Runner(subjects, options, self._progress)
        self._seconds = _PART  # of one run, as the last part took
        self.together = 1  # so many runs of the last model go on together

    def leave(self) -> None:
        """No more runs are to be made."""
        self._runner.leave()

    def size(self) -> int:
        """So many runs should be made next."""
        return max(self.together, min(_LARGEST, int(_PART / self._seconds)))

    def run(self, tasks: list[Task], left: int) -> list[Outcome]:
        """The outcomes; fewer where it was stopped. `left` runs are to be made after them."""
        ensemble = self._ensembles.of(tasks[0].swept)
        begun = time.perf_counter()
        outcomes = [None] * len(tasks) if ensemble is None else ensemble.run(tasks, self._bench, self._stop)
        self._seconds = (time.perf_counter() - begun) / len(tasks) + 1e-6
        if ensemble is not None:
            self.together = ensemble.worked(self._seconds * len(tasks), self._seconds * left)
        return [outcome or self._runner(task) for task, outcome in zip(tasks, outcomes, strict=False)]

    def _progress(self, part: float) -> None:
        if self._stop.is_set:
            raise Interrupted
