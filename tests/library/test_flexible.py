"""Beams of the library against closed forms."""

from __future__ import annotations

from functools import cache
from math import pi, sqrt

import numpy as np
import pytest
from choice import chosen
from scipy.optimize import brentq
from scipy.special import ellipeinc, ellipkinc

import lagdsl

# Roots of cosh(x) cos(x) = -1: Timoshenko, Vibration Problems in Engineering, 3rd ed., section 57.
CLAMPED_FREE = (1.875104068711961, 4.694091132974174, 7.854757438237613)


EI = 210e9 * 100e-12


@cache
def _clamped(beam: str, loads: str = "") -> lagdsl.Model:
    return lagdsl.compile(f"""
model Clamped
  import Lag.Flexible.*;
  parameter Force F = 0;
  parameter Torque M = 0;
  {beam};
  gravity = 0;
  connect(world, beam);
  force F*world.y at beam.frame_b;
  torque M*world.z on beam.frame_b;
  output Length x = beam.frame_b.x*world.x*(1 m), tip[3] = beam.frame_b.origin;
  {loads}
end Clamped;
""")


def _exact(n: int) -> lagdsl.Model:
    return _clamped(
        f"ExactBeam beam(L = 2 m, A = 1 cm^2, I = 100 mm^4, n = {n}, load = {{0, w}})",
        f"""parameter Real w(unit = "N/m") = 0;
  output Torque m[{n}] = beam.moment;
  output Force s[{n}] = beam.shear, a[{n}] = beam.normal;""",
    )


def test_a_moment_rolls_the_exact_beam_up_to_a_circle() -> None:
    """M = 2 pi EI/L: J. C. Simo and L. Vu-Quoc, Comput. Methods Appl. Mech. Eng. 58 (1986) 79, section 5.1."""
    model = _exact(4)
    found = model.trim(parameters={"M": 2 * pi * EI / 2})
    x, y, q = np.split(found.point.q, 3)
    assert np.hypot(x[-1], y[-1]) < 1e-10 and q[-1] == pytest.approx(2 * pi, abs=1e-10)


def _elastica(alpha: float) -> tuple[float, float]:
    """Deflection and distance from the clamp, as parts of the length, of the end of a cantilever under the force
    alpha*EI/L^2: K. E. Bisshopp and D. C. Drucker, Quart. Appl. Math. 3 (1945) 272."""

    def length(end: float) -> float:
        k = sqrt((1 + np.sin(end)) / 2)
        low = np.arcsin(1 / (k * sqrt(2)))
        return float(ellipkinc(pi / 2, k**2) - ellipkinc(low, k**2)) - sqrt(alpha)

    end = brentq(length, 1e-6, pi / 2 - 1e-9, xtol=1e-14)
    k = sqrt((1 + np.sin(end)) / 2)
    low = np.arcsin(1 / (k * sqrt(2)))
    deflection = 1 - 2 / sqrt(alpha) * (ellipeinc(pi / 2, k**2) - ellipeinc(low, k**2))
    return float(deflection), sqrt(2 * np.sin(end) / alpha)


def test_the_exact_beam_meets_the_elastica_with_second_order() -> None:
    alpha = 4.0
    deflection, distance = _elastica(alpha)
    errors = []
    for n in (4, 8):
        thin = {"beam.I": 1e-12, "F": alpha * 210e9 * 1e-12 / 4}  # shears and stretches by 1e-8 only
        x, y, _ = np.split(_exact(n).trim(parameters=thin).point.q, 3)
        errors.append(np.hypot(x[-1] / 2 - distance, y[-1] / 2 - deflection))
    assert errors[1] < 2e-3
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.05)


TEN_MODES = "Beam beam(L = 2 m, A = 1 cm^2, I = 1e-4 mm^4, n = 10)"


def test_ten_modes_keep_their_digits() -> None:
    """A sum of powers of x with a rounding error of 1e-12 is shaken by its stiffest modes: that took 200 000 steps."""
    motion = _clamped(TEN_MODES).simulate(stop=1e-4, parameters={"beam.I": 100e-12, "F": 0.01})
    assert motion.statistics.steps < 500


