"""Motions of model texts against closed forms, from text to trajectory."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipj, ellipk

import lagdsl


def motion(text: str, **options: Any) -> lagdsl.Trajectory:
    return lagdsl.compile(text).simulate(**options)


PENDULUM = """
model Pendulum
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 2 rad);
  gravity = {0, -9.81 m/s2};
  mass m at {l*sin(theta), -l*cos(theta)};
  invariant E: energy();
end Pendulum;
"""


def test_period_of_a_pendulum_is_the_complete_elliptic_integral() -> None:
    """Source: Landau and Lifshitz, Mechanics, section 11: T = 4 sqrt(l/g) K(sin(amplitude/2))."""
    swing = motion(PENDULUM, stop=6.5, interval=0.02, tolerance=1e-11)
    rising = swing.crossings("theta", direction=1)
    period = 4.0 * np.sqrt(0.5 / 9.81) * ellipk(np.sin(1.0) ** 2)
    assert np.allclose(np.diff(rising), period, atol=1e-8)
    assert len(rising) >= 3


def test_pendulum_in_the_plane_moves_as_in_its_angle_and_the_rod_pulls() -> None:
    """Multiplier of |P| = l: the rod pulls inward with m (v^2/l + g cos(theta)), so it is negative."""
    text = """
    model Plane
      coordinate Length x(start = 0.5*sin(2)), y(start = -0.5*cos(2));
      parameter Length l = 0.5 m;
      gravity = {0, -9.81 m/s2};
      mass 2 kg at {x, y};
      constraint rod: norm({x, y}) = l;
      output Force pull = multiplier(rod);
    end Plane;
    """
    swing = motion(
        text.replace("0.5*sin(2)", "0.5 m*sin(2)").replace("0.5*cos(2)", "0.5 m*cos(2)"), stop=2.0, tolerance=1e-10
    )
    k2 = np.sin(1.0) ** 2
    theta = 2.0 * np.arcsin(np.sqrt(k2) * ellipj(ellipk(k2) - np.sqrt(9.81 / 0.5) * swing.time, k2)[0])
    assert np.max(np.abs(swing["x"] - 0.5 * np.sin(theta))) < 1e-9
    speed2 = swing["der(x)"] ** 2 + swing["der(y)"] ** 2
    assert np.allclose(swing["pull"], -2.0 * (speed2 / 0.5 + 9.81 * np.cos(theta)), atol=1e-7)
    assert np.max(swing.position_residual) < 1e-12


def test_kepler_ellipse_closes_after_its_period() -> None:
    """GM = 1, started at the apocenter of an ellipse with a = 1, e = 0.6: T = 2 pi, v = sqrt((1 - e)/(1 + e))."""
    text = """
    model Orbit
      annotation(units = "none");
      coordinate Real x(start = 1.6), y(der(start = 0.5));
      gravity = 0;
      mass 1 at {x, y};
      potential -1/sqrt(x^2 + y^2);
      invariant E: energy();
    end Orbit;
    """
    orbit = motion(text, stop=2.0 * np.pi, tolerance=1e-11)
    assert orbit["x"][-1] == pytest.approx(1.6, abs=1e-8)
    assert orbit["y"][-1] == pytest.approx(0.0, abs=1e-8)
    assert np.max(np.abs(orbit.energy - orbit.energy[0])) < 1e-10
    momentum = orbit["x"] * orbit["der(y)"] - orbit["y"] * orbit["der(x)"]
    assert np.ptp(momentum) < 1e-10
    # Kepler's equation halfway to the pericenter's other side: at T/2 the distance is a (1 - e).
    assert np.min(np.hypot(orbit["x"], orbit["y"])) == pytest.approx(0.4, abs=1e-6)


def test_oscillation_seen_from_a_turntable_precesses_like_foucaults() -> None:
    """In the inertial frame it stays in its plane, so on the table the plane turns by -Omega t."""
    text = """
    model Turntable
      parameter AngularVelocity Omega = 0.3 rad/s;
      coordinate Length x(start = 0.1 m), y(der(start = -0.3*0.1 m/s));
      frame table = world.rotz(Omega*time);
      gravity = 0;
      mass 1 kg at x*table.x + y*table.y;
      potential 1/2*(4 N/m)*(x^2 + y^2);
    end Turntable;
    """
    seen = motion(text.replace("-0.3*0.1 m/s", "-0.03 m/s"), stop=20.0, tolerance=1e-10)
    swing = 0.1 * np.cos(2.0 * seen.time)
    assert np.max(np.abs(seen["x"] - swing * np.cos(0.3 * seen.time))) < 1e-9
    assert np.max(np.abs(seen["y"] + swing * np.sin(0.3 * seen.time))) < 1e-9


SPHERICAL = """
model Spherical
  parameter Length l = 1 m;
  coordinate Angle theta(start = 0.6 rad), phi(der(start = {rate} rad/s));
  point P = l*{sin(theta)*cos(phi), sin(theta)*sin(phi), -cos(theta)};
  gravity = -9.81 m/s2*world.z;
  mass 1 kg at P;
  invariant E: energy();
  invariant p: momentum(phi);
