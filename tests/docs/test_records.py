"""Records of decisions: few, by subject, of one form; every reference to a record names one that exists."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "docs" / "adr"
MOST_RECORDS, MOST_WORDS = 40, 18_000
SECTIONS = ["Decision", "Reasons", "Tried", "Consequences"]
CLAUSE = re.compile(
    r"(?:^|(?<=[.:;!?] )|(?<=- )|(?<=\*\*))(?:What|Whether|Those|Which|Who|Whatever)\b[^\n]*", re.MULTILINE
)

# `docs/adr/0005-components-and-loops.md`, `docs/adr/0005`, `adr/0005`, `(0005-components-and-loops.md)`
PATH = re.compile(r"(?:\badr/|\]\()([0-9]{4})((?:-[a-z0-9-]+)?(?:\.md)?)")
# `ADR 5`, `record 5`, `decision 5`, and lists of them
WORDS = re.compile(r"\b(?:ADR|[Rr]ecord|[Dd]ecision)s? ((?:[0-9]{1,4}(?:, | and )?)+)")


def records() -> dict[int, Path]:
    """By number."""
    return {int(path.name[:4]): path for path in sorted(FOLDER.glob("[0-9]*.md"))}


def missing(text: str) -> list[str]:
    """References of a text to records that do not exist."""
    known = records()
    wrong = []
    for number, rest in PATH.findall(text):
        path = known.get(int(number))
        if path is None or rest not in ("", path.name[4:], path.stem[4:]):
            wrong.append(f"{number}{rest}")
    numbers = [number for found in WORDS.findall(text) for number in re.findall(r"[0-9]+", found)]
    return wrong + [number for number in numbers if int(number) not in known]


def texts() -> dict[str, str]:
    """Files under version control that hold text, but for those that the machine writes."""
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    skipped = (".png", ".gif", ".wasm", ".ipynb", ".jsonl", ".stl", ".js", ".css")
    names = [name for name in listed.splitlines() if not name.endswith(skipped) and (ROOT / name).is_file()]
    return {name: (ROOT / name).read_bytes().decode("utf-8", errors="ignore") for name in names}


def test_records_are_few_and_numbered_in_order() -> None:
    names = [path.name for path in sorted(FOLDER.glob("[0-9]*.md"))]
    assert [int(name[:4]) for name in names] == list(range(1, len(names) + 1))
    assert len(names) <= MOST_RECORDS
    assert (
        sum(len(re.findall(r"\S*\w\S*", path.read_text(encoding="utf-8"))) for path in records().values()) <= MOST_WORDS
    )


def test_every_record_has_the_sections() -> None:
    for number, path in records().items():
        text = path.read_text(encoding="utf-8")
        assert re.match(rf"# {number}\. \S", text), path.name
        assert re.findall(r"^## (.+)$", text, re.MULTILINE) == SECTIONS, path.name
        assert all(part.strip() for part in re.split(r"^## .+$", text, flags=re.MULTILINE)[1:]), path.name


def test_no_sentence_of_a_record_opens_with_a_clause() -> None:
    found = [(path.name, s) for path in records().values() for s in CLAUSE.findall(path.read_text(encoding="utf-8"))]
    assert found == []


def test_the_index_lists_every_record() -> None:
    listed = re.findall(r"\[([0-9]+\. [^\]]+)\]\(([^)]+)\)", (FOLDER / "index.md").read_text(encoding="utf-8"))
    titles = {
        path.name: path.read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ") for path in records().values()
    }
    assert [(title, name) for name, title in titles.items()] == listed


def test_every_reference_names_a_record() -> None:
    found = {name: missing(text) for name, text in texts().items() if name != "tests/docs/test_records.py"}
    assert {name: wrong for name, wrong in found.items() if wrong} == {}


def test_the_search_finds_them() -> None:
    first = records()[1].name
    assert missing(f"see docs/adr/0001, adr/{first}, [one]({first}), records 1, 2 and 3, ADR 1") == []
    wrong = "docs/adr/0099, adr/0001-other.md, [x](0098-x.md), records 1 and 97, ADR 96, decision 95"
    assert missing(wrong) == ["0099", "0001-other.md", "0098-x.md", "97", "96", "95"]
