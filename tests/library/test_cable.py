"""The cable of the library against closed forms and published values."""

from __future__ import annotations

from functools import cache
from math import asinh, cosh, hypot, sinh, sqrt

import numpy as np
import pytest
from choice import chosen
from scipy.optimize import brentq
from scipy.special import jn_zeros

import lagdsl

CLAMPED_FREE = (1.875104068711961, 4.694091132974174)  # roots of cosh(x) cos(x) = -1
G_N = 9.80665


def _told(model: lagdsl.Model, **parameters: float) -> np.ndarray:
    point = model.trim(parameters=parameters).point
    return np.asarray(model.output(0.0, point.q, point.qd, parameters=parameters)).ravel()


@pytest.mark.parametrize(("n", "tolerance"), chosen([(4, 7e-3), (32, 1e-12)], [(4, 7e-3)]))
def test_a_cantilever_sags_as_in_exudyn(n: int, tolerance: float) -> None:
    """The value -0.5013058140308901 that ObjectANCFCable2D.py in main/pythonDev/TestModels/MiniExamples of Exudyn
    (J. Gerstmayr, github.com/jgerstmayr/EXUDYN) states for 32 elements of the same kind."""
    model = lagdsl.compile(f"""
model Cantilever
  Lag.Flexible.Cable cable(n = {n}, dim = 2, clamped = true, L = 2 m, A = 0.01 m2, E = 1e8 Pa, I = (1 m4)/120000,
      density = 7800 kg/m3);
  gravity = -9.81 m/s2*world.y;
  connect(world, cable);
  output Length u = cable.frame_b.origin.x - 2 m;
end Cantilever;
""")
    assert _told(model) == pytest.approx(-0.5013058140308901, rel=tolerance)


WEIGHT = 1000 * 1e-6 * G_N * 2.0


def _catenary(stiffness: float) -> tuple[float, float]:
    """Height of the lowest point and horizontal force: H. M. Irvine, Cable Structures, section 1.3."""
    length, span = 2.0, 1.6

    def excess(force: float) -> float:
        return length * force * (1 / stiffness + 2 / WEIGHT * asinh(WEIGHT / 2 / force)) - span

    force = brentq(excess, 1e-6, 1.0, xtol=1e-15)
    low = -WEIGHT * length / (8 * stiffness) - force * length / WEIGHT * (sqrt(1 + (WEIGHT / 2 / force) ** 2) - 1)
    return low, force


def _pull(stiffness: float, length: float) -> float:
    """The mean tension from the lowest point up to a length."""
    force, there = _catenary(stiffness)[1], WEIGHT * length / 2
    return (hypot(force, there) + force**2 / there * asinh(there / force)) / 2


@cache
def _hung(n: int, more: str = "") -> lagdsl.Model:
    return lagdsl.compile(f"""
model Catenary
  import Lag.Planar.*;
  Lag.Flexible.Cable cable(n = {n}, dim = 2, L = 2 m, A = 1 mm^2, E = 0.1 MPa, I = 1e-6 mm^4, density = 1000 kg/m3,
      reach = {{1.6 m, 0, 0}}{more});
  Revolute pin;
  Fixed post(r = {{1.6 m, 0}});
  gravity = -g_n*world.y;
  connect(world, cable, pin, post);
  output Length low = cable.node[{n // 2}].origin.y;
  output Force pull = cable.tension[{n // 2}];
end Catenary;
""")


def test_a_catenary_sags_with_more_than_fourth_order() -> None:
    """The elastic one: under its weight the cable is a tenth longer."""
    errors = []
    for n in (4, 8):
        low, pull = _told(_hung(n))[:2]
        errors.append(abs(low / _catenary(0.1)[0] - 1))
    assert pull == pytest.approx(_pull(0.1, 0.25), rel=2e-3)
    assert errors[1] < 1e-5
    assert errors[0] / errors[1] > 2**4


def test_a_stiff_rope_sags_as_cosh_says() -> None:
    """From the parabola at which it starts; the last one does not stretch. Where the length is held at five points of
    each element, the tension of the last is wrong by 76 %, and there are other equilibria with kinks."""
    errors = []
    for n, moduli in ((4, (1e6, 1e9)), (8, (1e6, 1e8, 1e10))):
        model = _hung(n, ", reduced = true")
        for modulus in moduli:
            low, pull = _told(model, **{"cable.E": modulus})[:2]
            assert pull == pytest.approx(_pull(1e-6 * modulus, 2 / n), rel=2e-4)
            assert low == pytest.approx(_catenary(1e-6 * modulus)[0], rel=6e-4)
        errors.append(low / -_inextensible() - 1)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.2)


def _inextensible() -> float:
    """Sag a (cosh(span/2a) - 1) where a sinh(span/2a) is half of the length."""
    a = brentq(lambda a: a * sinh(0.8 / a) - 1.0, 0.1, 10.0, xtol=1e-15)
    return float(a * (cosh(0.8 / a) - 1))


