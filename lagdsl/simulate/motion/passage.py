"""Singular positions on the way: rank is watched, the motion out of and across them is fitted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from lagdsl.flat.model import Constraint
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import contact_rows, located, place
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.departure import Departure, cross, depart
from lagdsl.simulate.motion.ends import Ends
from lagdsl.simulate.motion.task import Task, Tools
from lagdsl.simulate.singular import LOST, MEETING, NEAR, Look, Ranks, saddle_height
from lagdsl.simulate.trouble import time_text

# J has turned by much in a step where less than this part of a direction is left; so often a step is halved to see
# whether it turned steadily.
_TURNED = 0.25
_HALVINGS = 6
# Nearer to a lost rank than this the branches are not told apart any more.
_UNDECIDED = 1e-5
# A fitted crossing is as smooth as this, in tolerances, within these bounds.
_SMOOTH, _SMOOTHEST, _ROUGHEST = 10.0, 1e-9, 1e-7


class Passage:
    """Remembers J at the last states. What it tells the user it appends to `notes`."""

    def __init__(self, task: Task, tools: Tools, accuracy: Accuracy, ends: Ends, notes: list[str]) -> None:
        self._task, self._system, self._space = task, tools.system, tools.space
        self._exact, self._projection = tools.exact, tools.projection
        self._accuracy, self._ends, self._notes = accuracy, ends, notes
        loose = contact_rows(task.flat)
        lasting = tuple(flag or row in loose for row, flag in enumerate(task.initial.redundant))
        self.ranks = Ranks(self._space, lasting)
        self._look: Look | None = None
        self._times = (-np.inf, -np.inf)
        self._margins = (np.inf, np.inf)

    # ---- what is known -----------------------------------------------------------------------------------------------

    @property
    def lost(self) -> bool:
        """Whether rank is lost at the last state."""
        return self._margins[1] <= LOST

    def projected(self, t: float, y: Floats) -> Floats | None:
        """Branches are told apart by the constraints alone where rank is nearly lost."""
        return (self._exact if self._margins[1] < NEAR else self._projection)(t, y)

    def look_at(self, t: float, y: Floats) -> None:
        """A state that the motion has reached."""
        if not self._projection.active:
            return
        jacobian = self._jacobian(t, y)
        look = self.ranks.look(jacobian)
        self._times, self._margins = (self._times[1], t), (self._margins[1], look.margin)
        if self._look is None and look.margin <= LOST:
            self._tell_lost_rank(t, jacobian, look.rank)
        self._look = look

    def forget(self, t: float) -> None:
        """States before this one are too far away to tell where the motion leads."""
        self._times, self._margins = (-np.inf, t), (np.inf, self._margins[1])

    def distance(self) -> float | None:
        """The time until rank is lost, if the last two states lead to that and it is near."""
        (earlier, later), (before, now) = self._times, self._margins
        if not now < min(NEAR, before) or not np.isfinite(before):
            return None
        return now * (later - earlier) / (before - now)

    def lost_at(
        self, t: float, y: Floats, after: float, reached: Floats, dense: Callable[[], Callable[[float], Floats]]
    ) -> float | None:
        """The time in a step at which rank was lost, about; None where it was not."""
        look = self._look
        if look is None or not look.directions:
            return None
        jacobian = self._jacobian(after, reached)
        turn = self.ranks.turn(look, jacobian)
        if turn >= _TURNED:
            return None
        state, first, last = dense(), t, after
        for _ in range(_HALVINGS):
            middle = 0.5 * (first + last)
            between = self._jacobian(middle, np.asarray(state(middle)))
            if self.ranks.turn(look, between) < _TURNED:
                last, jacobian = middle, between
            else:
                first, look = middle, self.ranks.look(between)
            turn = self.ranks.turn(look, jacobian)
            if turn >= _TURNED:
                if last >= after:
                    return None
                first, look, last, jacobian = last, self.ranks.look(jacobian), after, self._jacobian(after, reached)
        return first + (last - first) / (1.0 - min(turn, 0.0))

    # ---- the way on --------------------------------------------------------------------------------------------------

    def leave(self, t: float, y: Floats, end: float) -> Departure | None:
        """The motion out of a singular position."""
        return depart(self._system, self._exact, self._space.sizes, t, y, end)

    def cross(self, t: float, y: Floats, distance: float, end: float) -> Departure | None:
        """The motion across a singular position so far ahead, if there is one and the motion leads across."""
        if t >= end:
            return None

        def meets(time: float, state: Floats) -> bool:
            return self._saddle_height(time, state) <= MEETING

        n = self._system.n
        ahead = np.concatenate([y[:n] + distance * y[n : 2 * n], y[n:]])
        if MEETING < self._saddle_height(t + distance, ahead) < np.inf:  # a first look, much cheaper than a fit
            return None
        relative = float(np.clip(_SMOOTH * self._task.tolerance, _SMOOTHEST, _ROUGHEST))
        tolerances = self._accuracy.after(y)[n:] * relative / self._accuracy.relative
        found = cross(self._system, self._exact, t, y, distance, end, meets=meets, tolerances=tolerances)
        if found is None or self.ranks.look(self._jacobian(t + found.length, found.y)).margin <= LOST:
            return None
        return found

    def require_decided(self, t: float, y: Floats, step: float) -> None:
        """End the run where branches cannot be told apart. Where none meet rates run away; that shows by itself."""
        margin = self._margins[1]
        if margin > _UNDECIDED and not self._task.too_short(t, step):
            return
        if margin > LOST and not np.isfinite(self._saddle_height(t, y)):
            return
        constraint, name = self._weakest(self._jacobian(t, y))
        self._ends.fail("E0830", t, y, (place(constraint),), name=name)

    def _tell_lost_rank(self, t: float, jacobian: Floats, rank: int) -> None:
        constraint, name = self._weakest(jacobian)
        general, time = self.ranks.general, time_text(t)
        self._task.sink.report("W0608", place(constraint), time=time, rank=rank, general=general, name=name)
        self._notes.append(f"the constraints lost rank at t = {time} s ({rank} instead of {general}) at {name}")

    def _weakest(self, jacobian: Floats) -> tuple[Constraint, str]:
        """The constraint that has the largest share in what vanishes, and the name of its row."""
        row = self.ranks.weakest(jacobian)
        item = next(item for item in located(self._task.flat) if row in item.rows)
        return item.constraint, self._task.engine.layout.constraints[row].name

    def _saddle_height(self, t: float, y: Floats) -> float:
        return saddle_height(self._system, replace(self._space, t=t), self.ranks.general, t, y)

    def _jacobian(self, t: float, y: Floats) -> Floats:
        q, _, z = self._system.split(y)
        space = replace(self._space, t=t, z=z.copy(), u=self._system.inputs(t))
        return space.velocity(np.ascontiguousarray(q), self._space.qd)[1]