def test_modes_of_a_clamped_beam() -> None:
    model = _clamped(TEN_MODES)
    frequencies = np.sort(np.abs(model.modes().eigenvalues.imag))[::2][:3]
    exact = np.array(CLAMPED_FREE) ** 2 / 4 * sqrt(210e9 * 1e-16 / (7700 * 1e-4))
    assert frequencies == pytest.approx(exact, rel=1e-6)


def _two_modes() -> lagdsl.Model:
    return _clamped(
        "Beam beam(L = 2 m, A = 1 cm^2, I = 100 mm^4)",
        "output Torque m[5] = beam.moment; output Force s[5] = beam.shear; output Pressure p[5] = beam.stress;",
    )


def test_a_load_at_the_end_bends_two_modes_as_statics_says() -> None:
    model = _two_modes()
    force = 0.01
    point = model.trim(parameters={"F": force}).point
    told = model.output(0.0, point.q, point.qd, parameters={"F": force})
    value = dict(zip(model.outputs, np.asarray(told).ravel(), strict=True))
    places = 2 * np.linspace(0, 1, 5)
    fibre = sqrt(3 * 100e-12 / 1e-4)
    assert value["tip[2]"] == pytest.approx(force * 8 / (3 * EI), rel=1e-5)
    assert [value[f"m[{i}]"] for i in range(1, 6)] == pytest.approx(force * (2 - places), rel=1e-4, abs=1e-9)
    assert [value[f"s[{i}]"] for i in range(1, 6)] == pytest.approx([force] * 5, rel=1e-4)
    assert value["p[1]"] == pytest.approx(-force * 2 * fibre / 100e-12, rel=1e-4)


def test_one_mode_bends_under_a_moment_at_the_end() -> None:
    """A moment bends the beam to a circle, the shape of the first mode; its shear force is a sum over no modes."""
    model = _clamped("Beam beam(L = 2 m, A = 1 cm^2, I = 100 mm^4, n = 1)", "output Force s = beam.shear[3];")
    point = model.trim(parameters={"M": 0.1}).point
    assert point.q == pytest.approx([0.1 * 2 / EI])
    told = model.output(0.0, point.q, point.qd, parameters={"M": 0.1})
    assert np.asarray(told).ravel()[model.outputs.index("s")] == 0.0


def test_the_exact_beam_sags_under_its_load() -> None:
    """w x^2 (6 L^2 - 4 L x + x^2)/(24 E I) at the nodes, but for a second order of the length l of elements: strains in
    their middles take w l^2 x (L - x)/(12 E I) off."""
    w, length, x = -0.01, 2, np.linspace(0.5, 2, 4)
    y = _exact(4).trim(parameters={"w": w}).point.q[4:8]
    expected = x**2 * (6 * length**2 - 4 * length * x + x**2) / 24 - 0.5**2 * x * (length - x) / 12
    assert y == pytest.approx(w / EI * expected, rel=3e-5)


def test_forces_in_the_exact_beam_balance_the_load() -> None:
    model = _exact(4)
    point = model.trim(parameters={"F": 5.0}).point
    told = model.output(0.0, point.q, point.qd, parameters={"F": 5.0})
    value = dict(zip(model.outputs, np.asarray(told).ravel(), strict=True))
    x, _, q = np.split(point.q, 3)
    middle = (q + np.append(0, q[:-1])) / 2
    assert [value[f"s[{i}]"] for i in range(1, 5)] == pytest.approx(5 * np.cos(middle), rel=1e-7)
    assert [value[f"a[{i}]"] for i in range(1, 5)] == pytest.approx(5 * np.sin(middle), rel=1e-7)
    lever = x[-1] - (x + np.append(0, x[:-1])) / 2
    assert [value[f"m[{i}]"] for i in range(1, 5)] == pytest.approx(5 * lever, rel=1e-7)


