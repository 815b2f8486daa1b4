"""The benchmarks' own part: what is compared with, and the page that is written."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import lagdsl


@pytest.fixture
def folder(root: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """benchmarks/ on the path of modules, whose names are forgotten afterwards."""
    folder = root / "benchmarks"
    known = set(sys.modules)
    monkeypatch.syspath_prepend(str(folder))
    monkeypatch.setenv("PEERS", str(folder / "nothing"))
    yield folder
    for name in set(sys.modules) - known:
        if (folder / f"{name}.py").exists():
            del sys.modules[name]


@pytest.mark.parametrize("name", ["panda", "panda_scalars", "planar_chain", "spatial_chain"])
def test_arms_move_as_their_oracle_says(folder: Path, name: str) -> None:
    import oracle
    import serial

    n = 7 if name.startswith("panda") else 6
    model = lagdsl.compile(folder / "models" / f"{name}.lag", structural={} if n == 7 else {"N": n})
    states = serial.wide_states(n, 20)
    exact = oracle.serial_arm(serial.ARMS[name](n), states)
    assert np.max(oracle.error(model.batch(0.0, states[:, :n], states[:, n:]), exact)) < 1e-11


@pytest.mark.parametrize(("name", "size", "width"), [("beam", 5, 5), ("four_bars", 3, 9)])
def test_planar_models_move_as_their_oracle_says(folder: Path, name: str, size: int, width: int) -> None:
    import oracle
    import planar
    import serial

    model = lagdsl.compile(folder / "models" / f"{name}.lag", structural={"N": size})
    states = planar.four_bar_states(size, 20) if name == "four_bars" else serial.wide_states(width, 20)
    exact = getattr(planar, name)(states)
    assert np.max(oracle.error(model.batch(0.0, states[:, :width], states[:, width:]), exact)) < 1e-11


def test_derivatives_of_the_oracle(folder: Path) -> None:
    import oracle
    import serial

    arm, states = serial.spatial_chain(3), serial.states(3, 4)
    jacobian = oracle.serial_arm_jacobian(arm, states).reshape(4, 3, 6)
    step = 1e-6 * np.eye(6)[1]
    slope = (oracle.serial_arm(arm, states + step) - oracle.serial_arm(arm, states - step)) / 2e-6
    np.testing.assert_allclose(jacobian[:, :, 1].astype(float), slope.astype(float), rtol=1e-7, atol=1e-7)


def test_without_results_there_is_a_page_without_figures(folder: Path) -> None:
    import pages

    page = pages.page({})
    assert "Nothing has been measured" in page
    assert "**missed**" not in page


def test_the_page_is_what_the_results_say(folder: Path) -> None:
    import pages

    found = {path.stem: json.loads(path.read_text()) for path in sorted((folder / "results").glob("*.json"))}
    assert (folder / "README.md").read_text(encoding="utf-8") == pages.page(found)


def test_without_peers_they_are_named(folder: Path) -> None:
    import machine
    import pages
    import peers

    assert peers.missing() == ["pinocchio", "mujoco", "casadi"]
    part = {**machine.describe(), "load after": 0.0, "rows": [], "casadi": None, "runs": 1}
    assert "Not installed, and left out: pinocchio, mujoco, casadi" in pages.page({"text": part})


def test_targets_know_when_they_are_reached(folder: Path) -> None:
    from targets import Target, table

    def target(*measured: float | None) -> Target:
        return Target("x", (2, 2), (1, 1), measured, "text")

    assert target(0.5, 1).reached == "stretch"
    assert target(0.5, 1.5).reached == "must"
    assert target(0.5, 2.5).reached == "**missed**"
    assert target(0.5, None).reached == ""
    assert table([target(0.5, None)])[-1] == "| x | 2 / 2 | 1 / 1 | 0.50 / - |  |"


def test_exponents_are_slopes_of_at_least_four_sizes(folder: Path) -> None:
    from growth import exponent

    points: list[dict[str, object]] = [{"n": n, "python": 3.0 * n**1.5} for n in (5, 10, 20, 40)]
    assert exponent(points, "python") == pytest.approx(1.5)
    assert exponent(points[:3], "python") is None
