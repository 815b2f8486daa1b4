"""Every problem has its parts in one order, a picture and a line of the index; its closed form is compared with a run.

The comparison is Python of the page, which tests/docs/test_examples_of_pages.py runs.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "docs" / "problems"
INDEX = (FOLDER / "index.md").read_text(encoding="utf-8")
NAMES = re.findall(r"^\| \d+ \| \[[^\]]+\]\((\w+)\.md\)", INDEX, re.MULTILINE)
PARTS = ["![", "**Find** ", "<details><summary>Hint", "## Model", "## Derivation", "## Closed form", "## Run"]


def test_the_index_lists_every_problem_in_the_order_of_the_sidebar() -> None:
    assert sorted(NAMES) == sorted(path.stem for path in FOLDER.glob("*.md") if path.stem != "index")
    assert INDEX.partition(":hidden:\n\n")[2].split()[:-1] == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_a_problem_is_complete(name: str) -> None:
    text = (FOLDER / f"{name}.md").read_text(encoding="utf-8")
    number, title = NAMES.index(name) + 1, text.partition("\n")[0]
    assert f"| {number} | [{title.removeprefix(f'# {number}. ')}]({name}.md) |" in INDEX
    places = [text.index(part) for part in PARTS]
    assert places == sorted(places)
    assert (FOLDER / f"../images/problems/{name}.png").is_file()
    assert f"](../images/problems/{name}.png)" in text
    assert f"`lag run {name}.lag --png {name}.png --at " in text


@pytest.mark.parametrize("name", NAMES)
def test_a_page_derives_runs_and_compares(name: str) -> None:
    text = (FOLDER / f"{name}.md").read_text(encoding="utf-8")
    derivation, _, run = text.partition("## Closed form")
    assert f"```console\n$ lag derive {name}.lag\nDerivation of the equations of motion" in derivation
    assert re.search(rf"^\$ lag (run|modes) {name}\.lag", run, re.MULTILINE)
    [code] = re.findall(r"^```python\n(.*?)^```$", run, re.DOTALL | re.MULTILINE)
    assert re.search(r"^ *assert .*(< \d[\d.]*e-\d+|rtol=)", code, re.MULTILINE)