@cache
def _hanging() -> lagdsl.Model:
    return lagdsl.compile("""
model Hanging
  Lag.Flexible.Cable cable(n = 4, L = 2 m, A = 1 mm^2, E = 1 GPa, I = 1e-9 mm^4, density = 1000 kg/m3);
  gravity = g_n*world.x;
  connect(world, cable);
end Hanging;
""")


def test_a_hanging_cable_swings_as_bernoulli_and_bessel_say() -> None:
    """omega = j/2 sqrt(g/L) with the zeros j of J_0, twice each: in two planes."""
    values = np.sort(np.abs(_hanging().modes(trim=True).eigenvalues.imag))[::2]
    exact = np.repeat(jn_zeros(0, 3) / 2 * sqrt(G_N / 2), 2)
    assert values[:2] == pytest.approx(exact[:2], rel=1e-4)
    assert values[:6] == pytest.approx(exact, rel=5e-3)


def test_modes_of_a_clamped_cable() -> None:
    model = lagdsl.compile("""
model Clamped
  Lag.Flexible.Cable cable(n = 4, dim = 2, clamped = true, L = 2 m, A = 1 cm^2, I = 1 mm^4, zeta = 0.03);
  gravity = 0;
  connect(world, cable);
end Clamped;
""")
    found = model.modes()
    values = found.eigenvalues
    slow = sorted(values[values.imag > 0], key=abs)[:2]
    exact = np.array(CLAMPED_FREE) ** 2 / 4 * sqrt(210e9 * 1e-12 / (7700 * 1e-4))
    assert np.abs(slow) == pytest.approx(exact, rel=2e-3)
    assert np.abs(slow[0]) == pytest.approx(exact[0], rel=5e-5)
    assert -slow[0].real / abs(slow[0]) == pytest.approx(0.03, rel=1e-4)
    across = [model.coordinates.index(f"cable.r[{k},2]") for k in (1, 2, 3, 4)]
    for k, value in enumerate(slow):
        shape = found.shapes[np.argmin(np.abs(values - value)), across]
        expected = _shape(CLAMPED_FREE[k] * np.linspace(0.25, 1, 4), CLAMPED_FREE[k])
        assert shape / shape[-1] == pytest.approx(expected / expected[-1], abs=2e-3)


def _shape(x: np.ndarray, end: float) -> np.ndarray:
    """Of a clamped beam: Timoshenko, Vibration Problems in Engineering, 3rd ed., section 57."""
    ratio = (np.cosh(end) + np.cos(end)) / (np.sinh(end) + np.sin(end))
    return np.asarray(np.cosh(x) - np.cos(x) - ratio * (np.sinh(x) - np.sin(x)))


def test_it_bends_in_space_as_in_the_plane() -> None:
    """A force at the end; the plane of the spatial cable is inclined."""
    places = []
    for dim, force in (("2", "{0, 1 N, 0}"), ("3", "{0, 0.8 N, 0.6 N}")):
        model = lagdsl.compile(f"""
model Bent
  Lag.Flexible.Cable cable(n = 2, dim = {dim}, clamped = true, L = 1 m, A = 1 mm^2, E = 10 GPa, I = 100 mm^4);
  gravity = 0;
  connect(world, cable);
  force {force} at cable.frame_b;
  output Length tip[3] = cable.frame_b.origin;
  output Real along[3] = cable.frame_b.x;
  output Torque moment[3] = cable.moment[1];
  output Pressure stress = cable.stress[1];
end Bent;
""")
        places.append(_told(model))
    plane, space = places
    assert plane[1] > 0.2
    turned = [[0, 0.8 * plane[k + 1], 0.6 * plane[k + 1]] for k in (0, 3)]
    assert space[1:3] == pytest.approx(turned[0][1:], rel=1e-9)
    assert space[3:6] == pytest.approx([plane[3], *turned[1][1:]], rel=1e-9)
    assert space[6:9] == pytest.approx([0, -0.6 * plane[8], 0.8 * plane[8]], rel=1e-9, abs=1e-12)
    assert space[9] == pytest.approx(plane[9], rel=1e-9)


def test_a_falling_cable_keeps_its_momentum() -> None:
    """Pinned to a mass that falls; the cable flies apart in space."""
    motion = lagdsl.compile("""
model Falling
  coordinate Length x[3](der(start = {1 m/s, 0, 0}));
  Lag.Flexible.Cable cable(n = 2, L = 1 m, A = 1 cm^2, E = 1 MPa, density = 1100 kg/m3,
      r(der(start = {{0, 0, 3 m/s}, {0, 2 m/s, 0}})));
  gravity = -g_n*world.y;
  mass 0.1 kg at x;
  frame ball = world.move(x);
  connect(ball, cable);
  output Momentum P[3] = linear_momentum();
  output Energy W = energy();
  annotation(experiment(StopTime = 0.3, Tolerance = 1e-10));
end Falling;
""").simulate()
    t = motion.time
    for k, rate in ((1, 0.0), (2, -0.21 * G_N), (3, 0.0)):
        column = motion[f"P[{k}]"]
        assert column - column[0] == pytest.approx(rate * t, abs=1e-9)
    assert motion["W"] == pytest.approx(motion["W"][0], abs=1e-8)
