"""A consistent state to start from (language reference, section 5 and rulings 26 and 27)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from lagdsl.diagnostics import Severity, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats, rank
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.initial_equations import joint_state
from lagdsl.simulate.initial_positions import positions
from lagdsl.simulate.initial_problem import Problem, problem
from lagdsl.simulate.initial_ranks import redundant_rows
from lagdsl.simulate.initial_rates import rates
from lagdsl.simulate.moved import MovedRow, loops_of, moved_rows, moved_text, report_moved


@dataclass(frozen=True, slots=True, kw_only=True)
class InitialState:
    """q, qd (nq,) and z (nz,) at time t, SI units; `moved` tells which starts were changed, `freedom` counts the
    rates that the constraints leave free here, `loops` names the joints at which loops are cut, `redundant` flags the
    rows that depend on others near this state."""

    model: str
    t: float
    q: Floats
    qd: Floats
    z: Floats
    freedom: int
    moved: tuple[MovedRow, ...]
    redundant: tuple[bool, ...]
    loops: tuple[str, ...] = ()

    def __str__(self) -> str:
        return moved_text(self.model, self.freedom, self.moved, self.loops)


def initial_state(
    flat: FlatModel,
    engine: Engine,
    p: Floats | None = None,
    *,
    t0: float | None = None,
    u: Floats | None = None,
    start: Mapping[str, float] | None = None,
    sink: Sink | None = None,
) -> InitialState:
    """The state nearest to the starts that satisfies constraints, fixed values and initial equations.

    `p` are the independent parameters (default: the model's), `u` the inputs at the start, `start` further start
    values by name in SI units, also `der(theta)`. What is wrong or was moved is reported to `sink`; without one,
    errors raise CompilationFailed.
    """
    own = Sink() if sink is None else sink
    before = len(own.diagnostics)
    parameters = np.array(engine.layout.defaults, dtype=np.float64) if p is None else p
    task = problem(flat, engine, parameters, t0=t0, u=u, start=start or {}, sink=own)
    if not _finite(task, own):
        q, qd, z = task.space.q, task.space.qd, task.space.z
    elif flat.initial_equations:
        q, qd, z = joint_state(task, own)
    else:
        q = positions(task, own)
        qd, z = (task.space.qd if _wrong(own, before) else rates(task, q, own)), task.space.z
    redundant = engine.layout.redundant
    if not _wrong(own, before) and (start or not np.array_equal(parameters, engine.layout.defaults)):
        redundant = redundant_rows(task, q, own)
    if sink is None:
        own.raise_if_errors()
    rows = () if _wrong(own, before) else moved_rows(task, q, qd)
    if not flat.initial_equations:  # these say themselves that starts are to be moved
        report_moved(task, rows, own)
    return InitialState(
        model=flat.name,
        t=task.space.t,
        q=q,
        qd=qd,
        z=z,
        freedom=_freedom(task, q),
        moved=rows,
        redundant=redundant,
        loops=loops_of(flat),
    )


def _wrong(sink: Sink, before: int) -> bool:
    return any(d.severity is Severity.ERROR for d in sink.diagnostics[before:])


def _freedom(task: Problem, q: Floats) -> int:
    space = task.space
    jacobian = space.velocity(q, space.qd)[1] * space.sizes / space.row_sizes[:, None]
    return len(q) - (rank(jacobian) if np.all(np.isfinite(jacobian)) else 0)


def _finite(task: Problem, sink: Sink) -> bool:
    """E0816 for a start value or a constraint that is not a number at the start."""
    space = task.space
    named = [
        *zip(space.q.tolist(), (c.name for c in task.flat.coordinates), strict=True),
        *zip(space.qd.tolist(), (f"der({c.name})" for c in task.flat.coordinates), strict=True),
        *zip(space.z.tolist(), (s.name for s in task.flat.states), strict=True),
        *zip(space.u.tolist(), (i.name for i in task.flat.inputs), strict=True),
    ]
    wrong = [name for value, name in named if not np.isfinite(value)]
    if not wrong:
        residuals = np.abs(space.position(space.q)[0]) + np.abs(space.velocity(space.q, space.qd)[0])
        slots = space.functions.layout.constraints
        wrong = [slot.name for slot, value in zip(slots, residuals.tolist(), strict=True) if not np.isfinite(value)]
    for name in wrong:
        sink.report("E0816", None, name=name)
    return not wrong
