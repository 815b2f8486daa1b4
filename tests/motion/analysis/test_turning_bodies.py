"""Bodies that turn steadily in a quaternion: closed forms of free bodies and tops."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.analysis.modes import Modes

G_N = 9.80665
Triple = tuple[float, float, float]


def body(moments: Triple, omega: Triple, e: tuple[float, ...] = (1, 0, 0, 0), arm: float | None = None) -> str:
    """A body with these principal moments about its mass center, which lies at `arm` on its z axis, if that is given
    under gravity, from the fixed point."""
    gravity = "0" if arm is None else "-g_n*world.z"
    start = ", ".join(f"{w!r} rad/s" for w in omega)
    return f"""
    model Spin
      parameter Mass m = 1 kg;
      coordinate Quaternion e(start = {{{", ".join(repr(x) for x in e)}}}, omega(start = {{{start}}}));
      frame B = world.quat(e);
      gravity = {gravity};
      body b(m = m, com = {{0, 0, {arm or 0.0!r}}}, I = {{{", ".join(f"{x!r} kg.m2" for x in moments)}}}) on B;
    end Spin;"""


def modes_of(text: str) -> tuple[Modes, list[str]]:
    sink = Sink()
    modes = lagdsl.compile(text).modes(sink=sink)
    return modes, [each.code for each in sink.diagnostics]


def upper(modes: Modes) -> list[complex]:
    """One of each pair, sorted by frequency."""
    return sorted((s for s in modes.eigenvalues.tolist() if s.imag > 0.0), key=lambda s: s.imag)


@pytest.mark.parametrize(("a", "c"), [(2.0, 3.0), (2.0, 0.5), (1.0, 2.0), (1.0, 1.0)])
def test_free_symmetric_body(a: float, c: float) -> None:
    """In space its axis nutates at C W/A (Goldstein, Classical Mechanics, section 5.6); all else is at rest."""
    modes, codes = modes_of(body((a, a, c), (0.0, 0.0, 5.0)))
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    np.testing.assert_allclose(upper(modes), [5j * c / a], rtol=1e-12, atol=1e-11)
    assert np.count_nonzero(modes.eigenvalues == 0.0) == 4


def test_feynmans_plate() -> None:
    """A thin plate, C = A + B, wobbles twice as fast as it spins, whatever its shape."""
    modes, _ = modes_of(body((1.0, 2.0, 3.0), (0.0, 0.0, 5.0)))
    np.testing.assert_allclose(upper(modes), [10j], rtol=1e-12, atol=1e-11)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_free_asymmetric_body(axis: int) -> None:
    """In body axes s^2 = -W^2 (I1 - I2)(I1 - I3)/(I2 I3) about axis 1: stable but for the middle one (Euler). A tilt
    stands still in space: a pair at W."""
    moments, spin = (1.0, 2.0, 2.5), 5.0
    omega = [0.0, 0.0, 0.0]
    omega[axis] = spin
    modes, codes = modes_of(body(moments, (omega[0], omega[1], omega[2])))
    one, two, three = moments[axis], moments[axis - 2], moments[axis - 1]
    square = -(spin**2) * (one - two) * (one - three) / (two * three)
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    if square < 0.0:
        np.testing.assert_allclose(upper(modes), sorted([1j * np.sqrt(-square), 1j * spin], key=abs), atol=1e-10)
        assert modes.unstable == 0
    else:
        real = [s for s in modes.eigenvalues.tolist() if s.real > 1e-9]
        np.testing.assert_allclose(real, [np.sqrt(square)], atol=1e-10)
        assert modes.unstable == 1 and modes.stability.startswith("unstable steady motion")


@pytest.mark.parametrize("omega", [(1.0, 5.0, 0.0), (0.3, 0.0, 4.0), (1.0, 1.0, 1.0)])
def test_tumbling_is_not_steady(omega: Triple) -> None:
    modes, codes = modes_of(body((1.0, 2.0, 2.5), omega))
    assert modes.steadiness.kind == "neither" and "W0854" in codes


def test_steady_in_any_orientation() -> None:
    modes, _ = modes_of(body((1.0, 2.0, 2.5), (0.0, 0.0, 5.0), e=(0.5, 0.7, 0.5, 0.1)))
    np.testing.assert_allclose(upper(modes), [5j * np.sqrt(0.375), 5j], atol=1e-10)


@pytest.mark.parametrize("spin", [15.0, 30.0, 60.0])
def test_sleeping_top(spin: float) -> None:
    """A s^2 - i C n s - m g l = 0 (Routh): stable if (C n)^2 > 4 A m g l."""
    a, c, arm = 0.03, 0.02, 0.1
    fixed = a + arm**2
    modes, codes = modes_of(body((a, a, c), (0.0, 0.0, spin), arm=arm))
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    roots = np.roots([fixed, -1j * c * spin, -G_N * arm])
    expected = sorted([*roots, *np.conj(roots), 0, 0], key=lambda s: (round(s.real, 6), round(s.imag, 6)))
    found = sorted(modes.eigenvalues.tolist(), key=lambda s: (round(s.real, 6), round(s.imag, 6)))
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)
    assert bool(modes.unstable) == ((c * spin) ** 2 < 4 * fixed * G_N * arm)


@pytest.mark.parametrize(("tilt", "precession"), [(0.6, 3.0), (1.2, -4.0), (2.0, 2.0)])
def test_steady_precession(tilt: float, precession: float) -> None:
    """A W^2 cos(b) - C n W + m g l = 0; the nutation about it is that of the effective potential of the tilt b (Landau,
    Lifshitz, Mechanics, section 35)."""
    a, c, arm = 0.03, 0.02, 0.1
    fixed = a + arm**2
    n = (fixed * precession**2 * np.cos(tilt) + G_N * arm) / (c * precession)
    omega = (0.0, float(precession * np.sin(tilt)), float(n))
    modes, codes = modes_of(
        body((a, a, c), omega, e=(float(np.cos(tilt / 2)), float(np.sin(tilt / 2)), 0.0, 0.0), arm=arm)
    )
    momentum = fixed * precession * np.sin(tilt) ** 2 + c * n * np.cos(tilt)

    def slope(b: complex) -> complex:
        """dV/db of V = (p - C n cos b)^2/(2 A sin(b)^2) + m g l cos b."""
        d, s = momentum - c * n * np.cos(b), np.sin(b)
        return d * c * n / (fixed * s) - d**2 * np.cos(b) / (fixed * s**3) - G_N * arm * s

    stiffness = slope(tilt + 1e-30j).imag / 1e-30
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    np.testing.assert_allclose(upper(modes), [1j * np.sqrt(stiffness / fixed)], rtol=1e-9, atol=1e-9)
    assert np.count_nonzero(modes.eigenvalues == 0.0) == 4


def test_gravity_on_a_leaning_top_is_not_steady() -> None:
    text = body((0.03, 0.03, 0.02), (0.0, 0.0, 30.0), e=(np.cos(0.2).item(), np.sin(0.2).item(), 0.0, 0.0), arm=0.1)
    modes, codes = modes_of(text)
    assert modes.steadiness.kind == "neither" and "W0854" in codes


def test_an_unsymmetric_top_that_stands() -> None:
    """Its axes must turn with it: Euler's equations for small tilts x, y in body axes,
    A x'' - (A + B - C) W y' + ((C - B) W^2 - m g l) x = 0, B y'' + (A + B - C) W x' + ((C - A) W^2 - m g l) y = 0."""
    c, arm, spin = 0.03, 0.1, 40.0
    a, b = 0.02 + arm**2, 0.04 + arm**2
    modes, codes = modes_of(body((0.02, 0.04, c), (0.0, 0.0, spin), arm=arm))
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    x, y = (c - b) * spin**2 - G_N * arm, (c - a) * spin**2 - G_N * arm
    roots = np.roots([a * b, 0.0, a * y + b * x + ((a + b - c) * spin) ** 2, 0.0, x * y])
    found = [s for s in modes.eigenvalues.tolist() if s != 0.0]
    order = {"key": lambda s: (round(s.real, 6), round(s.imag, 6))}
    np.testing.assert_allclose(sorted(found, **order), sorted(roots.tolist(), **order), rtol=1e-9, atol=1e-9)


def test_free_flight_beside_a_turning_body() -> None:
    """Joints of the library: a body that spins and flies, and one on a spring beside it."""
    text = """
    model Flight
      import Lag.Spatial.*;
      FreeQuaternion j(e(omega(start = {0, 0, 5 rad/s})), r(der(start = {1 m/s, 0, 0})));
      Body b(m = 2 kg, I = {2, 2, 3});
      connect(world, j, b);
      coordinate Length s;
      mass 1 kg at {s, 0, 0};
      potential 1/2*(9 N/m)*s^2;
      gravity = 0;
    end Flight;"""
    modes, codes = modes_of(text)
    assert modes.steadiness.kind == "steady motion" and "W0854" not in codes
    np.testing.assert_allclose(upper(modes), [3j, 7.5j], atol=1e-10)
    assert np.count_nonzero(modes.eigenvalues == 0.0) == 10


def test_threshold_of_the_sleeping_top() -> None:
    """(C n)^2 = 4 A m g l with A = I + m l^2 has the mass m where it falls."""
    a, c, arm, spin = 0.03, 0.02, 0.1, 30.0
    model = lagdsl.compile(body((a, a, c), (0.0, 0.0, spin), arm=arm))
    found = model.vary("m", np.linspace(0.5, 4.0, 6))
    m = np.roots([arm**2, a, -((c * spin) ** 2) / (4 * G_N * arm)]).max()
    (threshold,) = found.thresholds
    assert threshold.value == pytest.approx(m, rel=1e-6)
