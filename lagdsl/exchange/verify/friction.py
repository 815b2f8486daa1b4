"""The line on dry friction: its law along the motion, with forces, slips and limits as the text says them.

With the force F along the slip g and the limits R and R_0: while it slides, F . g = -R |g| and |F| = R; while it
sticks, g = 0, F . g = 0 and |F| <= R_0. So its power F . g is never positive. Where rows share forces that the motion
does not determine, |F| <= R_0 holds for some of them (`lagdsl.motion.analysis.friction`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.states import coordinate_sizes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.events import Friction, entries
from lagdsl.language.flat.listing import forces_of
from lagdsl.language.flat.model import FlatModel, Output
from lagdsl.motion.analysis.friction import friction_forces, placed_frictions
from lagdsl.motion.analysis.point import Flow, Point, System
from lagdsl.motion.pipeline import Compilation, compile_flat
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.initialize import initial_state
from lagdsl.motion.simulate.simulate import simulate

# A part of the largest force and slip: rows between steps are as exact as the interpolation of the method.
_LAW = 1e-9


def friction(compilation: Compilation, interval: float, end: float | None = None) -> Iterator[Line]:
    """One line: the worst deviation from the law along the motion up to `end`, with its friction and time; nothing for
    a model without friction."""
    if not compilation.flat.events.frictions:
        return
    name, says = "friction", "its power is never positive; it slides with its limit, and sticks within it, without slip"
    made = compile_flat(_observed(compilation.flat), Sink())
    assert made is not None, "a model that compiles does so with other outputs"
    system = System(made.flat, made.program, engine_of(made.program, "tape"))
    try:
        rows = simulate(system.engine, made.flat, stop=end, interval=interval)
    except SimulationFailed as failure:
        yield Line(name=name, says=says, note=failure.diagnostics[0].message)
        return
    motion = _Motion(system, rows, initial_state(made.flat, system.engine).p)
    worst, note = 0.0, ""
    for index, each in enumerate(made.flat.events.frictions):
        for kind, parts in motion.deviations(index, each):
            row = int(np.argmax(parts))
            if parts[row] > worst:
                worst, note = float(parts[row]), f"largest in {each.name} at t = {rows.time[row]:.6g} s: {kind}"
    yield Line(name=name, says=says, figure=worst, limit=_LAW, note=note)


@record()
class _Motion:
    """Rows of a motion of a model with everything that the law is about as its outputs; p (np,)."""

    system: System
    rows: Trajectory
    p: Floats

    def deviations(self, index: int, friction: Friction) -> Iterator[tuple[str, Floats]]:
        """Of each kind, at each row: as parts of the largest force and the largest slip."""
        count = len(friction.slips)
        told = self._table("law", 2 * count + 3, index)
        slip, force = told[:, :count], told[:, count : 2 * count]
        limit, most, sticks = told[:, -3], told[:, -2], told[:, -1] != 0.0
        speed, size = np.linalg.norm(slip, axis=1), np.linalg.norm(force, axis=1)
        largest = float(np.max([limit, most, size])) or 1.0
        fastest = max(float(np.max(speed)), self._natural(index)) or 1.0
        power, lost = np.sum(force * slip, axis=1), np.where(sticks, 0.0, limit * speed)
        yield "slip while it sticks", np.where(sticks, speed, 0.0) / fastest
        yield "force off its limit while it slides", np.where(sticks, 0.0, np.abs(size - limit)) / largest
        yield "power that is not -R |slip|", np.abs(power + lost) / (largest * fastest)
        beyond = self._beyond(friction, sticks & (size > most), size - most)
        yield "force beyond its limit while it sticks", beyond / largest

    def _beyond(self, friction: Friction, asked: Flags, excess: Floats) -> Floats:
        """Excess of the forces over the limit at rest at the rows that are asked for; a shared one is that of the
        forces with the largest least reserve."""
        found = np.where(asked, excess, 0.0)
        for row in np.flatnonzero(asked).tolist():
            forces = friction_forces(self.system, self._flow(row))
            own = next(each for each in forces if each.name == friction.name)
            found[row] = own.size - own.limit if own.shared else found[row]
        return found

    def _natural(self, index: int) -> float:
        """The slip where coordinates move by their natural sizes in the time of the motion."""
        here, layout = self._flow(0), self.system.engine.layout
        sizes = coordinate_sizes(self.system.flat, self.system.program, self.p)
        jacobian = self.system.engine.evaluate("friction", *here.point.arguments, here.qdd, here.lam)[1]
        own = list(placed_frictions(self.system, here.point.w))[index].slips
        factor = layout.row_factor(layout.instants.friction_rows[own][0])
        slips = np.abs(jacobian[own]) @ sizes / factor
        return float(np.max(slips)) / (float(np.ptp(self.rows.time)) or 1.0)

    def _flow(self, row: int) -> Flow:
        """The solved motion at a row."""
        layout, flat = self.system.engine.layout, self.system.flat
        names = [item.name for item in flat.coordinates]
        point = Point(
            t=float(self.rows.time[row]),
            q=self._at(row, names),
            qd=self._at(row, [f"der({name})" for name in names]),
            z=self._at(row, [item.name for item in flat.states]),
            u=self._table("input", len(layout.inputs))[row],
            w=self._table("entry", len(layout.discretes))[row],
            p=self.p,
        )
        lam = self._table("multiplier", len(layout.constraints))[row]
        return Flow(point, self._table("acceleration", len(names))[row], lam, np.zeros(len(point.z)), np.zeros(0))

    def _at(self, row: int, names: list[str]) -> Floats:
        return np.array([self.rows[name][row] for name in names])

    def _table(self, kind: str, count: int, index: int = 0) -> Floats:
        """(rows, count): the outputs of one kind."""
        columns = [self.rows[_name(kind, index, k)] for k in range(count)]
        return np.stack(columns, axis=1) if columns else np.zeros((len(self.rows), 0))


def _name(kind: str, index: int, k: int) -> str:
    return f"{kind}[{index + 1},{k + 1}]"


def _observed(flat: FlatModel) -> FlatModel:
    """The model with other outputs: of each friction slips, forces, both limits and its mode; and all that the
    equations of motion read or give but for the state."""
    tables = {("law", index): _law(flat, each) for index, each in enumerate(flat.events.frictions)}
    tables["input", 0] = [fx.Variable(item.name) for item in flat.inputs]
    tables["entry", 0] = [fx.Variable(entry.name) for entry in entries(flat.events)]
    tables["multiplier", 0] = [fx.Multiplier(row) for each in flat.constraints for row in each.rows]
    tables["acceleration", 0] = [fx.Derivative(fx.Derivative(fx.Variable(item.name))) for item in flat.coordinates]
    outputs = [
        Output(name=_name(kind, index, k), dimension=DIMENSIONLESS, value=value, spans=())
        for (kind, index), values in tables.items()
        for k, value in enumerate(values)
    ]
    return replace(flat, outputs=tuple(outputs), invariants=())


def _law(flat: FlatModel, friction: Friction) -> list[fx.FlatExpression]:
    """Slips, forces, limits, the mode."""
    most = friction.limit if friction.sticking is None else friction.sticking
    return [*friction.slips, *forces_of(flat, friction), friction.limit, most, fx.Variable(friction.sticks)]
