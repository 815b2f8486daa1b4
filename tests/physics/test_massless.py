"""Forces determine the motion of what has no inertia: knots of springs, Maxwell elements, circuits without coils."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from choice import engines
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, root

import lagdsl

KNOT = """
model Knot
  parameter Stiffness k1 = 100 N/m, k2 = 300 N/m;
  parameter Mass m = 2 kg;
  coordinate Length x(start = 0.1 m), s;
  kinetic 1/2*m*der(x)^2;
  potential 1/2*k1*s^2 + 1/2*k2*(x - s)^2;
  output Force spring = k1*s;
  invariant E: energy();
end Knot;
"""
MAXWELL = """
model Maxwell
  coordinate Length x(start = 0.1 m), s(start = 0.1 m);
  kinetic 1/2*(2 kg)*der(x)^2;
  potential 1/2*(400 N/m)*s^2;
  dissipation 1/2*(7 N.s/m)*(der(x) - der(s))^2;
end Maxwell;
"""
DAMPERS = """
model Dampers
  coordinate Length x(der(start = 1 m/s)), s;
  kinetic 1/2*(2 kg)*der(x)^2;
  dissipation 1/2*(3 N.s/m)*(der(x) - der(s))^2 + 1/2*(6 N.s/m)*der(s)^2;
end Dampers;
"""
# Spring, damper, spring: the damper lies between two massless ends, and only their difference damps.
BETWEEN = """
model Between
  parameter Damping c = 5 N.s/m;
  coordinate Length x(start = 0.1 m), a, b;
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*(100 N/m)*a^2 + 1/2*(200 N/m)*(x - b)^2;
  dissipation 1/2*c*(der(a) - der(b))^2;
end Between;
"""
STIFFENING = """
model Stiffening
  coordinate Length x(start = 0.3 m), s;
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*(100 N/m)*s^2 + 1/4*(5000 N/m3)*s^4 + 1/2*(80 N/m)*(x - s)^2 + 1/4*(900 N/m3)*(x - s)^4;
  invariant E: energy();
end Stiffening;
"""
PLANE = """
model Plane "A mass hangs on a knot of three springs"
  coordinate Length x(start = 0.05 m), y(start = -0.3 m), u, v(start = 0.1 m);
  point K = {u, v, 0};
  mass 1 kg at {x, y, 0};
  gravity = -g_n*world.y;
  potential 1/2*(300 N/m)*(norm(K - {-0.4 m, 0.3 m, 0 m}) - 0.1 m)^2;
  potential 1/2*(200 N/m)*(norm(K - {0.5 m, 0.3 m, 0 m}) - 0.1 m)^2;
  potential 1/2*(400 N/m)*(norm(K - {x, y, 0}) - 0.2 m)^2;
  invariant E: energy();
end Plane;
"""
LADDER = """
model Ladder "Two stages of resistors and capacitors"
  import Lag.Electrical.*;
  VoltageSource battery(v = 5 V);
  Resistor R1(R = 1 kOhm), R2(R = 2 kOhm);
  Capacitor C1(C = 1 uF), C2(C = 3 uF);
  Ground ground;
  connect(battery.p, R1.p);
  connect(R1.n, C1.p, R2.p);
  connect(R2.n, C2.p);
  connect(C1.n, C2.n, battery.n, ground.p);
  output Voltage u1 = C1.p.v, u2 = C2.p.v;
end Ladder;
"""
MOTOR = """
model Motor "A motor without inductance on a flywheel"
  import Lag.Electrical.*;
  VoltageSource battery(v = 12 V);
  Resistor R(R = 1.2 Ohm);
  RotationalEMF emf(k = 0.05 N.m/A);
  Ground ground;
  Lag.Rotational.Rotor wheel(J = 3e-5 kg.m2);
  connect(battery.p, R.p);
  connect(R.n, emf.p);
  connect(battery.n, emf.n, ground.p);
  connect(emf.phi, wheel.phi);
  output Current i = emf.p.i;
