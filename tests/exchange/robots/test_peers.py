"""Every URDF file of example-robot-data against Pinocchio, where both are installed (packages pin, example-robot-data).

`lag import` takes a file, or docs/howto/import_a_robot.md has the reason for which it does not; then a lenient import
is compared.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from choice import spread

import lagdsl

pinocchio = pytest.importorskip("pinocchio")

from robots.peers import compare_with_pinocchio, plan_of  # noqa: E402 after the package that it needs
from robots.test_terms import errors_of_terms  # noqa: E402

DATA = [Path(place) for place in (*sys.path, os.environ.get("ROBOT_DATA", ""), str(Path(sys.prefix) / "share"))]
PLACES = ("cmeel.prefix/share/example-robot-data/robots", "example-robot-data/robots")
FOLDERS = [place / rest for place in DATA for rest in PLACES]
ROBOTS = next((folder for folder in FOLDERS if folder.is_dir()), Path("nowhere"))
FILES = sorted(path.relative_to(ROBOTS).as_posix() for path in ROBOTS.glob("*/*/*.urdf"))
NEVER = ("quadrotor_base", "iris_simple", "ur3")  # nothing moves, or there is no link
PAGE = Path(__file__).parents[3] / "docs" / "howto" / "import_a_robot.md"


@pytest.mark.parametrize("name", spread([name for name in FILES if Path(name).stem not in NEVER], 12))
def test_equations_are_those_of_pinocchio(name: str) -> None:
    path = ROBOTS / name
    try:
        lagdsl.import_robot(path)
        lenient = False
    except lagdsl.CompilationFailed as refused:
        assert Path(name).stem in PAGE.read_text(encoding="utf-8"), refused
        lenient = True
    worst = compare_with_pinocchio(path, lenient, states=20)
    assert max(worst.values()) < 1e-10, worst


@pytest.mark.parametrize("name", spread([name for name in FILES if Path(name).stem not in NEVER], 12))
def test_terms_of_equations(name: str) -> None:
    """Energies of moments that no body has, of which a lenient import makes statements, have no inertial parameters."""
    path = ROBOTS / name
    refused = False
    try:
        text = lagdsl.import_robot(path, actuators="none")
    except lagdsl.CompilationFailed:
        refused, text = True, lagdsl.import_robot(path, lenient=True, actuators="none")
    worst = errors_of_terms(lagdsl.compile(text, engine="tape"), plan_of(path, refused))
    regressor = worst.pop("regressor")
    assert refused or regressor < 1e-12, regressor
    assert max(worst.values()) < 1e-12, worst


@pytest.mark.parametrize("name", [name for name in FILES if Path(name).stem in NEVER])
def test_robots_that_never_move_are_refused(name: str) -> None:
    with pytest.raises(lagdsl.CompilationFailed, match=r"E1018|E1005"):
        lagdsl.import_robot(ROBOTS / name, lenient=True)