end Spherical;
"""


def test_conical_pendulum_keeps_its_angle() -> None:
    """phi'^2 = g/(l cos(theta))."""
    text = SPHERICAL.replace("{rate}", repr(float(np.sqrt(9.81 / np.cos(0.6)))))
    steady = motion(text, stop=5.0, tolerance=1e-10)
    assert np.max(np.abs(steady["theta"] - 0.6)) < 1e-10


def test_turning_points_of_the_spherical_pendulum() -> None:
    """z = cos(theta) runs between roots of 2 (E + g z)(1 - z^2) = p^2.

    Source: Landau and Lifshitz, Mechanics, section 14, problem 1.
    """
    orbit = motion(SPHERICAL.replace("{rate}", "1.5"), stop=3.0, interval=0.002, tolerance=1e-10)
    z0, p = np.cos(0.6), np.sin(0.6) ** 2 * 1.5
    energy = p**2 / (2 * np.sin(0.6) ** 2) - 9.81 * z0
    roots = np.roots([-2 * 9.81, -2 * energy, 2 * 9.81, 2 * energy - p**2])
    between = sorted(roots[(roots > -1) & (roots < 1)])
    z = np.cos(orbit["theta"])
    assert [z.min(), z.max()] == pytest.approx(between, abs=1e-5)
    assert all(record.drift < 1e-9 for record in orbit.invariants)


def test_disc_rolls_down_an_incline_with_two_thirds_of_gravity() -> None:
    """der(der(x)) = 2/3 g sin(a); friction m g sin(a)/3 acts up the slope: the multiplier of the row is negative."""
    text = """
    model Rolling
      parameter Angle a = 0.4 rad;
      parameter Length R = 0.2 m;
      coordinate Length x;
      coordinate Angle phi;
      gravity = 9.81 m/s2*{sin(a), -cos(a)};
      mass 3 kg at {x, R};
      kinetic 1/2*(1/2*3 kg*R^2)*der(phi)^2;
      constraint roll: der(x) - R*der(phi) = 0;
      output Force friction = multiplier(roll);
    end Rolling;
    """
    reroll = motion(text, stop=2.0, tolerance=1e-10)
    assert reroll["x"][-1] == pytest.approx(0.5 * 2.0 / 3.0 * 9.81 * np.sin(0.4) * 4.0, rel=1e-10)
    assert np.allclose(reroll["friction"], -9.81 * np.sin(0.4), atol=1e-10)


def test_free_bodies_keep_their_momentum() -> None:
    text = """
    model Pair
      coordinate Length x1, y1, x2(start = 1 m), y2(der(start = 0.7 m/s));
      point A = {x1, y1};
      point B = {x2, y2};
      gravity = 0;
      mass 1 kg at A;
      mass 2 kg at B;
      potential 1/2*(50 N/m)*(norm(B - A) - 0.8 m)^2;
      invariant E: energy();
    end Pair;
    """
    pair = motion(text, stop=5.0, tolerance=1e-10)
    assert np.max(np.abs(pair["der(x1)"] + 2 * pair["der(x2)"])) < 1e-10
    assert np.max(np.abs(pair["y1"] + 2 * pair["y2"] - 1.4 * pair.time)) < 1e-9
    spin = pair["x1"] * pair["der(y1)"] - pair["y1"] * pair["der(x1)"]
    spin += 2 * (pair["x2"] * pair["der(y2)"] - pair["y2"] * pair["der(x2)"])
    assert np.ptp(spin) < 1e-9


def test_symmetric_body_in_quaternions_precesses() -> None:
    """Euler's equations: with I1 = I2 the spin w3 stays and (w1, w2) turns at (I3 - I1)/I1 w3.

    Source: Goldstein, Classical Mechanics, section 5.6.
    """
    text = """
    model Free
      coordinate Quaternion e(omega(start = {0.5 rad/s, 0, 2 rad/s}));
      frame B = world.quat(e);
      gravity = 0;
      body b(I = {2 kg.m2, 2 kg.m2, 3 kg.m2}) on B;
      output AngularVelocity w1 = omega(B)*B.x;
      output AngularVelocity w2 = omega(B)*B.y;
      output AngularVelocity w3 = omega(B)*B.z;
    end Free;
    """
    free = motion(text, stop=10.0, tolerance=1e-10)
    assert np.allclose(free["w3"], 2.0, atol=1e-8)
    assert np.allclose(free["w1"], 0.5 * np.cos(1.0 * free.time), atol=1e-8)
    assert np.allclose(free["w2"], 0.5 * np.sin(1.0 * free.time), atol=1e-8)
    assert np.max(free.position_residual) < 1e-12