end Motor;
"""


@cache
def compiled(text: str) -> lagdsl.Model:
    return lagdsl.compile(text)


def eigenvalues(text: str) -> list[complex]:
    return sorted(compiled(text).modes().eigenvalues.tolist(), key=lambda x: (round(x.real, 6), x.imag))


def test_two_springs_in_series_are_one() -> None:
    motion = compiled(KNOT).simulate(stop=3.0, tolerance=1e-10)
    series = 100.0 * 300.0 / 400.0
    x = 0.1 * np.cos(np.sqrt(series / 2.0) * motion["time"])
    assert np.allclose(motion["x"], x, atol=1e-9) and np.allclose(motion["s"], 0.75 * x, atol=1e-9)
    assert np.allclose(motion["spring"], series * x, atol=1e-6)
    assert np.ptp(motion.energy) < 1e-9 * motion.energy[0]
    assert np.allclose(np.abs(eigenvalues(KNOT)), np.sqrt(series / 2.0)), "a knot adds no state"


def test_a_maxwell_element_has_a_polynomial_of_third_order() -> None:
    """m x'' = -k s, k s = c (x' - s'): lambda^3 + k/c lambda^2 + k/m lambda."""
    roots = np.roots([1.0, 400.0 / 7.0, 200.0, 0.0])
    assert np.allclose(eigenvalues(MAXWELL), sorted(roots))
    matrix = np.array([[0.0, 0.0, 1.0], [0.0, -400.0 / 7.0, 1.0], [0.0, -200.0, 0.0]])
    motion = compiled(MAXWELL).simulate(stop=1.0, tolerance=1e-10)
    state = expm(matrix) @ [0.1, 0.1, 0.0]
    assert np.allclose([motion[name][-1] for name in ("x", "s", "der(x)")], state, atol=1e-10)
    assert np.allclose(compiled(MAXWELL).trim().point.q, [0.1, 0.0])


def test_two_dampers_in_series_are_one() -> None:
    motion = compiled(DAMPERS).simulate(stop=2.0, tolerance=1e-10)
    assert np.allclose(motion["der(x)"], np.exp(-motion["time"]), atol=1e-9)  # c = 3*6/(3 + 6)
    assert np.allclose(motion["s"], motion["x"] / 3.0, atol=1e-9)


def test_a_damper_between_two_springs() -> None:
    """The sum of both balances holds no rates, 100 a = 200 (x - b), and one of them does."""
    motion = compiled(BETWEEN).simulate(stop=1.0, tolerance=1e-10)
    # of x, der(x) and b: 5 (a' - b') = -100 a with a = 2 (x - b)
    matrix = np.array([[0.0, 1.0, 0.0], [-200.0, 0.0, 200.0], np.array([40.0, 2.0, -40.0]) / 3.0])
    state = expm(matrix) @ [motion[name][0] for name in ("x", "der(x)", "b")]
    assert np.allclose([motion[name][-1] for name in ("x", "der(x)", "b")], state, atol=1e-11)
    assert motion["x"][0] == 0.1 and np.allclose(motion["a"], 2.0 * (motion["x"] - motion["b"]), atol=1e-12)


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_stiffening_springs_in_series(engine: str) -> None:
    def middle(x: float) -> float:
        return float(brentq(lambda s: 100 * s + 5000 * s**3 - 80 * (x - s) - 900 * (x - s) ** 3, -1, 1, xtol=1e-14))

    def flow(_: float, y: np.ndarray) -> list[float]:
        stretch = y[0] - middle(y[0])
        return [y[1], -80 * stretch - 900 * stretch**3]

    reference = solve_ivp(flow, (0.0, 1.0), [0.3, 0.0], rtol=1e-9, atol=1e-11).y[:, -1]
    model = lagdsl.compile(STIFFENING, engine=engine)  # type: ignore[arg-type]
    motion = model.simulate(stop=1.0, tolerance=1e-9)
    assert np.allclose([motion["x"][-1], motion["der(x)"][-1]], reference, atol=1e-7)
    assert np.ptp(motion.energy) < 1e-8 * motion.energy[0]


def test_a_knot_of_three_springs_in_the_plane() -> None:
    model = compiled(PLANE)
    motion = model.simulate(stop=1.0, tolerance=1e-10)
    ends = np.array([[-0.4, 0.3], [0.5, 0.3]])

    def pull(at: np.ndarray, end: np.ndarray, stiffness: float, length: float) -> np.ndarray:
        way = end - at
        return stiffness * (1.0 - length / float(np.linalg.norm(way))) * way

    for row in range(0, len(motion["time"]), 50):
        mass = np.array([motion["x"][row], motion["y"][row]])

        def forces(at: np.ndarray, mass: np.ndarray = mass) -> np.ndarray:
            return pull(at, ends[0], 300, 0.1) + pull(at, ends[1], 200, 0.1) + pull(at, mass, 400, 0.2)

        knot = np.array([motion["u"][row], motion["v"][row]])
        assert np.allclose(root(forces, knot, tol=1e-13).x, knot, atol=1e-10)
    assert np.ptp(motion.energy) < 1e-8


def test_a_ladder_of_resistors_and_capacitors() -> None:
    model = compiled(LADDER)
    rates = np.array([[-1.5e-3, 0.5e-3], [0.5e-3, -0.5e-3]]) @ np.diag([1e6, 1e6 / 3.0])
    assert np.allclose(eigenvalues(LADDER), np.sort(np.linalg.eigvals(rates)))
    motion = model.simulate(stop=3e-3, tolerance=1e-10)
    final = np.array([5e-6, 15e-6])
    charges = final - expm(3e-3 * rates) @ final
    assert np.allclose([motion["C1.q"][-1], motion["C2.q"][-1]], charges, rtol=1e-8)
    assert np.allclose([motion["u1"][-1], motion["u2"][-1]], charges / [1e-6, 3e-6], rtol=1e-8)
    assert np.allclose(model.trim().point.q[3:5], final)


def test_a_motor_without_inductance() -> None:
    motion = compiled(MOTOR).simulate(stop=0.05, tolerance=1e-10)
    speed = 240.0 * (1.0 - np.exp(-(0.05**2) / (1.2 * 3e-5) * motion["time"]))
    assert np.allclose(motion["der(emf.phi)"], speed, atol=1e-6)
    assert np.allclose(motion["i"], (12.0 - 0.05 * speed) / 1.2, atol=1e-8)


def test_a_force_that_jumps_moves_a_damper_at_another_rate() -> None:
    text = DAMPERS.replace("end", "  force (if time > 0.5 s then 3 N else 0 N) on s;\nend", 1)
    motion = lagdsl.compile(text).simulate(stop=1.0, tolerance=1e-10)
    # m x'' = -3 (x' - s'), 9 s' = 3 x' + F: x'' = -x' + F/2/3
    half = np.exp(-0.5)
    assert motion["der(x)"][-1] == pytest.approx(0.5 + (half - 0.5) * half, abs=1e-9)
    assert motion["der(s)"][-1] == pytest.approx((motion["der(x)"][-1] + 1.0) / 3.0, abs=1e-9)


def test_a_blow_on_the_mass_leaves_the_spring_of_a_maxwell_element() -> None:
    """The same motion with the spring as a state of first order, whose rate is written."""
    falling = """
  force -19.62 N on x;
  contact floor: x >= 0 m with restitution = 0.7;
