"""Budgets of the C runtime: numbers that may go down, and do not go up without a reason."""

from __future__ import annotations

import re
from pathlib import Path

import lagdsl

ROOT = Path(lagdsl.__file__).parent
RUNTIME, SHELL = ROOT / "runtime" / "c" / "lag", ROOT / "fmi" / "c" / "lag"
CONSTANT = re.compile(r"^static const double ", re.MULTILINE)
# Events, contacts with friction, impulses, and the scan.
HYBRID = ("events", "contacts", "impulses")
SCAN = ("run_scan", "run_instants", "run_zero_crossings", "run_corners", "scan")
SINGULAR = ("singular_crossing", "collocation")


def _sources(*folders: Path) -> list[Path]:
    return [path for folder in folders for path in sorted(folder.rglob("*.[ch]"))]


def _lines(paths: list[Path]) -> int:
    return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in paths)


def test_few_constants_have_names() -> None:
    texts = [path.read_text(encoding="utf-8") for path in _sources(RUNTIME, SHELL)]
    assert sum(len(CONSTANT.findall(text)) for text in texts) <= 273


def test_the_hybrid_model_is_no_longer() -> None:
    scan = [path for path in _sources(RUNTIME / "run") if path.stem in SCAN]
    assert len(scan) == 5
    assert _lines([*_sources(*(RUNTIME / folder for folder in HYBRID)), *scan]) <= 8162


def test_crossings_of_singular_positions_are_short() -> None:
    found = [path for path in _sources(RUNTIME / "run") if path.stem in SINGULAR]
    assert len(found) == 3
    assert _lines(found) <= 600


def test_an_instance_of_an_fmu_is_short() -> None:
    assert _lines(_sources(SHELL / "instance")) <= 2826
