"""Several FMUs in one process know nothing of each other, be they of two versions or of one, with names in common."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from fmi.exported import Exported, exported

HOST = Path(__file__).with_name("together.py")


def run(*fmus: Exported) -> list[list[list[str]]]:
    command = [sys.executable, str(HOST), *(str(fmu.folder) for fmu in fmus)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: list[list[list[str]]] = json.loads(done.stdout)
    return found


def test_two_versions_and_two_models_at_once_move_as_each_of_them_alone() -> None:
    fmus = [
        exported("double_pendulum", 2),
        exported("double_pendulum", 3),
        exported("bouncing_ball_modelica", 2),
        exported("bouncing_ball_modelica", 3),
    ]
    alone = [run(fmu)[0] for fmu in fmus]
    assert run(*fmus) == alone
    assert run(*reversed(fmus)) == alone[::-1]
    assert alone[0] != alone[2]


def test_the_same_model_moves_alike_in_both_versions() -> None:
    """The same instance is in both: the same numbers, up to the order of variables."""
    two, three = (exported("double_pendulum", version) for version in (2, 3))
    names = [
        [v.name for v in fmu.description.modelVariables if v.type in ("Real", "Float64") and not v.dimensions]
        for fmu in (two, three)
    ]
    rows = [
        dict(zip(listed, found[-1], strict=True))
        for listed, (found,) in zip(names, (run(two), run(three)), strict=True)
    ]
    common = rows[0].keys() & rows[1].keys()
    assert len(common) > 4
    assert {name: rows[0][name] for name in common} == {name: rows[1][name] for name in common}
