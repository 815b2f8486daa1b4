"""Every MJCF file of gymnasium against MuJoCo, where the package is installed or ROBOT_DATA names their folder."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path

import pytest
from choice import spread

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax.printer import format_text

pytest.importorskip("mujoco")

from robots.mujoco_peer import compare_with_mujoco, plan_of_mjcf
from robots.test_terms import errors_of_terms


def _folder() -> Path:
    spec = find_spec("gymnasium")
    if spec is None or spec.origin is None:
        return Path(os.environ.get("ROBOT_DATA", "nowhere"))
    return Path(spec.origin).parent / "envs" / "mujoco" / "assets"


FILES = sorted(_folder().glob("*.xml"))
DRAGGED = "swimmer"


@pytest.mark.parametrize("path", spread(FILES, 2), ids=lambda path: path.stem)
def test_equations_are_those_of_mujoco(path: Path) -> None:
    """The swimmer without the drag of the water, for which it is refused."""
    if path.stem == DRAGGED:
        with pytest.raises(lagdsl.CompilationFailed, match="E1016"):
            lagdsl.import_robot(path)
    lenient = path.stem == DRAGGED
    worst = compare_with_mujoco(path, states=20, lenient=lenient)
    assert max(worst.values()) < 1e-10, worst
    text = lagdsl.import_robot(path, lenient=lenient)
    assert format_text(SourceFile(path.name, text), Sink()) == text
    told = [each.code for each in lagdsl.check(text) if each.severity != "note"]
    assert told == (["W0527"] if path.stem == DRAGGED else [])  # it swims in a horizontal plane


@pytest.mark.parametrize("path", spread(FILES, 2), ids=lambda path: path.stem)
def test_terms_of_equations(path: Path) -> None:
    text = lagdsl.import_robot(path, lenient=path.stem == DRAGGED, actuators="none")
    plan = plan_of_mjcf(path, path.stem == DRAGGED)
    worst = errors_of_terms(lagdsl.compile(text, engine="tape"), plan)
    assert max(worst.values()) < 1e-12, worst
