"""Events that the C runtime carries out; Python finds those of its own steps and tells what happened."""

from __future__ import annotations

import numpy as np

from lagdsl.flat.event_flow import branches
from lagdsl.flat.events import Check, Reset
from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item
from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.c_run import CRun, Status, Told
from lagdsl.simulate.events.happenings import Found, Happenings
from lagdsl.simulate.events.passes import Result
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.trajectory import Event

_BLAMED = {Status.UNSETTLED: "E0804", Status.CHATTER: "E0833", Status.PIERCED: "E0834"}


class CompiledHappenings(Happenings):
    """All memory of clocks and contacts is that of the run in C."""

    def __init__(
        self, flat: FlatModel, system: RightHandSide, projection: Projection, span: tuple[float, float], run: CRun
    ) -> None:
        super().__init__(flat, system, projection, span)
        self._run = run
        actions = [action for branch in branches(flat) for action in branch.actions]
        self._resets = [action for action in actions if isinstance(action, Reset)]
        self._checks = [action for action in actions if isinstance(action, Check)]
        self._refused: tuple[str, Item, str] | None = None
        run.before = self._before
        run.after = self._after
        if self.active:
            self._contacts.slack = np.ctypeslib.as_array(run.report.slack, shape=(2,))

    def _before(self, t: float) -> None:
        """Inputs that jump at the end of a segment are taken from the right when something happens there."""
        if t >= self._system.until:
            self._system.enter(np.inf)

    def _after(self, t: float, y: Floats, w: Floats) -> bool:
        """Whether the positions are those that constraints want now."""
        self._system.with_discretes(w)
        self._refused = self._passes.torn(t, y)
        return self._refused is None

    def begin(self, t: float, y: Floats) -> Result:
        result = self.result(self._run.enter(t, y))
        result.failed = result.failed or self._passes.torn(t, result.y)
        return result

    def end(self, t: float, y: Floats) -> Result:
        return self.result(self._run.end(t, y))

    def next_tick(self) -> float:
        return float(self._run.report.next)

    def tick(self, t: float) -> Found | None:
        return Found(t) if self._run.due(t) else None

    def carry_out(self, found: Found, y: Floats) -> Result:
        """Where nothing changed, it is clocks that tick."""
        changed = np.zeros(len(self._discretes.relations) + len(self._discretes.contacts) + 1)
        changed[[*found.relations, *(len(self._discretes.relations) + i for i in found.contacts)]] = 1.0
        if changed.any():
            return self.result(self._run.event(found.t, y, self._passes.moment, changed))
        return self.result(self._run.ticks(found.t, y))

    def result(self, status: int) -> Result:
        """Where the run stands, what happened in its last call, and whether that came to a good end."""
        run = self._run
        w = run.discretes()
        self._system.with_discretes(w)
        self.events += [
            Event(time=told.t, name=self._name(told), kind=told.what) for told in run.told if not len(told.y)
        ]
        stop = "" if status == Status.STOPPED else None
        return Result(run.state(), w, stop=stop, failed=self._refused or self._failure(status))

    def _name(self, told: Told) -> str:
        events, which = self._discretes.flat.events, told.which
        instants = self._system.engine.layout.instants
        match told.what:
            case "tick":
                return events.clocks[which].name
            case "true" | "false" | "jump":
                known = len(events.relations)
                return events.relations[which].name if which < known else events.timed[which - known].name
            case "reinit":
                return instants.resets[which]
            case "terminate":
                return instants.stops[which]
            case _:
                return events.contacts[which].name

    def _failure(self, status: int) -> tuple[str, Item, str] | None:
        fault = int(self._run.report.fault)
        match status:
            case Status.UNSETTLED | Status.CHATTER | Status.PIERCED:
                return self._passes.blame(_BLAMED[Status(status)], self._run.guilty())
            case Status.CONFLICT:
                return "E0832", self._resets[fault], self._resets[fault].name
            case Status.TORN:
                return self._passes.tears(float(self._run.report.t), self._run.state())
            case Status.REFUSED:
                return "E0810", self._checks[fault], self._checks[fault].message
            case _:
                return None
