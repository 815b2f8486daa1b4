"""Which method integrates: implicit where stability limits the step, explicit again where that does not pay."""

from __future__ import annotations

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.integrators import METHODS, Method, with_steps
from lagdsl.simulate.motion.task import Task, Tools
from lagdsl.simulate.stiffness import Stiffness
from lagdsl.simulate.trouble import time_text


class Choice:
    """`method` is the present one; changes are told in `notes`."""

    def __init__(self, task: Task, tools: Tools, notes: list[str]) -> None:
        self._system, self._notes = tools.system, notes
        self._stiffness = Stiffness() if task.solver == "auto" else None
        method = METHODS["dop853" if task.solver == "auto" else task.solver]
        self.method: Method = method if task.step is None else with_steps(method, task.step)
        self.accuracy = Accuracy(task.flat, tools.space.sizes, self.method.factor * task.tolerance)
        self._tolerance = task.tolerance
        self._since = task.initial.t
        self._followed = 0

    def leave_to_c(self) -> None:
        """The method is chosen by somebody else, see `follow`."""
        self._stiffness = None

    def reconsider(self, t: float, y: Floats, step: float) -> bool:
        """After an accepted step, for `auto`: whether the method has changed."""
        stiffness = self._stiffness
        if stiffness is None:
            return False
        if not self.method.implicit:
            if not stiffness.seems_stiff(step, lambda: self._system.jacobian(t, y)):
                return False
            stiffness.implicit_started()
            self._change(METHODS["radau"], t, "stability, not accuracy, limited the steps")
        elif stiffness.not_worth_it(t - self._since):
            self._change(METHODS["dop853"], t, "implicit steps were hardly longer")
        else:
            return False
        return True

    def follow(self, changes: list[tuple[float, bool]]) -> None:
        """Where C changed its method, at these times, to implicit or not, the steppers of this loop do so too."""
        for t, implicit in changes[self._followed :]:
            why = "stability, not accuracy, limited the steps" if implicit else "accuracy limits the steps again"
            self._change(METHODS["radau" if implicit else "dop853"], t, why)
            self._followed += 1

    def _change(self, method: Method, t: float, why: str) -> None:
        self._notes.append(f"changed from {self.method.name} to {method.name} at t = {time_text(t)} s: {why}")
        self.method = method
        self._since = t
        self.accuracy.relative = method.factor * self._tolerance
