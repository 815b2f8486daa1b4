"""The models of the benchmarks: sound, and the physics that the peers are given."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import spread

import lagdsl

NAMES = (
    "balls",
    "beam",
    "drive",
    "elastic_slider_crank",
    "four_bars",
    "furuta_motor",
    "grid",
    "iftomm_a01",
    "iftomm_a02",
    "iftomm_a04",
    "iftomm_a05",
    "ladder",
    "masses",
    "nbody",
    "net",
    "oscillators",
    "panda",
    "panda_scalars",
    "planar_chain",
    "reissner",
    "resting",
    "spatial_chain",
    "stack",
    "stiff_oscillator",
    "stiff_slider_crank",
)


def test_every_model_is_sound(root: Path) -> None:
    folder = root / "benchmarks" / "models"
    assert {path.stem for path in folder.glob("*.lag")} == set(NAMES)
    for name in spread(NAMES, 6):
        assert [d for d in lagdsl.check(folder / f"{name}.lag") if d.severity != "note"] == []


def test_the_drive_keeps_its_speed(root: Path) -> None:
    """The integral part of the PID leaves no error on average, over whole turns of the crank."""
    motion = lagdsl.compile(root / "benchmarks" / "models" / "drive.lag").simulate()
    q = np.interp([5.0 - 4.0 * 2.0 * np.pi / 15.0, 5.0], motion.time, motion["main.q"])
    assert q[1] - q[0] == pytest.approx(8.0 * np.pi, rel=2e-3)
    assert np.max(np.abs(motion["pid.y"])) <= 48.0


def test_the_arm_is_the_same_in_components_and_in_scalars(root: Path) -> None:
    folder = root / "benchmarks" / "models"
    arm, scalars = (lagdsl.compile(folder / f"{name}.lag") for name in ("panda", "panda_scalars"))
    q, qd = np.random.default_rng(1).uniform(-1, 1, (2, 20, 7))
    np.testing.assert_allclose(arm.mass_matrix(0.0, q), scalars.mass_matrix(0.0, q), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(arm.batch(0.0, q, qd), scalars.batch(0.0, q, qd), rtol=1e-9)
    assert float(arm.energy(0.0, np.zeros(7), np.zeros(7))) == pytest.approx(
        float(scalars.energy(0.0, np.zeros(7), np.zeros(7)))
    )


def _chain_matrix(n: int, m: float, length: float, absolute: np.ndarray) -> np.ndarray:
    """Textbook: mass matrix of N uniform bars in absolute angles."""
    i = np.arange(n)
    outer = np.maximum.outer(i, i)
    beyond = (n - 1 - outer) + 0.5
    beyond[i, i] = (n - 1 - i) + 1 / 3
    return m * length**2 * beyond * np.cos(absolute[:, None] - absolute[None, :])


def test_the_planar_chain(root: Path) -> None:
    n = 6
    model = lagdsl.compile(root / "benchmarks" / "models" / "planar_chain.lag", structural={"N": n})
    q, qd = np.random.default_rng(2).uniform(-1, 1, (2, n))
    angle, turn, i = np.cumsum(q), np.cumsum(qd), np.arange(n)
    slope = np.tril(np.ones((n, n)))  # absolute angles by relative ones
    matrix = _chain_matrix(n, 1.3, 0.7, angle)
    np.testing.assert_allclose(model.mass_matrix(0.0, q), slope.T @ matrix @ slope, rtol=1e-12)
    sines = _chain_matrix(n, 1.3, 0.7, angle) * np.tan(angle[:, None] - angle[None, :])
    force = -sines @ turn**2 - 1.3 * 9.81 * 0.7 * ((n - 1 - i) + 0.5) * np.sin(angle)
    expected = np.diff(np.linalg.solve(matrix, force), prepend=0.0)
    np.testing.assert_allclose(model.forward_dynamics(0.0, q, qd), expected, rtol=1e-9)


def test_the_beam_has_a_dense_mass_matrix(root: Path) -> None:
    n = 5
    model = lagdsl.compile(root / "benchmarks" / "models" / "beam.lag", structural={"N": n})
    q = np.random.default_rng(3).uniform(-1, 1, n)
    np.testing.assert_allclose(model.mass_matrix(0.0, q), _chain_matrix(n, 1.2 / n, 2.0 / n, q), rtol=1e-12)