@pytest.mark.parametrize("kind", ["Beam", "ExactBeam"])
def test_damping_is_that_of_the_first_mode(kind: str) -> None:
    model = _two_modes() if kind == "Beam" else _exact(4)
    values = model.modes(parameters={"beam.zeta": 0.03}).eigenvalues
    slowest = min(values[np.abs(values.imag) > 0], key=abs)
    # the ratio is proportional to the frequency, which the mesh of the exact beam has too high
    first = CLAMPED_FREE[0] ** 2 / 4 * sqrt(EI / (7700 * 1e-4))
    assert abs(slowest) == pytest.approx(first, rel=0.05)
    assert -slowest.real / abs(slowest) == pytest.approx(0.03 * abs(slowest) / first, rel=1e-4)


@pytest.mark.parametrize(
    ("speed", "flapping"), chosen([(0, 3.5160), (3, 4.7973), (6, 7.3604), (10, 11.2023)], [(3, 4.7973), (10, 11.2023)])
)
def test_a_rotating_beam_stiffens(speed: float, flapping: float) -> None:
    """A. D. Wright, C. E. Smith, R. W. Thresher and J. L. C. Wang, J. Appl. Mech. 49 (1982) 197, table 1: out of the
    plane of rotation. In the plane the square of the frequency is less by that of the speed."""
    found = np.sort(np.abs(_rotating().modes(parameters={"Omega": speed}).eigenvalues))[0]
    assert found == pytest.approx(sqrt(flapping**2 - speed**2), rel=1e-3)


@cache
def _rotating() -> lagdsl.Model:
    return lagdsl.compile("""
model Rotating "EI/(rho A L^4) = 1"
  parameter AngularVelocity Omega = 0;
  frame hub = world.rotz(Omega*time);
  Lag.Flexible.Beam beam(L = 1 m, A = 1 cm^2, I = 0.01 mm^4, E = 7.7e13 Pa, n = 6);
  gravity = 0;
  connect(hub, beam);
end Rotating;
""")


def test_a_joint_stands_at_a_station() -> None:
    """A beam clamped at one end and held in its middle at its height: the support bears 5/2 of the force at the end."""
    model = lagdsl.compile("""
model Supported
  import Lag.Planar.*;
  Lag.Flexible.Beam beam(L = 2 m, A = 1 cm^2, I = 100 mm^4, n = 6, station = {1/2});
  Revolute pin;
  Prismatic way(s(start = 1 m));
  gravity = 0;
  connect(world, beam);
  connect(world, way, pin, beam.at[1]);
  force 0.01 N*world.y at beam.frame_b;
  output Force support = reaction(way).force.y;
end Supported;
""")
    point = model.trim().point
    told = dict(zip(model.outputs, np.asarray(model.output(0.0, point.q, point.qd)).ravel(), strict=True))
    assert told["support"] == pytest.approx(-0.025, rel=3e-3)


def test_a_floor_under_the_end_bears_its_part() -> None:
    """A force in the middle presses the end of a cantilever by 1 mm onto a floor, where it stays. Clamp and floor share
    the force: F L^2/4 (3 L - L/2)/6 - R L^3/3 = E I 1 mm; the error falls with the second order."""
    exact = (5 * 2**3 / 48 - EI * 1e-3) * 3 / 2**3
    errors = []
    for n in (2, 4):
        model = lagdsl.compile(f"""
model Pressed
  Lag.Flexible.ExactBeam beam(n = {n}, L = 2 m, A = 1 cm^2, I = 100 mm^4, zeta = 0.1);
  gravity = 0;
  connect(world, beam);
  force -1 N*world.y at beam.node[{n // 2}];
  contact floor: beam.frame_b.origin.y >= -1 mm with restitution = 0;
  output Force support = multiplier(floor);
end Pressed;
""")
        motion = model.simulate(stop=3, tolerance=1e-8, solver="radau")
        assert [(event.name, event.kind) for event in motion.events] == [("floor", "impact"), ("floor", "closed")]
        assert motion["beam.y[" + str(n) + "]"].min() == pytest.approx(-1e-3, abs=1e-10)
        errors.append(motion["support"][-1] - exact)
    assert abs(errors[1]) < 0.012 * exact
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.25)