def test_driven_damped_oscillator_settles_to_its_response() -> None:
    """x'' + 0.4 x' + 4 x = sin(3 t): amplitude 1/sqrt(25 + 1.44)."""
    text = """
    model Shaker
      input Force u;
      coordinate Length x;
      gravity = 0;
      mass 1 kg at {x, 0};
      potential 1/2*(4 N/m)*x^2;
      dissipation 1/2*(0.4 N.s/m)*der(x)^2;
      force u on x;
    end Shaker;
    """
    shaken = motion(text, stop=50.0, interval=0.02, tolerance=1e-8, inputs={"u": lambda t: np.sin(3.0 * t)})
    late = shaken.time > 45.0
    assert np.max(shaken["x"][late]) == pytest.approx(1.0 / np.sqrt(25.0 + 1.44), rel=1e-3)


def test_dependent_constraints_change_nothing() -> None:
    common = """
      coordinate Length x(start = 0.3 m), y(start = -0.4 m);
      gravity = {0, -9.81 m/s2};
      mass 1 kg at {x, y};
      constraint rod: x^2 + y^2 = 0.25 m2;
    """
    once = motion(f"model Once {common} end Once;", stop=3.0, tolerance=1e-10)
    doubled = motion(
        f"model Twice {common}\nconstraint again: norm({{x, y}}) = 0.5 m; end Twice;", stop=3.0, tolerance=1e-10
    )
    assert np.max(np.abs(once["x"] - doubled["x"])) < 1e-8
    assert np.max(doubled.position_residual) < 1e-12


FOUR_BAR = """
model FourBar
  parameter Length a = 0.4 m, b = 1 m, c = 0.8 m, d = 1 m;
  coordinate Angle A(start = 60 deg, fixed = true), B(start = 30 deg), C(start = 80 deg);
  gravity = -g_n*world.y;
  point P = a*{cos(A), sin(A)};
  mass 2 kg at P;
  mass 1 kg at P + b*{cos(B), sin(B)};
  constraint x: a*cos(A) + b*cos(B) = d + c*cos(C);
  constraint y: a*sin(A) + b*sin(B) = c*sin(C);
  invariant E: energy();
end FourBar;
"""


def test_four_bar_for_a_hundred_seconds() -> None:
    """Constraints stay below 1e-9 (in meters, and in meters per second) and the energy within 1e-8 of its scale."""
    try:
        model = lagdsl.compile(FOUR_BAR, engine="c")
    except lagdsl.CompilationFailed:  # no C compiler on this machine: the same, shorter
        model = lagdsl.compile(FOUR_BAR)
        turning = model.simulate(stop=10.0, interval=0.1, tolerance=1e-8)
    else:
        turning = model.simulate(stop=100.0, interval=0.1, tolerance=1e-8)
    assert np.max(turning.position_residual) < 1e-9
    assert np.max(turning.velocity_residual) < 1e-9
    (record,) = turning.invariants
    assert record.drift < 1e-8 * record.limit / 1e-5


def test_mechanism_started_at_dead_center() -> None:
    """Crank and rod in line: from rest gravity cannot decide, the given rate does; energy and closure are kept."""
    text = """
    model Press
      coordinate Angle th(start = 0, fixed = true, der(start = 3 rad/s));
      coordinate Angle ph;
      coordinate Length s(start = 0.5 m);
      gravity = {0, -9.81 m/s2};
      point pin = 0.2 m*{cos(th), sin(th)};
      mass 1 kg at pin;
      mass 2 kg at {s, 0};
      constraint rod: pin + 0.5 m*{cos(ph), -sin(ph)} = {s, 0};
      invariant E: energy();
    end Press;
    """
    press = motion(text, stop=1.5, tolerance=1e-10, interval=0.05)
    assert press["s"][0] == pytest.approx(0.7, abs=1e-12)
    assert press["der(s)"][0] == pytest.approx(0.0, abs=1e-12)
    exact = 0.2 * np.cos(press["th"]) + np.sqrt(0.25 - 0.04 * np.sin(press["th"]) ** 2)
    assert np.max(np.abs(press["s"] - exact)) < 1e-11


def test_prescribed_rotation_keeps_the_jacobi_integral_and_not_the_energy() -> None:
    text = """
    model Hoop
      coordinate Angle theta(start = 1 rad);
      frame hoop = world.roty(8 rad/s*time);
      gravity = -g_n*world.y;
      mass 0.1 kg at 0.3 m*(sin(theta)*hoop.x - cos(theta)*hoop.y);
      invariant J: jacobi_integral() with tol = 1e-9;
    end Hoop;
    """
    hoop = motion(text, stop=5.0, tolerance=1e-11)
    assert hoop.invariants[0].drift < 1e-9
    assert np.ptp(hoop.energy) > 0.03
