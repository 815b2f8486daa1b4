"""`lag sweep --input`: values, draws and files of inputs as axes. A force f pushes a mass of 1 kg: x = f*t^2/2."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import Result

pytest.importorskip("xarray")
Invoke = Callable[..., Result]
SHORT = ("--stop", "2", "--interval", "1", "--jobs", "1")
TEXT = """model Pushed
  input Force f; input Force g = 0;
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  force f + g on x;
end Pushed;
"""


@pytest.fixture
def pushed(tmp_path: Path) -> Path:
    (tmp_path / "pushed.lag").write_text(TEXT, encoding="utf-8")
    for name, text in {
        "a.csv": "time [ms],f [kN]\n0,0.001\n2000,0.001\n",
        "b.csv": "time,f\n0,0\n2,6\n",
        "g.csv": "time,g\n0,1\n2,1\n",
        "h.csv": "time,g\n0,2\n2,2\n",
    }.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path / "pushed.lag"


def _ends(invoke: Invoke, pushed: Path, *given: str) -> tuple[tuple[str, ...], np.ndarray]:
    import xarray

    arguments = [each for text in given for each in ("--input", text)]
    result = invoke("sweep", pushed, *arguments, *SHORT, "-o", pushed.with_name("out.nc"))
    assert result.exit_code == 0 and "N0875" not in result.stderr, result.stderr
    with xarray.open_dataset(pushed.with_name("out.nc")) as data:
        loaded = data.load()
    return tuple(map(str, loaded["x"].dims)), loaded["x"].values[..., -1]


def test_values(invoke: Invoke, pushed: Path) -> None:
    dims, ends = _ends(invoke, pushed, "f=1, 2, 3 N", "g=0:0.5:1 N")
    assert dims == ("f", "g", "time")
    np.testing.assert_allclose(ends, 2 * (np.array([[1], [2], [3]]) + np.array([0, 0.5, 1])), rtol=1e-9)
    dims, ends = _ends(invoke, pushed, "f=2 N")
    assert dims == ("time",) and ends == pytest.approx(4)


def test_files(invoke: Invoke, pushed: Path) -> None:
    folder = pushed.parent
    dims, ends = _ends(invoke, pushed, f"{folder}/[ab].csv", "g=1 N")
    assert dims == ("input", "time")
    np.testing.assert_allclose(ends, [2 + 2, 4 + 2], rtol=1e-6)
    dims, ends = _ends(invoke, pushed, f"{folder}/[ab].csv", f"{folder}/[gh].csv")
    assert dims == ("input[1]", "input[2]", "time")
    np.testing.assert_allclose(ends, [[4, 6], [6, 8]], rtol=1e-6)


def test_draws_do_not_depend_on_others(invoke: Invoke, pushed: Path) -> None:
    from lagdsl.foundation.diagnostics import Sink
    from lagdsl.foundation.source import SourceFile
    from lagdsl.motion.pipeline import flatten_file
    from lagdsl.motion.sweep.values import plan

    flat = flatten_file(SourceFile("pushed.lag", TEXT), Sink())
    assert flat is not None

    def draws(**inputs: str) -> tuple[float, ...]:
        found = plan([flat], {}, 2000, 7, Sink(), inputs).samples
        return next(axis.values for axis in found if axis.name == "f")

    alone = draws(f="normal(3, 0.5) N")
    assert np.mean(alone) == pytest.approx(3, abs=0.05) and np.std(alone) == pytest.approx(0.5, abs=0.03)
    assert draws(f="normal(3, 0.5) N", g="uniform(0, 1) N") == alone


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (["ff=1, 2 N"], "has no input `ff`; inputs: f, g"),
        (["f=1, 2 kg"], "is a force"),
        (["f=1, 1 N"], "same value twice"),
        (["f=normal(1, 2) N"], "--random N"),
        (["{}/q*.csv"], "no file matches this pattern"),
        (["{}/[ag].csv"], "all files need the same columns"),
        (["{}/[ab].csv", "f=1, 2 N"], "`f` is given twice"),
        (["{}/a.csv", "{}/[ab].csv"], "`f` is given twice"),
    ],
)
def test_what_does_not_fit(invoke: Invoke, pushed: Path, given: list[str], words: str) -> None:
    arguments = [each for text in given for each in ("--input", text.format(pushed.parent))]
    result = invoke("sweep", pushed, *arguments, *SHORT)
    assert result.exit_code == 2 and words in result.stderr.replace("\n", " "), result.stderr


def test_pictures_and_pages(invoke: Invoke, pushed: Path) -> None:
    """Pages show the recorded motions: the sliders of inputs would be those of one run."""
    page, plot = pushed.with_name("runs.html"), pushed.with_name("runs.svg")
    arguments = ("--input", f"{pushed.parent}/[ab].csv", "--page", page, "--plot", plot)
    result = invoke("sweep", pushed, *arguments, *SHORT)
    assert result.exit_code == 0, result.stderr
    text = page.read_text(encoding="utf-8").replace(" ", "")
    assert '"live":false' in text and "input=a.csv" in text and "a.csv" in plot.read_text(encoding="utf-8")
    result = invoke("sweep", pushed, "--input", "f=1 N", "--page", page, *SHORT)
    assert result.exit_code == 0 and '"live":true' in page.read_text(encoding="utf-8").replace(" ", "")
