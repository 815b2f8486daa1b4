"""How a run ends before its time: what is reported, and the motion so far."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NoReturn

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import located
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.failure import SimulationFailed
from lagdsl.simulate.motion.task import EPSILON, Task, Tools
from lagdsl.simulate.trajectory import Trajectory
from lagdsl.simulate.trouble import component_name, report_trouble, state_text, state_values, time_text


class Ends:
    """All methods that do not return raise SimulationFailed; `so_far()` is the trajectory up to there."""

    def __init__(self, task: Task, tools: Tools, accuracy: Accuracy, so_far: Callable[[], Trajectory]) -> None:
        self._task, self._flat = task, task.flat
        self._system, self._projection = tools.system, tools.projection
        self._accuracy, self._so_far = accuracy, so_far

    def require_progress(self, t: float, y: Floats, step: float, lost: tuple[float, Floats] | None = None) -> None:
        """End the run if steps are no longer than the round-off of time; `lost` is a state off the constraints."""
        if not self._task.too_short(t, step):
            return
        if lost is not None:
            row, size = self._projection.worst(*lost)
            item = next(item for item in located(self._flat) if row in item.rows)
            name = self._task.engine.layout.constraints[row].name
            self.fail("E0811", t, y, item.constraint.spans, name=name, residual=f"{size:.3g}")
        self.stuck(t, y)

    def require_acceleration(self, t: float, y: Floats) -> None:
        """End the run where there are no accelerations."""
        if not np.all(np.isfinite(self._system(t, y))):
            self._without_acceleration(t, y)

    def stuck(self, t: float, y: Floats) -> NoReturn:
        """The step shrank to nothing: because of trouble just ahead, or because the motion runs away."""
        trouble = self._system.trouble
        if trouble is not None and trouble.t >= t:
            self._without_acceleration(t, y)
        speed = np.abs(self._system(t, y)) / self._accuracy.after(y)
        index = int(np.argmax(np.nan_to_num(speed, nan=np.inf)))
        step = f"{16.0 * EPSILON * self._task.last:.1g}"
        self.fail("E0809", t, y, None, name=component_name(self._flat, index), step=step)

    def fail(self, code: str, t: float, y: Floats, spans: Any, **arguments: Any) -> NoReturn:
        report = Sink()
        notes = (f"state: {state_text(self._flat, y)}",)
        report.report(code, spans[0] if spans else None, notes=notes, time=time_text(t), **arguments)
        name = arguments.get("name")
        self.raise_reported(report, t, y, None if name is None else str(name))

    def raise_reported(self, report: Sink, t: float, y: Floats, name: str | None) -> NoReturn:
        """What stands last in `report` ends the run."""
        raise SimulationFailed(report.diagnostics[-1], t, state_values(self._flat, y), name, self._so_far())

    def _without_acceleration(self, t: float, y: Floats) -> NoReturn:
        trouble = self._system.trouble
        assert trouble is not None
        report = Sink()
        name = report_trouble(self._flat, self._system, trouble, report)
        self.raise_reported(report, t, y, name)
