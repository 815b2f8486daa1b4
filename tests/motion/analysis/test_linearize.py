"""Matrices on the minimal state against minimal coordinates, closed forms and high precision."""

from __future__ import annotations

from pathlib import Path

import mpmath
import numpy as np
import pytest
from choice import chosen

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of

MODELS = Path(__file__).parents[3] / "models"

MINIMAL = """model Minimal
  parameter Mass m = 0.7 kg;
  parameter Length l = 0.8 m;
  input Force f;
  coordinate Angle theta(start = 0.4 rad);
  point P = l*{sin(theta), -cos(theta)};
  gravity = -g_n*world.y;
  mass m at P;
  force f*world.x at P;
  dissipation 1/2*(0.3 N.m.s/rad)*der(theta)^2;
  output Length height = P*world.y;
  output Acceleration across = der(der(P))*world.x;
end Minimal;
"""

CONSTRAINED = """model Constrained
  parameter Mass m = 0.7 kg;
  parameter Length l = 0.8 m;
  input Force f;
  coordinate Length x(start = l*sin(0.4)), y(start = -l*cos(0.4));
  point P = {x, y};
  gravity = -g_n*world.y;
  mass m at P;
  constraint rod: x^2 + y^2 = l^2;
  constraint again: norm({x, y}) = l;
  force f*world.x at P;
  dissipation 1/2*(0.3 N.m.s/rad)*((der(y)*x - der(x)*y)/l^2)^2;
  output Length height = P*world.y;
  output Acceleration across = der(der(P))*world.x;
end Constrained;
"""


def test_a_constrained_pendulum_is_the_minimal_one_in_other_coordinates() -> None:
    """Away from equilibrium, in motion, with a redundant row: x = l sin(theta) relates the states."""
    theta, rate, length, force = 0.4, 1.3, 0.8, 2.0
    minimal = lagdsl.compile(MINIMAL).linearize(q=[theta], qd=[rate], u=[force])
    x, y = length * np.sin(theta), -length * np.cos(theta)
    constrained = lagdsl.compile(CONSTRAINED).linearize(q=[x, y], qd=[-y * rate, x * rate], u=[force])
    assert [n.name for n in constrained.states] == ["x", "der(x)"]
    # x = l sin(theta): T maps (dtheta, dtheta') to (dx, dx'); F is the flow
    t = np.array([[-y, 0], [-x * rate, -y]])
    acceleration = minimal.rate[1]
    # d(dx)/dt = T A dtheta + dT/dt dtheta
    td = np.array([[-x * rate, 0], [-(x * acceleration - y * rate**2), -x * rate]])
    np.testing.assert_allclose(constrained.A @ t, t @ minimal.A + td, rtol=0, atol=1e-11)
    np.testing.assert_allclose(constrained.B, t @ minimal.B, atol=1e-12)
    np.testing.assert_allclose(constrained.C @ t, minimal.C, atol=1e-11)
    np.testing.assert_allclose(constrained.D, minimal.D, atol=1e-12)


