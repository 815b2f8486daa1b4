"""The multipliers that are eliminated, and the rows that give M the inertia that it lacks."""

import numpy as np
import pytest
from elimination_models import flat_model

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.derivation.mechanics.solve import solve
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure import redundant_multipliers
from lagdsl.derivation.structure.points import probes
from lagdsl.derivation.structure.structure import Structure, analyze, constraint_space
from lagdsl.foundation.diagnostics import Sink

FOUR_BARS = """model FourBars
  structural parameter Integer N = {n};
  parameter Length l1 = 0.4 m, l2 = 1 m, l3 = {rocker} m, d = {base} m;
  coordinate Angle a[N](each start = 60 deg), b[N](each start = {b} deg), c[N](each start = {c} deg);
  frame crank[N], coupler[N], rocker[N];
  gravity = -g_n*world.y;
  for i in 1:N loop
    frame crank[i] = (if i == 1 then world else coupler[i-1]).rotz(a[i]);
    frame coupler[i] = crank[i].move({{l1, 0}}).rotz(b[i]);
    frame rocker[i] = (if i == 1 then world else coupler[i-1]).move({{d, 0}}).rotz(c[i]);
    body bar1(m = 1 kg, com = {{l1/2, 0}}, Izz = 0.02 kg.m2) on crank[i];
    {coupler}
    body bar3(m = 1.5 kg, com = {{l3/2, 0}}, Izz = 0.1 kg.m2) on rocker[i];
    constraint l1*cos(a[i]) + l2*cos(a[i] + b[i]) = d + l3*cos(c[i]);
    constraint l1*sin(a[i]) + l2*sin(a[i] + b[i]) = l3*sin(c[i]);
  end for;
end FourBars;
"""
COUPLER = "body bar2(m = 2 kg, com = {{l2/2, 0}}, Izz = 0.2 kg.m2) on coupler[i];"
GENERAL = {"rocker": 0.8, "base": 1, "b": -33.38, "c": 83.25}
PARALLEL = {"rocker": 0.4, "base": 1, "b": -60, "c": 60}

TUMBLING = """model Tumbling
  coordinate Real e[4](start = {1, 0, 0, 0});
  coordinate Length x[3];
  constraint e[1]^2 + e[2]^2 + e[3]^2 + e[4]^2 = 1;
  frame B = world.move({x[1], x[2], x[3]}).quat(e);
  body top(m = 2 kg, com = {0 m, 0 m, 0.1 m}, I = {0.02 kg.m2, 0.03 kg.m2, 0.01 kg.m2}) on B;
  gravity = -g_n*world.z;
  {more}
end Tumbling;
"""


def compiled(text: str) -> tuple[Program, Structure]:
    flat = flat_model(text)
    sink = Sink()
    equations = form_equations(flat)
    program = arrange(equations, dense=True)
    structure = analyze(flat, constraint_space(flat, program), sink)
    assert not sink.has_errors, sink.diagnostics
    return solve(equations, program, structure), structure


def four_bars(n: int, *, coupler: str = COUPLER, rows: str = "", **sizes: float) -> str:
    text = FOUR_BARS.replace("  end for;\nend FourBars", f"{rows}  end for;\nend FourBars")
    return text.format(n=n, coupler=coupler.format(), **sizes)


def results(program: Program, function: str, symbols: dict[Group, object]) -> list[np.ndarray]:
    blocks = program.function(function).results
    values = evaluate(program.graph, [node for block in blocks for node in block.elements], symbols)
    found = []
    for block in blocks:
        taken, values = values[: len(block.elements)], values[len(block.elements) :]
        found.append(np.array([float(x) for x in taken]).reshape(block.shape))
    return found


def symbols_at(structure: Structure, q: np.ndarray, qd: np.ndarray) -> dict[Group, object]:
    return {
        Group.TIME: 0.3,
        Group.Q: q.tolist(),
        Group.QD: qd.tolist(),
        Group.Z: [],
        Group.U: [],
        Group.W: [],
        Group.P: structure.space.p.tolist(),
    }


