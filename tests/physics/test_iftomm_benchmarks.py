"""The IFToMM library's benchmarks A01 to A05 against formulations typed by hand.

Source: M. Gonzalez, D. Dopico, U. Lugris, J. Cuadrado, A benchmarking system for MBS simulation software, Multibody
System Dynamics 16 (2006) 179; the errors that it allows for A02 are 1e-1 and 1e-3.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from scipy.integrate import solve_ivp

import lagdsl

MODELS = Path(__file__).parents[2] / "benchmarks" / "models"
GRAVITY = 9.81
STRICT = 1e-3  # allowed error of A02, high precision


def made(name: str, **structural: int) -> lagdsl.Model:
    return lagdsl.compile(MODELS / f"iftomm_{name}.lag", engine="tape", structural=structural)


def uprights(n: int, times: np.ndarray) -> np.ndarray:
    """Angle and rate of all uprights of A02 on the branch on which they stay parallel: a pendulum. (2, times)"""
    inertia, moment = (n + 1) / 3 + n, (n + 1) / 2 + n
    found = solve_ivp(
        lambda _, y: [y[1], -moment * GRAVITY * np.cos(y[0]) / inertia],
        (0.0, times[-1]),
        [np.pi / 2, -1.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
        t_eval=times,
    )
    return np.asarray(found.y)


@pytest.fixture(scope="module")
def row_of_two() -> lagdsl.Model:
    return made("a02", N=2)


def energy_kept(motion: lagdsl.Trajectory) -> float:
    return float(np.ptp(motion.energy) / np.max(np.abs(motion.energy)))


def test_pendulum_falls_as_the_closed_form_says() -> None:
    motion = made("a01").simulate(stop=3.0, tolerance=1e-10)
    by_hand = solve_ivp(
        lambda _, y: [y[1], -GRAVITY * np.cos(y[0])],
        (0.0, 3.0),
        [np.pi, 0.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
        t_eval=motion.time,
    )
    assert np.max(np.abs(motion["theta"] - by_hand.y[0])) < 1e-7


@pytest.mark.parametrize("interval", [1e-3, 0.01, 0.1, 1.0])
def test_a_singular_position_is_crossed_whatever_the_rows(row_of_two: lagdsl.Model, interval: float) -> None:
    """Row A02 of two lies flat at 0.7144 s. With rows 0.1 s apart it was not crossed."""
    motion = row_of_two.simulate(stop=1.0, interval=interval)
    assert np.max(np.abs(motion["up[1]"] - uprights(2, motion.time)[0])) < STRICT
    assert max(np.max(np.abs(motion[f"across[{i}]"])) for i in (1, 2)) < 1e-8
    assert energy_kept(motion) < 1e-6


def test_a_motion_may_end_anywhere_about_a_singular_position(row_of_two: lagdsl.Model) -> None:
    """Up to 2e-4 s behind it no crossing had room before the end, and E0830 said that branches are not told apart."""
    times = np.linspace(0.0, 1.0, 2001)
    flat = float(np.interp(0.0, -uprights(2, times)[0], times))
    for distance in (0.0, 1e-9, 1e-6, 1e-4):
        for stop in (flat - distance, flat + distance):
            motion = row_of_two.simulate(stop=stop, interval=0.1)
            assert motion.time[-1] == stop
            assert abs(float(motion["up[1]"][-1]) - uprights(2, np.array([0.0, stop]))[0, -1]) < 1e-6


@pytest.mark.parametrize("n", chosen([1, 2, 7, 20], [1, 2, 7]))
def test_all_uprights_pass_together(n: int) -> None:
    """As many rows of J as there are four-bars vanish at once."""
    motion = made("a02", N=n).simulate(stop=2.5, interval=0.05)
    angle, rate = uprights(n, motion.time)
    assert angle[-1] < -np.pi
    for i in (1, n + 1):
        assert np.max(np.abs(np.cos(motion[f"up[{i}]"]) - np.cos(angle))) < STRICT
        assert np.max(np.abs(motion[f"der(up[{i}])"] - rate)) < STRICT * np.max(np.abs(rate))
    assert energy_kept(motion) < 1e-6


def test_a_row_with_one_bar_longer_turns_back() -> None:
    """Branches miss each other there: the row does not lie down on the branch of parallel bars."""
    text = (MODELS / "iftomm_a02.lag").read_text(encoding="utf-8")
    text = text.replace("parameter Length l = 1 m;", "parameter Length l = 1 m, e = 0 m;")
    text = text.replace("l*cos(up[i]) + l*cos(across[i]) = ", "l*cos(up[i]) + (l - e)*cos(across[i]) = ")
    motion = lagdsl.compile(text, engine="tape").simulate(stop=1.0, interval=0.05, parameters={"e": 1e-5})
    assert np.max(np.abs(np.cos(motion["up[1]"]) - np.cos(uprights(2, motion.time)[0]))) > STRICT
    assert energy_kept(motion) < 1e-5


def test_bricard_keeps_loop_and_energy_typed_by_hand() -> None:
    """One degree of freedom: where the loop closes and the energy stays, the motion is the right one."""
    motion = made("a04").simulate(stop=3.0, interval=0.02, tolerance=1e-9)
    q = np.array([motion[f"q{i}"] for i in range(1, 6)])
    qd = np.array([motion[f"der(q{i})"] for i in range(1, 6)])
    assert np.ptp(q[0]) > 0.5

    def rods(angles: np.ndarray) -> tuple[list[np.ndarray], list[np.ndarray], np.ndarray, np.ndarray]:
        """Centers and directions of the rods, the end of the last and the axis of its pin."""
        turn, place = np.eye(3, dtype=complex), np.zeros(3, dtype=complex)
        centers, directions = [], []
        for angle, axis, way in zip(angles, (1, 2, 0, 1, 2), (0, 1, 2, 0, 1), strict=True):
            c, s = np.cos(angle), np.sin(angle)
            i, j = (axis + 1) % 3, (axis + 2) % 3
            own = np.eye(3, dtype=complex)
            own[i, i] = own[j, j] = c
            own[i, j], own[j, i] = -s, s
            turn = turn @ own
            along = (1.0 if len(centers) in (0, 2, 4) else -1.0) * turn[:, way]
            centers.append(place + along / 2)
            directions.append(along)
            place = place + along
        return centers, directions, place, turn[:, 0]

    for angles, rates in zip(q.T, qd.T, strict=True):
        step = 1e-30
        centers, directions, end, axis = rods(angles + 1j * step * rates)
        assert np.max(np.abs(end.real - [0.0, 0.0, 1.0])) < 1e-7
        assert np.max(np.abs(axis.real - [1.0, 0.0, 0.0])) < 1e-7
        speeds = sum(float(np.sum((c.imag / step) ** 2)) for c in centers)
        height = sum(float(c.real[1]) for c in centers)
        bending = sum(float(np.sum((d.imag / step) ** 2)) for d in directions) * (1.0 + 0.01) / 12
        spin = _spin(angles, rates)
        assert 0.5 * (speeds + bending + spin * 0.01 / 6) + GRAVITY * height == pytest.approx(-3.0 * GRAVITY, abs=1e-6)


def _spin(angles: np.ndarray, rates: np.ndarray) -> float:
    """Sum of the squares of the rates of the rods about themselves."""
    turn, omega, total = np.eye(3), np.zeros(3), 0.0
    for angle, rate, axis, way in zip(angles, rates, (1, 2, 0, 1, 2), (0, 1, 2, 0, 1), strict=True):
        omega = omega + rate * turn[:, axis]
        c, s = np.cos(angle), np.sin(angle)
        i, j = (axis + 1) % 3, (axis + 2) % 3
        own = np.eye(3)
        own[i, i] = own[j, j] = c
        own[i, j], own[j, i] = -s, s
        turn = turn @ own
        total += float(omega @ turn[:, way]) ** 2
    return total


def test_governor_moves_as_lagranges_equations_typed_by_hand() -> None:
    """By symmetry both arms move alike, and the momentum about the shaft stays."""
    length, width, cube, pin, density = 1.0, 0.01, 0.1, 0.05, 3000.0
    ball, rod, slider = 5.0, density * length * width**2, density * cube**3
    stiffness, damping, rest = 8e5, 4e4, 0.5
    across, along = rod * (length**2 + width**2) / 12, rod * width**2 / 6
    fixed = along + slider * cube**2 / 6
    of_arm = rod * length**2 / 4 + across + ball * length**2

    def about_shaft(a: float) -> tuple[float, float]:
        """Inertia of an arm about the shaft and its derivative."""
        c, s = np.cos(a), np.sin(a)
        bar, far = pin + length / 2 * c, pin + length * c
        value = rod * bar**2 + across * c**2 + along * s**2 + ball * far**2
        return value, -rod * bar * length * s + 2 * (along - across) * c * s - 2 * ball * far * length * s

    momentum = (fixed + 2 * about_shaft(np.radians(30.0))[0]) * 2 * np.pi

    def rates(_: float, y: np.ndarray) -> list[float]:
        a, s, ad, sd = y
        value, slope = about_shaft(a)
        spin = momentum / (fixed + 2 * value)
        x, z = length / 2 * np.cos(a), length - length / 2 * np.sin(a) - s
        long = np.hypot(x, z)
        by_a, by_s = -length / 2 * (x * np.sin(a) + z * np.cos(a)) / long, -z / long
        force = stiffness * (long - rest) + damping * (by_a * ad + by_s * sd)
        weight = (rod * length / 2 + ball * length) * GRAVITY * np.cos(a)
        return [
            ad,
            sd,
            (slope * spin**2 / 2 + weight - force * by_a) / of_arm,
            -GRAVITY - 2 * force * by_s / slider,
        ]

    motion = made("a05").simulate(stop=1.0, interval=0.05, tolerance=1e-7)
    start = [np.radians(30.0), 0.5, 0.0, 0.0]
    by_hand = solve_ivp(rates, (0.0, 1.0), start, method="LSODA", rtol=1e-9, atol=1e-11, t_eval=motion.time)
    assert np.ptp(motion["s"]) > 0.1
    assert np.max(np.abs(motion["s"] - by_hand.y[1])) < 1e-6
    assert np.max(np.abs(motion["a[2]"] - by_hand.y[0])) < 1e-6
