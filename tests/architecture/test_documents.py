"""Examples in documents do what the text says."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

import lagdsl

PAGES = (
    "README.md",
    "docs/reference/language.md",
    "docs/reference/events.md",
    "docs/reference/library.md",
    "docs/explanation/mechanics.md",
    "docs/reference/mechanical_library.md",
    "docs/reference/networks.md",
    "docs/reference/classes.md",
    "docs/reference/assembly.md",
)
LATER = {
    "implicit equations": ("equation 0 = x - 1 m;", "E0322"),
}


@pytest.mark.parametrize("page", PAGES)
def test_models_in_documents_are_sound(root: Path, page: str) -> None:
    for text in re.findall(r"```modelica\n(model .*?)```", (root / page).read_text(encoding="utf-8"), re.DOTALL):
        assert [d.code for d in lagdsl.check(text) if d.severity != "note"] == []


@pytest.mark.parametrize("what", LATER)
def test_what_comes_later_is_answered_with_an_error(root: Path, what: str) -> None:
    item, code = LATER[what]
    text = f"model M coordinate Length x; gravity = 0; mass 1 kg at {{x, 0}}; {item} end M;"
    assert [d.code for d in lagdsl.check(text) if d.severity == "error"] == [code]
    assert (
        what
        in (root / "docs" / "reference" / "language.md").read_text(encoding="utf-8").split("## What comes later")[1]
    )


def test_python_of_the_readme_runs(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "models").symlink_to(root / "models")
    monkeypatch.chdir(tmp_path)
    (code,) = re.findall(r"```python\n(.*?)```", (root / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    names: dict[str, object] = {}
    exec(code, names)
    model, motion = names["model"], names["motion"]
    assert isinstance(model, lagdsl.Model)
    assert isinstance(motion, lagdsl.Trajectory)
    assert motion.time[-1] == 5.0
    assert (tmp_path / "page.html").stat().st_size > 100_000


def test_python_of_the_page_on_events_runs_and_gives_its_numbers(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    page = (root / "docs" / "reference" / "events.md").read_text(encoding="utf-8")
    names: dict[str, Any] = {}
    for code in re.findall(r"```python\n(.*?)```", page, re.DOTALL):
        exec(code, names)
    motion, row = names["motion"], names["row"]
    shown = re.findall(r"# (<Event .*>)", page)
    assert [repr(motion.events[0]), repr(motion.events[-1])] == shown
    assert f"{motion['N'][-1]:.2f} N" in page
    assert "{:.2f} and {:.2f} m/s".format(*motion["der(h)"][row : row + 2]) in page
