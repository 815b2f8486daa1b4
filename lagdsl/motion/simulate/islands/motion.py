"""A motion of islands: each moves by itself, and the trajectory is that of all."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.signals.trajectory import Statistics, Trajectory
from lagdsl.motion.simulate.islands.merged import Checks, Chosen, MergedRows, merged_notes
from lagdsl.motion.simulate.islands.pieces import Piece, Places, pieces_of
from lagdsl.motion.simulate.islands.runs import IslandResult, Runs
from lagdsl.motion.simulate.motion import Task, change_notes, tell_doubted, tell_rounded, tell_warnings
from lagdsl.motion.simulate.resolution import Resolution, hidden
from lagdsl.motion.simulate.table import Recorded, heads_of, places_of_columns, trajectory


def motion_of_islands(task: Task) -> tuple[Trajectory, list[float]] | None:
    """The motion, and how often every number of the state turns around. None where everything moves together, or where
    an island ends early: the motion of the whole model tells why, and when.

    A controller, and a function of Python that tells an input, see the whole model; so do derivatives of the motion.
    """
    asked = task.asked
    if asked.controls is not None or asked.tangents:
        return None
    pieces = pieces_of(asked.engine, task.run, task.initial)
    if not pieces:
        return None
    breaks = [b for b in asked.signals.breaks if b > float(task.times[0])]
    runs = Runs(pieces, breaks, asked.max_steps, extremes=asked.extremes)
    results = runs.results(task.progress)
    return None if results is None else _Joined(task, pieces, results, runs).found()


class _Joined:
    """The results of all islands as one motion."""

    def __init__(self, task: Task, pieces: Sequence[Piece], results: Sequence[IslandResult], runs: Runs) -> None:
        self._task, self._layout, self._runs = task, task.asked.engine.layout, runs
        self._places = Places(self._layout)
        self._results, self._islands = results, [piece.island for piece in pieces]
        self._columns = [self._places.of_columns(island) for island in self._islands]

    def found(self) -> tuple[Trajectory, list[float]]:
        task, asked = self._task, self._task.asked
        turns = self._turns()
        recorded, statistics = self._recorded(), self._statistics(turns)
        found = trajectory(asked.flat, self._layout, recorded, task.initial.moved, statistics, task.finer)
        tell_rounded(asked.flat, found, task.sink)
        tell_doubted(asked.flat, self._doubted(), task.sink)
        tell_warnings(asked.flat, found, task.sink)
        return found, turns

    def _recorded(self) -> Recorded:
        flat, layout = self._task.asked.flat, self._layout
        rows = MergedRows(self._columns, self._results, self._runs.again)
        places = places_of_columns(flat)
        ends = np.array([[np.inf], [-np.inf]]) * np.ones(self._places.width)
        drifts = np.zeros((3, len(layout.invariants)))
        for island, columns, result in zip(self._islands, self._columns, self._results, strict=True):
            ends[:, columns] = result.ends
            drifts[:, island.places["ni"]] = result.drifts
        return Recorded(
            columns=Chosen(rows, places),
            ends=ends[:, [place - 1 for place in places[1:]]],
            checks=Checks(rows),
            notes=merged_notes(layout, self._islands, self._results),
            drifts=drifts,
            limits=self._task.run.settings.invariant_tolerance,
        )

    def _turns(self) -> list[float]:
        turns = np.zeros(self._places.size)
        for columns, result in zip(self._columns, self._results, strict=True):
            turns[columns[: len(result.turns)]] = result.turns  # those of the state come first
        found: list[float] = turns.tolist()
        return found

    def _doubted(self) -> list[float]:
        """The first time at which each relation turned by what may be the error of the method, or infinity."""
        times: Floats = np.full(len(self._layout.instants.strict), np.inf)
        for island, result in zip(self._islands, self._results, strict=True):
            times[island.places["nindicator"]] = result.doubted
        found: list[float] = times.tolist()
        return found

    def _statistics(self, turns: Sequence[float]) -> Statistics:
        """Sums over the islands."""
        task, results = self._task, self._results
        changes = sorted(change for result in results for change in result.changes)
        heads, last = heads_of(task.asked.flat), float(task.times[-1])
        automatic = "radau" if any(result.is_implicit for result in results) else "dop853"
        return Statistics(
            solver=automatic if task.asked.solver == "auto" else task.asked.solver,
            steps=sum(result.steps for result in results),
            evaluations=sum(result.evaluations for result in results),
            jacobians=sum(result.jacobians for result in results),
            projections=sum(result.projections for result in results),
            notes=(*change_notes(changes), *hidden(Resolution(turns), heads, task.times, last)),
        )
