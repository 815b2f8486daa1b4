"""Collects the rows of a trajectory."""

from __future__ import annotations

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_display import Display, display, display_rate
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.engine import Engine, SingularSystem
from lagdsl.simulate.moved import MovedRow
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.trajectory import Column, Event, InvariantRecord, Kind, Statistics, Trajectory

# Rows at once: a Jacobian of each is in memory.
_AT_ONCE = 128


class Recorder:
    """Takes states at the requested times, computes outputs, energy and residuals there."""

    def __init__(self, flat: FlatModel, engine: Engine, system: RightHandSide, projection: Projection) -> None:
        self._flat = flat
        self._engine = engine
        self._system = system
        self._projection = projection
        self._variables = [index for index, kind in enumerate(engine.layout.kinds) if kind == "variable"]
        self._rows: list[Floats] = []
        self._residuals: list[tuple[float, float]] = []
        self._energies: list[float] = []

    def add(self, t: float, y: Floats) -> None:
        """One row. Outputs that are not numbers are kept as they are."""
        q, qd, z = (np.ascontiguousarray(part) for part in self._system.split(y))
        u, w, p = self._system.inputs(t), self._system.w, self._system.p
        outputs = np.zeros(0)
        if self._engine.layout.outputs:
            solved = self._system.solved(t, y)
            if solved is None:
                outputs = np.full(len(self._engine.layout.outputs), np.nan)
            else:
                arguments = (t, q, qd, z, u, w, p, solved.qdd, solved.lam)
                outputs = self._engine.evaluate("output", *arguments)[0]
        self._rows.append(np.concatenate([[t], q, qd, z, w[self._variables], outputs]))
        self._residuals.append(self._projection.residuals(t, y))
        self._energies.append(float(self._engine.evaluate("energies", t, q, qd, z, u, w, p)[0]))

    def add_many(self, engine: CEngine, times: Floats, states: Floats, discretes: Floats) -> None:
        """Rows of states that are on the constraints, each with its discretes, in few calls of C."""
        now = self._system.w
        for first in range(0, len(times), _AT_ONCE):
            part = slice(first, first + _AT_ONCE)
            try:
                self._add_part(engine, times[part], states[part], discretes[part])
            except SingularSystem:  # outputs that are not numbers stay with their row
                for t, y, w in zip(times[part].tolist(), states[part], discretes[part], strict=True):
                    self._system.with_discretes(w)
                    self.add(t, y)
        self._system.with_discretes(now)

    def _add_part(self, engine: CEngine, times: Floats, states: Floats, w: Floats) -> None:
        n = self._system.n
        at = times[:1] if self._system.signals.constant else times
        u = np.array([self._system.inputs(t) for t in at.tolist()])
        p = self._system.p
        state = (times, states[:, :n], states[:, n : 2 * n], states[:, 2 * n :], u, w, p)
        outputs = np.zeros((len(times), 0))
        if engine.layout.outputs:
            (outputs,) = engine.evaluate_many("output", *state, *engine.solve_many(*state))
        residuals = np.zeros((2, len(times)))
        if self._projection.active:
            for index, function in enumerate(("position_constraint", "velocity_constraint")):
                residuals[index] = np.max(np.abs(engine.evaluate_many(function, *state)[0]), axis=1, initial=0.0)
        self._rows += list(np.hstack([times[:, None], states, w[:, self._variables], outputs]))
        self._residuals += [(q, v) for q, v in residuals.T.tolist()]
        self._energies += engine.evaluate_many("energies", *state)[0].tolist()

    def trajectory(
        self,
        invariants: tuple[InvariantRecord, ...],
        moved: tuple[MovedRow, ...],
        statistics: Statistics,
        events: tuple[Event, ...],
    ) -> Trajectory:
        """All rows so far."""
        heads = _heads(self._flat, self._engine)
        table = np.array(self._rows).reshape(len(self._rows), len(heads))
        _unwind(self._flat, table)
        residuals = np.array(self._residuals).reshape(len(self._rows), 2)
        return Trajectory(
            model=self._flat.name,
            columns=tuple(
                Column(name=name, unit=unit, kind=kind, display=shown, values=table[:, index].copy())
                for index, (name, unit, kind, shown) in enumerate(heads)
            ),
            position_residual=residuals[:, 0].copy(),
            velocity_residual=residuals[:, 1].copy(),
            energy=np.array(self._energies),
            invariants=invariants,
            moved=moved,
            statistics=statistics,
            events=events,
        )


def _unwind(flat: FlatModel, table: Floats) -> None:
    """Make columns of angles that are known up to whole turns continuous; the first value stays."""
    first = table.shape[1] - len(flat.outputs)
    for index, output in enumerate(flat.outputs, start=first):
        if output.turning:
            known = np.isfinite(table[:, index])
            table[known, index] = np.unwrap(table[known, index])


def _heads(flat: FlatModel, engine: Engine) -> list[tuple[str, str, Kind, Display]]:
    """Names, units and kinds of the columns, in the order of result files."""
    heads: list[tuple[str, str, Kind, Display]] = [("time", "s", "time", Display("s"))]
    heads += [(c.name, c.unit, "coordinate", display(c)) for c in flat.coordinates]
    for c in flat.coordinates:
        unit = "1/s" if c.unit == "1" else f"{c.unit}/s"
        heads.append((f"der({c.name})", unit, "rate", display_rate(c)))
    heads += [(s.name, s.unit, "state", display(s)) for s in flat.states]
    heads += [(d.name, d.unit, "discrete", display(d)) for d in flat.events.discretes]
    heads += [(o.name, o.unit, "output", display(o)) for o in flat.outputs]
    return heads
