"""Edits that diagnostics propose: the text with the edit has one fault less."""

from collections import Counter
from pathlib import Path

import pytest
from choice import spread, together

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

CORPUS = Path(__file__).parents[2] / "corpus"
EVERY = sorted([*CORPUS.glob("reject/*.lag"), *CORPUS.glob("reject/*/*.lag")])
TEXTS = [path for path in EVERY if path.stem != "N0199"]  # which tells the first faults of many
WITH_EDITS = {"E0101", "E0102", "E0105", "E0111", "E0112", "E0113", "E0114", "E0122", "E0123"}
WITH_EDITS |= {"E0201", "E0208", "E0210", "E0335", "E0344", "E0405"}


def _found(name: str, text: str) -> tuple[Diagnostic, ...]:
    sink = Sink()
    flatten_file(SourceFile(name, text), sink)
    return sink.diagnostics


def _edited(found: Diagnostic, text: str) -> str:
    assert found.edit is not None
    return text[: found.edit.span.start] + found.edit.text + text[found.edit.span.end :]


def _facts(found: tuple[Diagnostic, ...]) -> Counter[tuple[str, str]]:
    return Counter((each.code, each.message) for each in found)


@together("path", spread(TEXTS, 90))
def test_an_edit_removes_what_it_is_for(path: Path) -> None:
    text = path.read_text(encoding="utf-8").removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    before = _found(str(path), text)
    for each in before:
        if each.edit is not None and each.edit.span.file.name == str(path):
            after = _found(str(path), _edited(each, text))
            fact = (each.code, each.message)
            assert _facts(after)[fact] < _facts(before)[fact], (each, [(other.code, other.message) for other in after])


def test_the_mechanical_help_is_an_edit() -> None:
    seen = set()
    for path in TEXTS:
        if path.stem[:5] in WITH_EDITS:
            found = _found(str(path), path.read_text(encoding="utf-8"))
            seen |= {each.code for each in found if each.edit is not None}
    assert seen >= WITH_EDITS


@pytest.mark.parametrize(
    ("text", "code", "meant"),
    [
        ("model A parameter Real x = sqrtt(1); end A;", "E0209", "sqrt"),
        ("model B parameter Length radius = 1 m; end B; model A B b(radus = 2 m); end A;", "E0223", "radius"),
    ],
)
def test_a_proposed_name_takes_the_place_of_the_one_that_is_written(text: str, code: str, meant: str) -> None:
    edits = [each.edit for each in _found("<text>", text) if each.code == code]
    assert [edit is not None and edit.text for edit in edits] == [meant]