"""
    text = MAXWELL.replace("end Maxwell", f"{falling}end Maxwell")
    states = """
model States
  coordinate Length x(start = 0.1 m);
  state Length s(start = 0.1 m);
  kinetic 1/2*(2 kg)*der(x)^2;
  force -(400 N/m)*s on x;{falling}equation
  der(s) = der(x) - (400 N/m)*s/(7 N.s/m);
end States;
""".replace("{falling}", falling)
    one, other = (lagdsl.compile(each).simulate(stop=0.6, tolerance=1e-9) for each in (text, states))
    assert len(one.events) == len(other.events) > 2
    for name in ("x", "s"):
        assert np.allclose(one[name], other[name], atol=1e-8)


def test_elongations_as_coordinates() -> None:
    """The kinetic energy has one square for two coordinates: their difference has no inertia."""
    motion = lagdsl.compile(
        """
        model Sums
          coordinate Length a(start = 0.075 m), b(start = 0.025 m);
          kinetic 1/2*(2 kg)*(der(a) + der(b))^2;
          potential 1/2*(100 N/m)*a^2 + 1/2*(300 N/m)*b^2;
        end Sums;
        """
    ).simulate(stop=1.0, tolerance=1e-10)
    assert np.allclose(motion["a"], 0.075 * np.cos(np.sqrt(37.5) * motion["time"]), atol=1e-10)


def test_a_gear_between_two_springs() -> None:
    """Angles p and p/r of the gear: r k1 (a - p) = k2 (p/r - b); the ratio is a parameter."""
    model = lagdsl.compile(
        """
        model Train
          import Lag.Rotational.*;
          Rotor motor(J = 2 kg.m2, phi(start = 1 rad)), load(J = 3 kg.m2);
          Spring fast(k = 100 N.m/rad), slow(k = 200 N.m/rad);
          Gear gear(ratio = 3);
          connect(motor.phi, fast.phi_a);
          connect(fast.phi_b, gear.phi_a);
          connect(gear.phi_b, slow.phi_a);
          connect(slow.phi_b, load.phi);
          output Torque teeth = multiplier(gear.mesh);
        end Train;
        """
    )
    for ratio in (3.0, 2.0):
        motion = model.simulate(stop=1.0, tolerance=1e-10, parameters={"gear.ratio": ratio})
        series = 1.0 / (1.0 / 100.0 + ratio**2 / 200.0)  # of the fast side, as of motor - ratio*load
        twist = np.cos(np.sqrt(series * (1.0 / 2.0 + ratio**2 / 3.0)) * motion["time"])
        assert np.allclose(motion["motor.phi"] - ratio * motion["load.phi"], twist, atol=1e-9)
        assert np.allclose(motion["teeth"], -series * twist, atol=1e-6)


def test_start_of_a_knot_is_a_guess() -> None:
    text = KNOT.replace("x(start = 0.1 m)", "x").replace("k1*s^2", "k1*(s - 0.2 m)^2")
    motion = lagdsl.compile(text).simulate(stop=0.1)
    assert motion["x"][0] == 0.0 and motion["s"][0] == pytest.approx(0.05)
    found = lagdsl.check(KNOT.replace(", s;", ", s(start = 0.01 m);"))
    assert "W0814" in [each.code for each in found]


GEARED = """model Geared
  coordinate Angle a(start = 0.1), b, c, d;
  kinetic 1/2*(1 kg.m2)*der(a)^2;
  potential 1/2*(10 N.m)*(a - b)^2 + 1/2*(5 N.m)*c^2 + 1/2*(3 N.m)*(a - d)^2 + 1/2*(2 N.m)*d^2;
  constraint gear: b = 2*c;
end Geared;
"""


def test_the_derivation_counts_no_more_than_its_equations_show() -> None:
    """One of the two balances is along the gear, and `lag check` alone knows of it: one degree of freedom."""
    text = " ".join(str(lagdsl.compile(GEARED).derive()).split())
    assert "d holds no inertia: as a balance of forces it leaves fewer degrees of freedom than are counted here" in text
