"""`lag sweep`."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from choice import spread
from click.testing import Result

pytest.importorskip("xarray")
Invoke = Callable[..., Result]
SHORT = ("--stop", "0.2", "--interval", "0.1", "--jobs", "1")


def _read(path: Path):
    import xarray

    with xarray.open_dataset(path) as data:
        return data.load()


@pytest.mark.parametrize(
    ("text", "expected"),
    spread(
        [
            ("l=0.1:0.1:0.5 m", [0.1, 0.2, 0.3, 0.4, 0.5]),
            ("l=10:20:60 cm", [0.1, 0.3, 0.5]),
            ("l=1 : -0.25 : 0.5", [1, 0.75, 0.5]),
            ("l=1, 2, 5 m", [1, 2, 5]),
            ("l=1 m, 50 cm", [1, 0.5]),
            ("l=7 mm", 0.007),
            ("theta.start=-10, 10 deg", [-np.pi / 18, np.pi / 18]),
            ("der(theta).start=1,2", [1, 2]),
        ],
        5,
    ),
)
def test_values(invoke: Invoke, pendulum: Path, tmp_path: Path, text: str, expected: object) -> None:
    out = tmp_path / "out.nc"
    result = invoke("sweep", pendulum, "--set", text, *SHORT, "-o", out)
    assert result.exit_code == 0, result.stderr
    np.testing.assert_allclose(_read(out)[text.partition("=")[0]].values, expected, rtol=1e-15)


def test_every_combination_is_a_run(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.nc"
    result = invoke("sweep", pendulum, "--set", "l=0.5,1 m", "--set", "theta.start=0:1:2 deg", *SHORT, "-o", out)
    assert result.exit_code == 0, result.stderr
    data = _read(out)
    assert data["theta"].dims == ("l", "theta.start", "time")
    expected = np.deg2rad([0, 1, 2]) * np.cos(np.sqrt(9.81 / np.array([[0.5], [1]])) * 0.2)
    np.testing.assert_allclose(data["theta"].values[:, :, -1], expected, atol=1e-5)
    assert data["theta.start"].attrs["units"] == "rad"


def test_draws(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    drawn = []
    for seed in (1, 1, 2):
        out = tmp_path / "out.nc"
        sets = ("--set", "l=uniform(40, 60) cm", "--set", "theta.start=normal(0, 5) deg", "--set", "m=1,2")
        result = invoke("sweep", pendulum, *sets, "--random", "30", "--seed", seed, *SHORT, "-o", out)
        assert result.exit_code == 0, result.stderr
        data = _read(out)
        assert data["theta"].shape == (2, 30, 3)
        assert ((data["l"] >= 0.4) & (data["l"] <= 0.6)).all()
        drawn.append(data["theta.start"].values)
    np.testing.assert_array_equal(drawn[0], drawn[1])
    assert (drawn[0] != drawn[2]).all()
    assert 0.3 < np.std(np.rad2deg(drawn[0])) / 5 < 3


@pytest.mark.parametrize(
    ("text", "low", "middle", "high"),
    [("m=lognormal(2, 0.1) kg", 1.2, 2, 3.3), ("m=triangular(1, 2, 3) kg", 1, 2, 3), ("m=normal(2, 0)", 2, 2, 2)],
)
def test_distributions(
    invoke: Invoke, pendulum: Path, tmp_path: Path, text: str, low: float, middle: float, high: float
) -> None:
    out = tmp_path / "out.nc"
    assert invoke("sweep", pendulum, "--set", text, "--random", "100", *SHORT, "-o", out).exit_code == 0
    values = _read(out)["m"].values
    assert values.min() >= low
    assert values.max() <= high
    assert np.median(values) == pytest.approx(middle, rel=0.1)


@pytest.mark.parametrize(
    ("arguments", "words"),
    spread(
        [
            (("--set", "l=1:2"), "first:step:last"),
            (("--set", "l=1:0:2"), "do not lead"),
            (("--set", "l=2:1:1"), "do not lead"),
            (("--set", "l=1 m:1 cm:2 m"), "one unit"),
            (("--set", "l=0:1e-9:1"), "1e+09 runs, at most 1000000 are possible"),
            (("--set", "l=1:1e-300:2"), "1e+300 runs"),
            (("--set", "l=1:1e-308:1e308"), "runs, at most 1000000 are possible"),
            (("--set", "l=1:1e-999:1e999"), "1e999 is too large for a number"),
            (("--set", "l=linspace(0, 1e999, 3) m"), "1e999 is too large for a number"),
            (("--set", "l=1:1e-999999999:2"), "unit"),
            (("--set", "l=linspace(0, 1e999999999, 3)"), "unit"),
            (("--set", "l=1:1:2000", "--set", "m=1:1:2000"), "4e+06 runs"),
            (("--set", "l=normal(1, 2)", "--random", "10000000000000"), "1e+13 runs"),
            (("--set", "l=linspace(1, 2)"), "linspace(first, last, count)"),
            (("--set", "l=1,2", "--resume"), "give the file with -o"),
            (("--set", "l=1:1:1000", "--stop", "1e4", "--interval", "1e-3"), "fewer rows"),
            (("--set", "l=1 kg, 2 kg"), "this is a mass"),
            (("--set", "theta.stat=1, 2"), "did you mean `theta.start`"),
            (("--set", "l=1, 1 m"), "same value twice"),
            (("--set", "l=1, x"), "expected a number"),
            (("--set", "l=normal(1, 2)"), "give the number of draws"),
            (("--random", "3"), "needs a distribution"),
            (("--random", "3", "--set", "l=gamma(1)"), "there are the distributions"),
            (("--random", "3", "--set", "l=normal(1)"), "takes mean, deviation"),
            (("--random", "3", "--set", "l=uniform(2, 1)"), "from the lowest"),
            (("--random", "3", "--set", "l=normal(1, -1)"), "not negative"),
            (("--random", "3", "--set", "l=normal(1, a)"), "must be a number"),
            (("--set", "l=1,2", "--column", "thet"), "did you mean `theta`"),
            (("--set", "l=1,2", "-o", "x.txt"), ".nc, .parquet, .csv"),
            (("--set", "l=1,2", "--stop", "-1"), "after the start"),
        ],
        15,
    ),
)
def test_wrong_usage(invoke: Invoke, pendulum: Path, arguments: tuple[str, ...], words: str) -> None:
    result = invoke("sweep", pendulum, *arguments)
    assert result.exit_code == 2, result.output
    assert words in result.stderr


def test_a_summary_without_an_output(invoke: Invoke, pendulum: Path) -> None:
    result = invoke("sweep", pendulum, "--set", "l=1,2,3 m", *SHORT)
    assert result.exit_code == 0
    assert "Pendulum: 3 runs" in result.stdout
    assert "Pendulum: 1 run\n" in invoke("sweep", pendulum, *SHORT).stdout
    assert "der(theta)" in result.stdout


def test_failures_are_told_and_no_reason_to_stop(invoke: Invoke, failing: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.nc"
    result = invoke("sweep", failing, "--set", "h.start=1, 10 m", *SHORT, "-o", out)
    assert result.exit_code == 0
    assert "1 of 2 runs failed" in result.stderr
    assert "on the floor (at h.start = 1 m)" in result.stderr
    assert list(_read(out)["status"].values) == ["failed", "ok"]
    assert invoke("sweep", failing, "--set", "h.start=0.95, 1 m", *SHORT).exit_code == 3


def test_structural_parameters(invoke: Invoke, root: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.nc"
    result = invoke("sweep", root / "models" / "chain.lag", "--set", "N=1:1:3", *SHORT, "-o", out)
    assert result.exit_code == 0, result.stderr
    data = _read(out)
    assert data["q[1]"].notnull().all()
    np.testing.assert_array_equal(data["q[3]"].isnull().any("time").values, [True, True, False])


def test_an_interrupt_leaves_what_can_be_resumed(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.nc"
    kept = tmp_path / "out.nc.partial"
    command = ["sweep", pendulum, "--set", "l=0.1:0.01:3 m", "--stop", "20", "-o", out]
    started = [sys.executable, "-m", "lagdsl", *command, "--jobs", "2"]
    first = subprocess.Popen(started, stderr=subprocess.PIPE, text=True, env={**os.environ})
    deadline = time.monotonic() + 60
    while not (kept.exists() and kept.stat().st_size > 200) and time.monotonic() < deadline:
        time.sleep(0.02)
    first.send_signal(signal.SIGINT)
    _, told = first.communicate(timeout=60)
    assert first.returncode == 130, told
    assert "--resume" in told
    assert not out.exists()
    finished = kept.stat().st_size
    assert finished > 200
    again = invoke(*command, "--jobs", "1")
    assert again.exit_code == 2
    assert "resume it" in again.stderr
    assert invoke(*command, "--resume", "--jobs", "1").exit_code == 0
    assert not kept.exists()
    assert (_read(out)["status"] == "ok").all()


_CHAIN = """
model Chain
  structural parameter Integer N = 2;
  parameter Length l[N] = fill(1 m, N);
  coordinate Angle q[N](each start = 0.1 rad);
  for i in 1:N loop
    kinetic 1/2*(1 kg)*l[i]^2*der(q[i])^2;
    potential 1 kg*g_n*l[i]*(1 - cos(q[i]));
  end for;
end Chain;
"""


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (("N=4", "q[4].start=1 rad"), "1 run\n"),
        (("N=3", "l={1, 2, 3} m"), "1 run\n"),
        (("N=3", "l[3]=1, 2 m"), "2 runs\n"),
        (("N=2, 4", "q[4].start=1 rad"), "1 of 2 runs failed: E0805: there is no start value `q[4]` (at N = 2)"),
        (("N=1, 2", "l={1, 2} m"), "1 of 2 runs failed: there is no parameter `l[2]` (at N = 1)"),
        (("N=0, 2", "l[2]=1 m"), "1 of 2 runs failed: E0334: the size of `l` must be positive, found 0 (at N = 0)"),
    ],
)
def test_names_of_the_structures_that_are_asked_for(
    invoke: Invoke, tmp_path: Path, settings: tuple[str, ...], words: str
) -> None:
    """They were looked up in the structure of the text."""
    (tmp_path / "chain.lag").write_text(_CHAIN)
    given = [each for setting in settings for each in ("--set", setting)]
    found = invoke("sweep", tmp_path / "chain.lag", *given, "--stop", "0.02", "--jobs", "1")
    assert found.exit_code == 0 and words in found.output + found.stderr
