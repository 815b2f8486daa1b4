"""`lag import`: the text in a file or on standard output; nothing at all where a line is wrong."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagdsl.interfaces.cli.main import lag
from robots.imported import ARM, FILES


def run(*arguments: object):
    return CliRunner().invoke(lag, ["import", *map(str, arguments)])


def test_the_text_goes_to_a_file_or_to_standard_output(tmp_path: Path) -> None:
    done = run(ARM, "-o", tmp_path / "arm.lag")
    assert done.exit_code == 0 and done.stdout == ""
    text = (tmp_path / "arm.lag").read_text(encoding="utf-8")
    assert text == (FILES / "arm.lag").read_text(encoding="utf-8")
    assert run(ARM).stdout == text


def test_options_choose_what_is_written() -> None:
    text = run(FILES / "floater.urdf", "--floating", "--actuators", "all").stdout
    assert "FreeQuaternion floating_base;" in text and "input Torque tau_hinge;" in text
    assert "contact lift_lower:" in run(FILES / "slide.urdf", "--limits", "contact").stdout


def test_nothing_is_written_where_a_line_is_wrong(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(ARM.read_text().replace('<mass value="4"/>', '<mass value="-4"/>'))
    done = run(path, "-o", tmp_path / "arm.lag", "--format", "json")
    assert done.exit_code == 1 and not (tmp_path / "arm.lag").exists()
    (error,) = [each for each in json.loads(done.stderr) if each["severity"] == "error"]
    assert error["code"] == "E1011"
    done = run(path, "-o", tmp_path / "arm.lag", "--lenient")
    assert done.exit_code == 0 and (tmp_path / "arm.lag").exists()
    assert "warning[E1011]" in done.stderr and "without mass and inertia" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ((ARM, "-o", "arm.txt"), "models are written as .lag"),
        ((ARM, "--limits", "stop"), "'stop' is not one of"),
        ((), "Missing argument 'FILE'"),
        ((ARM, "-floating"), "options have two dashes"),
    ],
)
def test_wrong_usage_is_told(arguments: tuple[object, ...], reason: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2 and reason in done.stderr


def test_mjcf_without_mujoco_tells_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    path = tmp_path / "robot.xml"
    path.write_text("<mujoco/>")
    done = run(path)
    assert done.exit_code == 1 and "E1014" in done.stderr and "pip install mujoco" in done.stderr