def test_matrices_against_high_precision() -> None:
    """Derivatives of the pendulum's equation by mpmath at 40 digits."""
    m, length, g, c = 0.7, 0.8, 9.80665, 0.3
    found = lagdsl.compile(MINIMAL).linearize(q=[0.4], qd=[1.3], u=[2.0])

    def acceleration(theta: float, rate: float, force: float) -> mpmath.mpf:
        torque = force * length * mpmath.cos(theta) - m * g * length * mpmath.sin(theta) - c * rate
        return torque / (m * length**2)

    def across(theta: float, rate: float, force: float) -> mpmath.mpf:
        turned = mpmath.cos(theta) * acceleration(theta, rate, force) - mpmath.sin(theta) * rate**2
        return length * turned

    at = (0.4, 1.3, 2.0)
    with mpmath.workdps(40):
        orders = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        a = [float(mpmath.diff(acceleration, at, order)) for order in orders]
        y = [float(mpmath.diff(across, at, order)) for order in orders]
    np.testing.assert_allclose(found.A, [[0, 1], a[:2]], rtol=1e-13)
    np.testing.assert_allclose(found.B, [[0], [a[2]]], rtol=1e-13)
    np.testing.assert_allclose(found.C, [[length * np.sin(0.4), 0], y[:2]], rtol=1e-13)
    np.testing.assert_allclose(found.D, [[0], [y[2]]], rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize(
    "name", ["four_bar_angles", "centrifugal_governor", "sliding_ladder", "bicycle", "quarter_car"]
)
def test_unconstrained_flow_agrees_with_the_state_jacobian(name: str) -> None:
    """A is the Jacobian of qdd and zd along directions that keep the constraints."""
    model = lagdsl.compile(MODELS / f"{name}.lag")
    found = model.linearize()
    point = found.point
    whole = model.state_jacobian(point.t, point.q, point.qd, point.z, point.u, p=point.p)
    names = [*model.coordinates, *(f"der({c})" for c in model.coordinates), *model.states]
    rows = [names.index(n.name) for n in found.states]
    if not model.constraints:
        np.testing.assert_allclose(found.A, whole[np.ix_(rows, rows)], atol=1e-12)
        return
    # any direction of the minimal state continues uniquely onto the constraints: J dq = 0, d(J qd + b) = 0
    step = 1e-6
    for column, name_of in enumerate(found.states):
        moved = []
        for sign in (1.0, -1.0):
            shifted = [
                dict(zip(names, [*point.q, *point.qd, *point.z], strict=True))[n.name]
                + sign * step * (n.name == name_of.name)
                for n in found.states
            ]
            moved.append(_flow(model, found, names, shifted))
        difference = (moved[0] - moved[1]) / (2 * step)
        size = max(1.0, float(np.max(np.abs(found.A))))
        np.testing.assert_allclose(found.A[:, column], difference, atol=2e-7 * size)


def _flow(model: lagdsl.Model, found, names: list[str], independent: list[float]) -> np.ndarray:  # type: ignore[no-untyped-def]
    """Rates of the minimal state where its entries have these values: dependent ones by Newton's method."""
    point, n = found.point, len(model.coordinates)
    q, qd, z = point.q.copy(), point.qd.copy(), point.z.copy()
    picked = [names.index(s.name) for s in found.states]
    for i, value in zip(picked, independent, strict=True):
        if i < n:
            q[i] = value
        elif i < 2 * n:
            qd[i - n] = value
        else:
            z[i - 2 * n] = value
    rest = [j for j in range(n) if j not in picked]
    slow = [j for j in range(n) if n + j not in picked]
    evaluate = model._engine.evaluate
    w = point.w
    rows = list(np.flatnonzero(model._layout.position_level))
    for _ in range(8 if rest else 0):
        phi, jacobian = evaluate("position_constraint", point.t, q, qd, z, point.u, w, point.p)
        q[rest] -= np.linalg.lstsq(jacobian[rows][:, rest], phi[rows], rcond=1e-10)[0]
    for _ in range(3 if slow else 0):
        drift, jacobian = evaluate("velocity_constraint", point.t, q, qd, z, point.u, w, point.p)
        qd[slow] -= np.linalg.lstsq(jacobian[:, slow], drift, rcond=1e-10)[0]
    qdd = model.forward_dynamics(point.t, q, qd, z, point.u, p=point.p)
    zd = evaluate("state_derivative", point.t, q, qd, z, point.u, w, point.p, qdd, np.zeros(len(model.constraints)))[0]
    return np.concatenate([qd, qdd, zd])[picked]


NONHOLONOMIC = {"bicycle": {"phi": 0.1, "delta": 0.05}, "rolling_coin": {"lean": 0.3, "psi": 0.2}}


@pytest.mark.no_cover
@pytest.mark.parametrize("name", chosen(NONHOLONOMIC, ["rolling_coin"]))
def test_engines_and_derivations_agree(name: str) -> None:
    text, q = (MODELS / f"{name}.lag").read_text(), NONHOLONOMIC[name]
    # The turn of one wheel follows from that of the other where the fork is turned.
    text = text.replace("front(der(start = v/rF))", "front")
    model = lagdsl.compile(text)
    one = model.linearize(q=q)
    by_text = lagdsl.compile(text, derivation="textbook").linearize(q=q)
    np.testing.assert_allclose(by_text.A, one.A, atol=1e-9 * float(np.max(np.abs(one.A))))
    other = lagdsl.Model(model._compilation, engine_of(model._compilation.program, "c"))
    np.testing.assert_allclose(other.linearize(q=q).A, one.A, atol=1e-9)


def test_a_moving_constraint_and_its_input() -> None:
    """A pendulum whose pivot is moved by an input: its rate and acceleration are inputs, too."""
    text = """model Moved
      parameter Length l = 2 m;
      input Length s(smooth = 2);
      coordinate Length x(start = l), y;
      coordinate Length p;
      gravity = -g_n*world.y;
      mass 1 kg at {x, y};
      mass 1 kg at {p, 0};
      constraint pivot: p = s;
      constraint rod: (x - p)^2 + y^2 = l^2;
      output Length reach = x;
    end Moved;
    """
    found = lagdsl.compile(text).linearize(q={"x": 0.0, "y": -2.0, "p": 0.0})
    assert [n.name for n in found.inputs] == ["s", "der(s)", "der(der(s))"]
    assert [n.name for n in found.states] == ["x", "der(x)"]
    # x'' = -(g/l) (x - s)
    g = 9.80665 / 2
    np.testing.assert_allclose(found.A, [[0, 1], [-g, 0]], atol=1e-13)
    np.testing.assert_allclose(found.B, [[0, 0, 0], [g, 0, 0]], atol=1e-13)
    np.testing.assert_allclose(found.C, [[1, 0]])


def test_e0850_at_a_stretched_parallelogram() -> None:
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(MODELS / "parallelogram.lag").linearize()
    assert [d.code for d in failure.value.diagnostics] == ["E0850"]


def test_e0851_where_euler_angles_fall_together() -> None:
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(MODELS / "heavy_top.lag").linearize(q={"theta": 0.0})
    assert [d.code for d in failure.value.diagnostics] == ["E0851"]


def test_e0855_at_a_kink() -> None:
    text = """model Kink
      coordinate Length x;
      gravity = 0;
      mass 1 kg at {x, 0};
      force -(2 N/m^0.5)*sqrt(x) on x;
      output Real r = sqrt(x/(1 m));
    end Kink;
    """.replace("(2 N/m^0.5)*sqrt(x)", "(2 N)*sqrt(x/(1 m))")
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(text).linearize()
    assert [d.code for d in failure.value.diagnostics] == ["E0855"]
    assert "der(x)" in failure.value.diagnostics[0].message


def test_an_output_without_a_derivative_is_no_matter_of_small_motions() -> None:
    """The norm of a zero vector: the oscillator has modes and a stable equilibrium, its output no row of C."""
    text = """model Kink
      coordinate Length x;
      coordinate Length y;
      gravity = 0;
      mass 1 kg at {x, y};
      potential 1/2*(4 N/m)*x^2 + 1/2*(9 N/m)*y^2;
      output Length r = sqrt(x^2 + y^2);
    end Kink;
    """
    model = lagdsl.compile(text)
    modes = model.modes()
    assert 2.0 * np.pi * modes.frequencies == pytest.approx([2.0, 2.0, 3.0, 3.0], rel=1e-12)
    assert model.trim().steadiness.kind == "equilibrium"
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        model.linearize()
    assert [d.code for d in failure.value.diagnostics] == ["E0855"]
    assert "output `r`" in failure.value.diagnostics[0].message


def test_arguments_that_do_not_fit() -> None:
    model = lagdsl.compile(MINIMAL)
    with pytest.raises(ValueError, match="q must have 1 entries"):
        model.linearize(q=[1.0, 2.0])
    with pytest.raises(KeyError, match="thta"):
        model.modes(q={"thta": 1.0})


def test_forty_links_take_a_moment() -> None:
    from time import process_time

    model = lagdsl.compile(MODELS / "chain.lag", structural={"N": 40})
    began = process_time()
    found = model.modes(q=np.zeros(40))
    assert process_time() - began < 3.0
    # J0's zeros rule the continuous chain: omega_1 = 2.404825 / 2 sqrt(g/L)
    slowest = 2 * np.pi * found.frequencies[0]
    assert slowest == pytest.approx(2.404825557695773 / 2 * np.sqrt(9.80665 / 4), rel=0.02)
