"""Islands move one after the other, each with its own steps and its own instants."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from time import perf_counter

import numpy as np

from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.run import Run, run_of
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.simulate.islands.pieces import Piece
from lagdsl.motion.simulate.stepping import Stepping


@record(kw_only=True)
class IslandResult:
    """A run of an island to its end. `rows`, `notes`, `ends`, `turns` and `drifts` are as RunResults has them, for the
    numbers of the island; `doubted` and `changes` as RunView does."""

    rows: Floats
    notes: Sequence[tuple[float, str, int]]
    ends: Floats
    turns: Sequence[float]
    drifts: Floats
    doubted: Sequence[float]
    changes: Sequence[tuple[float, bool]]
    is_implicit: bool
    steps: int
    evaluations: int
    jacobians: int
    projections: int


class Runs:
    """The runs of all `pieces` of a motion; inputs may jump at `breaks`, each run takes at most `most` steps. Without
    `extremes` nobody looks between rows."""

    def __init__(self, pieces: Sequence[Piece], breaks: Sequence[float], most: int, *, extremes: bool) -> None:
        self._pieces, self._breaks, self._most, self._extremes = pieces, breaks, most, extremes

    def results(self, told: Callable[[float], None] | None) -> list[IslandResult] | None:
        """Of all islands; None where one of them ends early, loses rank at its start or has an output that is no
        number: the motion of the whole model tells about that. `told` is told of the part that is done."""
        found: list[IslandResult] = []
        known: dict[tuple[object, ...], IslandResult] = {}
        spent = 0.0
        for number, piece in enumerate(self._pieces):
            begun = perf_counter()
            result = known.get(piece.kind) or self._result(piece)
            if result is None:
                return None
            known[piece.kind] = result
            found.append(result)
            spent += perf_counter() - begun
            if isinstance(piece.engine, AutoEngine):
                piece.engine.worked(0.0, left=spent / len(found) * (len(self._pieces) - len(found)))
            if told is not None:
                told((number + 1) / len(self._pieces))
        return found

    def again(self, number: int, times: Floats) -> Floats:
        """Rows of the island of this number, also at `times`. Its motion is the same to the bit: rows are read from
        the steps, which do not depend on them."""
        piece = self._pieces[number]
        settings = replace(piece.settings, times=times, invariant_tolerance=None)
        result = self._result(replace(piece, settings=settings))
        assert result is not None, "internal error: an island moves otherwise when it moves again"
        return result.rows

    def _result(self, piece: Piece) -> IslandResult | None:
        settings = piece.settings
        first, last = float(settings.times[0]), float(settings.times[-1])
        layout = piece.engine.layout
        relations, outputs = len(layout.instants.strict), len(layout.outputs)
        run = run_of(piece.engine.native, layout, settings, piece.engine.along)
        if not self._extremes:
            run.results.leave_out_extremes()
        run.know(first, piece.row_sizes, piece.dependent)
        stepping = Stepping(piece.engine, run, (first, last), self._most)
        status = run.begin(first, piece.x)
        rank, general, _ = run.rank() if any(layout.position_level) else (0, 0, 0)
        status = stepping.over(self._breaks) if status is Status.OK else status
        status = stepping.to(last) if status is Status.OK else status
        status = run.end() if status is Status.OK else status
        result = _result(run, relations, stepping.steps) if status is Status.OK and rank >= general else None
        run.leave()
        known = result is not None and (outputs == 0 or np.isfinite(result.rows[:, -3 - outputs : -3]).all())
        return result if known else None


def _result(run: Run, relations: int, steps: int) -> IslandResult:
    report, results = run.report, run.results
    return IslandResult(
        rows=results.rows(),
        notes=results.notes,
        ends=results.extremes(),
        turns=results.turns(run.size),
        drifts=results.drifts.copy(),
        doubted=run.doubted(relations),
        changes=run.changes() if report.changes else (),
        is_implicit=bool(report.implicit),
        steps=steps,
        evaluations=report.counts.evaluations,
        jacobians=report.counts.jacobians,
        projections=report.projections,
    )
