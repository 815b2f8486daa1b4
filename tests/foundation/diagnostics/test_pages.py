"""The manual of diagnostics: a page for each code, and every example does what its page says."""

import re
from functools import cache
from pathlib import Path

import pytest
from choice import spread

from lagdsl.foundation.diagnostics import Severity
from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.diagnostics.explain import UnknownCode, explain
from lagdsl.foundation.resources import diagnostics_folder
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check

TESTS = Path(__file__).parents[2]
ELSEWHERE = "Reported "  # how the front line of a page begins if no model text alone draws the diagnostic

_EXAMPLE = re.compile(r"^```lag (?P<kind>reject|accept)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)


@cache
def page(code: str) -> str:
    return (diagnostics_folder() / f"{code}.md").read_text(encoding="utf-8")


def is_elsewhere(code: str) -> bool:
    return page(code).split("\n")[2].startswith(ELSEWHERE)


@cache
def examples() -> list[tuple[str, str, str]]:
    pages = sorted(diagnostics_folder().glob("*.md"))
    return [
        (path.stem, match["kind"], match["text"])
        for path in pages
        for match in _EXAMPLE.finditer(path.read_text(encoding="utf-8"))
    ]


def test_pages_and_rows_are_the_same_codes():
    assert sorted(path.stem for path in diagnostics_folder().glob("[A-Z][0-9]*.md")) == sorted(ROWS)


def test_pages_have_a_title_and_both_examples():
    for code in ROWS:
        title, blank, *rest = page(code).split("\n")
        assert re.fullmatch(rf"# {code} [A-Z`].*[^.]", title) and blank == "", code
        assert all(len(line) <= 120 for line in rest if not line.startswith("  ")), code
        kinds = {kind for name, kind, _ in examples() if name == code}
        assert kinds == (set() if is_elsewhere(code) else {"reject", "accept"}), code


def test_every_code_is_tested():
    rejected = {path.name[:5] for path in (TESTS / "corpus" / "reject").glob("*.lag")}
    others = [code for code in ROWS if code not in rejected]
    assert [code for code in others if not is_elsewhere(code)] == [], "there is no reject case"
    spoken = "\n".join(path.read_text(encoding="utf-8") for path in TESTS.rglob("test_*.py"))
    assert [code for code in others if code not in spoken] == [], "no test speaks of them"


def test_letters_are_severities():
    letters = {Severity.ERROR: "E", Severity.WARNING: "W", Severity.NOTE: "N"}
    assert [code for code, row in ROWS.items() if code[0] != letters[row.severity]] == []


@pytest.mark.parametrize(
    ("code", "kind", "text"), [pytest.param(*e, id=f"{e[0]}-{e[1]}") for e in spread(examples(), 75)]
)
def test_example(code, kind, text):
    diagnostics, _ = check(SourceFile(f"{code}.lag", text))
    codes = [diagnostic.code for diagnostic in diagnostics]
    if kind == "reject":
        assert code in codes
    else:
        assert code not in codes
        assert [c for c in codes if c[0] == "E"] == []


def test_explain_shows_the_page():
    for spelled in ("E0401", "e0401", "error[E0401]", " E0401 "):
        assert explain(spelled) == page("E0401")


@pytest.mark.parametrize(("code", "suggestion"), [("W0401", "E0401"), ("E04O1", "E0401"), ("nonsense", None)])
def test_unknown_code(code, suggestion):
    with pytest.raises(UnknownCode) as caught:
        explain(code)
    assert caught.value.suggestion == suggestion
    assert code in str(caught.value)
    assert suggestion is None or suggestion in str(caught.value)