def worst_residual(text: str) -> tuple[float, float]:
    """What accelerations and multipliers leave in the equations, relative to the terms, and the least pivot; worst of
    some states on the constraints. Multipliers are compared with those of least length."""
    program, structure = compiled(text)
    assert program.kept_rows == ()
    space = structure.space
    worst, least = 0.0, 1.0
    rng = np.random.default_rng(3)
    for point in probes(flat_model(text), space, space.position_rows, wanted=10, tries=40, seed=11):
        n = len(point.q)
        rows, gaps = (
            results(program, "velocity_constraint", symbols_at(structure, point.q, np.zeros(n)))[k] for k in (1, 0)
        )
        rates = rng.normal(size=n)
        rates -= np.linalg.pinv(rows, rcond=1e-9) @ (rows @ rates + gaps)
        symbols = symbols_at(structure, point.q, rates)
        mass, force, jacobian, gamma = results(program, "dynamics", symbols)
        a, lam, *_, pivot = results(program, "elimination", symbols)
        size = np.max(np.abs(mass) @ np.abs(a) + np.abs(jacobian.T) @ np.abs(lam) + np.abs(force))
        rest = np.max(np.abs(mass @ a - jacobian.T @ lam - force)) / size
        left = np.max(np.abs(jacobian @ a - gamma)) / np.max(np.abs(jacobian) @ np.abs(a) + np.abs(gamma))
        shortest = np.linalg.pinv(jacobian.T, rcond=1e-9) @ (mass @ a - force)
        excess = np.max(np.abs(lam - shortest)) * np.max(np.abs(jacobian)) / size
        worst = max(worst, float(rest), float(left), float(excess))
        least = min(least, float(pivot))
    return worst, least


@pytest.mark.parametrize("n", [1, 3])
def test_loops_leave_nothing_to_run_time(n: int) -> None:
    text = four_bars(n, **GENERAL)
    program, _ = compiled(text)
    assert program.has("elimination")
    worst, pivot = worst_residual(text)
    assert worst < 1e-12
    assert pivot > 1e-3


@pytest.mark.no_cover
def test_cost_of_a_chain_of_loops_is_proportional_to_its_length() -> None:
    costs = {n: _flops(four_bars(n, **GENERAL)) for n in (5, 10, 20)}
    assert costs[20] - costs[10] == 2 * (costs[10] - costs[5])
    assert costs[20] < 20 * 400


def _flops(text: str) -> int:
    from lagdsl.algebra.eliminate.count import flops

    program, _ = compiled(text)
    return flops(program.graph, [node for block in program.function("elimination").results for node in block.elements])


def test_rows_that_follow_from_others_share_their_multipliers() -> None:
    """A third bar parallel to the cranks: of all multipliers that do the same, the shortest."""
    more = """
    constraint l1*cos(a[i]) + 0.5*l2*cos(a[i] + b[i]) = 0.5*d + l1*cos(c[i]);
    constraint l1*sin(a[i]) + 0.5*l2*sin(a[i] + b[i]) = l1*sin(c[i]);
"""
    text = four_bars(2, rows=more, **PARALLEL)
    program, structure = compiled(text)
    assert sum(structure.redundant) == 4
    assert program.kept_rows == ()
    worst, pivot = worst_residual(text)
    assert worst < 1e-11
    assert pivot > 1e-3
    beside = structure.space.q + np.linspace(0.0, 0.1, len(structure.space.q))
    assert results(program, "elimination", symbols_at(structure, beside, 0.0 * beside))[-1] == 0.0


def test_massless_member_of_a_loop() -> None:
    text = four_bars(3, coupler="", **GENERAL)
    worst, pivot = worst_residual(text)
    assert worst < 1e-12
    assert pivot > 1e-4


@pytest.mark.parametrize(
    "more", ["", "constraint x[1] + 0.3*e[2] = 0.1*time;", "constraint der(x[1]) = e[2]*der(x[2]);"]
)
def test_quaternion_gets_its_inertia_from_its_length(more: str) -> None:
    text = TUMBLING.replace("{more}", more.replace("0.3*e", "(0.3 m)*e").replace("0.1*time", "(0.1 m/s)*time"))
    program, _ = compiled(text)
    assert program.has("elimination")
    worst, pivot = worst_residual(text)
    assert worst < 1e-12
    assert pivot > 1e-2


def test_loops_with_weak_multipliers_are_left_to_run_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """All loops are taken for weak: rows that follow from those left are left with them."""
    monkeypatch.setattr(redundant_multipliers, "_WELL_CONDITIONED", np.inf)
    more = "    constraint l1*cos(a[i]) + 0.5*l2*cos(a[i] + b[i]) = 0.5*d + l1*cos(c[i]);\n"
    program, structure = compiled(four_bars(2, rows=more, **PARALLEL))
    assert program.kept_rows == (0, 1, 2, 3, 4, 5)
    symbols = symbols_at(structure, structure.space.q, np.zeros(6))
    mass, force, jacobian, gamma = results(program, "dynamics", symbols)
    a, lam, response, lam_response, rows, bias, pivot = results(program, "elimination", symbols)
    assert pivot > 1e-3
    np.testing.assert_array_equal(lam, 0.0)
    np.testing.assert_array_equal(lam_response, 0.0)
    np.testing.assert_array_equal(rows, jacobian)
    np.testing.assert_array_equal(bias, gamma)
    np.testing.assert_allclose(mass @ a, force, atol=1e-12)
    np.testing.assert_allclose(mass @ response.T, jacobian.T, atol=1e-12)
