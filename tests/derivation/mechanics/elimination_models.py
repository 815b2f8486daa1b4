"""Chains as model texts, and what their elimination gives against the dense system."""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.eliminate.rows import Rows
from lagdsl.algebra.eliminate.solve import Solution, solve
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.tape import Tape
from lagdsl.derivation.mechanics.constraints import constraint_jacobian, rows_of
from lagdsl.derivation.mechanics.equations import Equations, form_equations
from lagdsl.derivation.mechanics.lagrange.inertia import acceleration_form
from lagdsl.derivation.mechanics.lagrange.lagrange import forcing, mass_matrix
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file

PLANAR = """model Chain
  structural parameter Integer N = {n};
  coordinate Angle q[N];
  input Torque tau[N];
  frame F[N];
  gravity = -g_n*world.z;
  for i in 1:N loop
    frame F[i] = (if i == 1 then world else F[i-1].move({{0 m, 0 m, -1 m}})).roty(q[i]);
    body (m = 1 kg, com = {{0 m, 0 m, -0.5 m}}, I = {{0.084 kg.m2, 0.083 kg.m2, 0.001 kg.m2}}) on F[i];
    torque tau[i] on q[i];
  end for;
end Chain;
"""

SPATIAL = """model Chain
  structural parameter Integer N = {n};
  coordinate Angle q[N];
  input Torque tau[N];
  frame F[N];
  gravity = -g_n*world.z;
  for i in 1:N loop
    frame F[i] = (if i == 1 then world
        else F[i-1].move({{0.1 m, 0.3 m, 0.2 m}}).rotx(if mod(i, 2) == 0 then 90 deg else -90 deg)).rotz(q[i]);
    body (m = 1.5 kg, com = {{0.05 m, 0.1 m, 0.2 m}}, I = {{0.02 kg.m2, 0.03 kg.m2, 0.025 kg.m2, 0.001 kg.m2,
        0.002 kg.m2, 0.003 kg.m2}}) on F[i];
    torque tau[i] on q[i];
  end for;
end Chain;
"""

SCALARS = """model Chain
  structural parameter Integer N = {n};
  coordinate Angle q[N];
  Angle phi[N];
  Length x[N], y[N];
equation
  for i in 1:N loop
    phi[i] = (if i == 1 then 0 else phi[i-1]) + q[i];
    x[i] = (if i == 1 then 0 m else x[i-1]) + (0.3 m)*sin(phi[i]);
    y[i] = (if i == 1 then 0 m else y[i-1]) - (0.3 m)*cos(phi[i]);
    kinetic 0.5*(0.7 kg)*(der(x[i])^2 + der(y[i])^2) + 0.5*(0.02 kg.m2)*der(phi[i])^2;
    potential (0.7 kg)*g_n*y[i];
  end for;
end Chain;
"""


def flat_model(text: str) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("model.lag", text), sink)
    assert flat is not None, sink.diagnostics
    return flat


def eliminated(flat: FlatModel) -> tuple[Equations, Solution]:
    """Accelerations, and the responses to every row of the constraints."""
    equations = form_equations(flat)
    directions = equations.symbols.directions
    form = acceleration_form(equations.lowering, flat, equations.dynamics, directions)
    rows = rows_of(equations.lowering, equations.rows, directions)
    return equations, solve(form, directions.rates, Rows(kept=tuple(rows)))


def largest_residual(flat: FlatModel, states: int = 20) -> float:
    """Residual that the accelerations and responses leave in M a = f and M Y' = J', relative to the terms; worst."""
    equations, solution = eliminated(flat)
    graph, directions = equations.graph, equations.symbols.directions
    mass = mass_matrix(graph, equations.dynamics.terms, directions)
    jacobian = constraint_jacobian(graph, equations.rows, directions)
    columns = range(len(directions.rates))
    sides = [
        forcing(equations.lowering, equations.dynamics.terms),
        *([row.get(column, graph.zero) for column in columns] for row in jacobian),
    ]
    found = [response.accelerations for response in (solution.own, *solution.along)]
    roots = [node for rows in (mass, sides, found) for row in rows for node in row]
    values_at = Tape(graph, roots)
    rng = np.random.default_rng(1)
    n, worst = len(directions.rates), 0.0
    for _ in range(states):
        symbols = {
            group: list(rng.uniform(-1.5, 1.5, size))
            for group, size in (
                (Group.Q, n),
                (Group.QD, n),
                (Group.Z, len(flat.states)),
                (Group.U, len(flat.inputs)),
            )
        }
        symbols[Group.P] = [item.value for item in flat.parameters if not item.structural]
        values = values_at({**symbols, Group.TIME: 0.3})
        m, rows = values[: n * n].reshape(n, n), values[n * n :].reshape(2, len(sides), n)
        for side, x in zip(rows[0], rows[1], strict=True):
            size = np.abs(m) @ np.abs(x) + np.abs(side)
            worst = max(worst, float(np.max(np.abs(m @ x - side)) / max(size.max(), 1e-12)))
    return worst
