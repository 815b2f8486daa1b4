"""The pages on FMUs run and give the numbers that they show; the table of options is that of the command."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.linalg
from choice import ALL

from lagdsl.engines.runtime.building.platforms import PLATFORMS
from lagdsl.interfaces.cli.commands.fmu import command

PAGES = ("export_fmu", "cosimulate")


@pytest.mark.skipif(not ALL, reason="compiles the FMUs of two pages: make check-all")
def test_python_of_the_page_runs_and_gives_its_numbers(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = "".join((root / "docs" / "howto" / f"{name}.md").read_text(encoding="utf-8") for name in PAGES)
    (tmp_path / "models").symlink_to(root / "models")
    monkeypatch.chdir(tmp_path)
    found: dict[str, Any] = {}
    for code in re.findall(r"```python\n(.*?)```", page, re.DOTALL):
        exec(code, found)

    assert abs(found["difference"]) < 1e-8
    energy = found["motion"]["energy.total"]
    assert np.ptp(energy) < 1e-8 * np.max(np.abs(energy))
    assert abs(found["exchanged"]["a"][-1] - found["again"]["a"][-1]) < 1e-7
    # with other parameters it is another motion
    assert abs(found["again"]["a"][-1] - found["ours"]["a"][-1]) > 1e-2

    errors = [abs(found[name] - _place(5.0)) for name in ("coarse", "fine")]
    assert "errors {:.1e} m and {:.1e} m".format(*errors).replace("e-0", "e-") in page
    assert errors[0] / errors[1] == pytest.approx(4.0, abs=0.3)


def _place(t: float) -> float:
    """Of the lower of two masses: M x'' + K x = 0 from rest, by its modes."""
    mass, stiffness = np.diag([2.0, 1.0]), np.array([[250.0, -50.0], [-50.0, 50.0]])
    squares, shapes = scipy.linalg.eigh(stiffness, mass)
    return float((shapes @ (np.linalg.solve(shapes, [0.1, 0.0]) * np.cos(np.sqrt(squares) * t)))[0])


def test_the_page_tells_every_option(root: Path) -> None:
    page = (root / "docs" / "howto" / "export_fmu.md").read_text(encoding="utf-8")
    table = page.split("| option | |")[1].split("\n\n")[0]
    own = {option for parameter in command.params for option in parameter.opts if option.startswith("--")}
    assert set(re.findall(r"`(--[a-z][a-z-]*)", table)) == own - {"--model", "--format"}
    assert all(f"`{name}`" in table for name in PLATFORMS)
