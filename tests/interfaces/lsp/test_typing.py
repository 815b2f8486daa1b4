"""Texts that are typed: every beginning is answered, and nothing is told outside the statement being typed."""

from __future__ import annotations

from pathlib import Path

import pytest
from choice import ALL, chosen
from lsp_texts import FOUR_BAR

from lagdsl.foundation.diagnostics import Severity
from lagdsl.interfaces.lsp.documents import Document
from lagdsl.interfaces.lsp.features.completion import completion
from lagdsl.interfaces.lsp.features.cursor import cursor_at
from lagdsl.interfaces.lsp.features.folding import folding
from lagdsl.interfaces.lsp.features.formatting import formatting
from lagdsl.interfaces.lsp.features.hints import hints
from lagdsl.interfaces.lsp.features.hover import hover
from lagdsl.interfaces.lsp.features.lenses import lenses
from lagdsl.interfaces.lsp.features.signature import signature
from lagdsl.interfaces.lsp.features.symbols import document_symbols
from lagdsl.interfaces.lsp.features.tokens import tokens
from lagdsl.interfaces.lsp.findings import Memory, findings
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.tokens import plain_tokens, start_of

MODELS = sorted((Path(__file__).parents[3] / "models").glob("*.lag"))
OPEN_BLOCK = "E0113"
"""A class without its `end` is told at its head: it is the statement being typed until the `end` is there."""
BEHIND_AN_OPEN_BLOCK = ("E0100", "E0101", "E0118")
"""A block that lost its `end` holds all that follows: the parser tells what cannot stand in it (4 of 1274)."""


def _statement_start(text: str) -> int:
    """Start of the statement that is typed at the end of a text; the last one while nothing follows it."""
    starts, ended = [0], True
    for token in plain_tokens(text):
        if ended:
            starts.append(start_of(token))
        ended = token.value == ";"
    return starts[-1]


@pytest.mark.parametrize("length", range(0, len(FOUR_BAR) + 1, 1 if ALL else 20))
def test_every_beginning_of_the_four_bar_is_answered(length: int) -> None:
    text = FOUR_BAR[:length]
    snapshot = Snapshot("<typed>", text, 1)
    found = findings(snapshot)
    start = _statement_start(text)
    for each in found:
        place = each.labels[0].span if each.labels else None
        if each.code != OPEN_BLOCK and place is not None:
            assert place.file is snapshot.file
            assert place.start >= start, (each.code, each.message, place.text)
    _ask_everything(snapshot, length)


def _ask_everything(snapshot: Snapshot, offset: int) -> None:
    completion(snapshot, offset)
    signature(snapshot, offset)
    hover(snapshot, max(offset - 1, 0), None)
    tokens(snapshot)
    folding(snapshot)
    formatting(snapshot)
    hints(snapshot, None)
    document_symbols(snapshot)
    lenses(snapshot, "file:///typed.lag")


SOME = ("bouncing_ball", "double_wishbone", "van_der_pol")


@pytest.mark.parametrize("name", chosen([path.stem for path in MODELS], SOME))
def test_a_broken_statement_is_the_only_one_that_is_told(name: str) -> None:
    """A statement that lost its last third: whatever errors there are stand in it."""
    text = (Path(__file__).parents[3] / "models" / f"{name}.lag").read_text(encoding="utf-8")
    unit = Snapshot(f"<{name}>", text, 1).unit
    assert unit is not None
    items = [each for item in unit.items if isinstance(item, nodes.Class) for each in _items(item)]
    for item in items if ALL else items[:: max(len(items) // 5, 1)]:
        start, end = item.span.start, item.span.end
        cut = start + max(3, (end - start) * 2 // 3)
        snapshot = Snapshot(f"<{name}>", text[:cut] + text[end:], 1)
        if snapshot.is_whole:
            continue
        errors = [each for each in findings(snapshot) if each.severity is Severity.ERROR]
        outside = [each for each in errors if not start <= each.labels[0].span.start <= cut]
        if any(each.code == OPEN_BLOCK and each.labels[0].span.start == start for each in errors):
            assert {each.code for each in outside} <= set(BEHIND_AN_OPEN_BLOCK), (text[start:end], outside)
            continue
        assert not outside, (text[start:end], outside)


@pytest.mark.parametrize(
    ("typed", "rest", "codes"),
    [
        ("point P", "for i in 1:2 loop point P[i] = {i*l, l}; end for;", ["E0101"]),
        ("point P[", "for i in 1:2 loop point P[i] = {i*l, l}; end for;", ["E0111"]),
        ("Length k = 2 kg", "mass 1 kg at {k, l};", ["E0101"]),
        ("for i in 1:2 loop", "point P = {l, l}; coordinate Length x;", ["E0113"]),
        ("when l > 0 then", "protected Length k = l; public output Length w = l;", ["E0113"]),
        ("point P", "force {1 N, 1 kg} at P;", ["E0101", "E0401"]),
        ("Bar b(r = 1 m", "gravity = -g_n*world.y;", ["E0111"]),
    ],
)
def test_what_the_parser_completes_is_not_judged_elsewhere(typed: str, rest: str, codes: list[str]) -> None:
    """`rest` stands behind an unfinished declaration or block; a fault of its own is told nevertheless."""
    bar = "model Bar\n  parameter Length r;\nequation\n  mass 1 kg at {r, 0 m};\nend Bar;\n"
    text = f"{bar}model A\n  parameter Length l = 1 m;\n  {typed}\n  {rest}\nend A;\n"
    found = findings(Snapshot("<typed>", text, 1))
    assert sorted({each.code for each in found if each.severity is Severity.ERROR}) == codes


FAULTY = """model Two
  parameter Mass m = 1 m;
  coordinate Length x, y;
  mass m at {x, y};
end Two;
"""
TYPED = ("torque 1 N.m on q;", "parameter Real k(min = 0) = sin(30 deg)", "end")


@pytest.mark.parametrize("text", [FOUR_BAR, FAULTY], ids=["four_bar", "faulty"])
def test_what_is_remembered_is_what_is_found(text: str) -> None:
    """Statements are typed at several places, one character after the other, after others, with errors elsewhere."""
    memory, answered = Memory(), 0
    places = [at for at in range(len(text)) if text.startswith("\n  ", at)]
    for at in places[:: 1 if ALL else 4]:
        for typed in TYPED:
            for length in range(0, len(typed) + 1, 1 if ALL else 5):
                snapshot = Snapshot("<typed>", f"{text[:at]}\n  {typed[:length]}{text[at:]}", length)
                before = memory.shape
                assert findings(snapshot, memory) == findings(snapshot), snapshot.text
                answered += before is not None and memory.shape is not None and len(memory.shape.pieces) > 1
    assert answered


def test_what_is_remembered_moves_with_its_statement() -> None:
    memory = Memory()
    for lines in range(3):
        snapshot = Snapshot(
            "<typed>", FAULTY.replace("  coordinate", "\n" * lines + "  force {1 N\n  coordinate"), lines
        )
        (wrong,) = (each for each in findings(snapshot, memory) if each.code == "E0407")
        assert wrong.labels[0].span.file is snapshot.file
        assert wrong.labels[0].span.text == "1 m"


def test_a_file_that_is_read_anew_is_looked_at_anew(tmp_path: Path) -> None:
    """An error in a statement that imports a file is found again when that file has changed."""
    (tmp_path / "Arm.lag").write_text("model Arm\n  parameter Length l = 1 m;\nend Arm;\n")
    text = "model Use\n  import Arm;\n  Arm a(l = 2 m);\n  mass\nend Use;\n"
    document = Document((tmp_path / "Use.lag").as_uri(), text, 1)
    assert [each.code for each in findings(document.snapshot, document.memory)] == ["E0139"]
    (tmp_path / "Arm.lag").write_text("model Arm\n  parameter Mass l = 1 kg;\nend Arm;\n")
    document.refresh()
    assert "E0407" in [each.code for each in findings(document.snapshot, document.memory)]


def _items(item: nodes.Class) -> list[nodes.Item]:
    return [*item.items, *(each for section in item.sections for each in section.items)]


@pytest.mark.parametrize(
    ("typed", "want"),
    [
        ("model A\n  ", "statement"),
        ("model A\n  par", "statement"),
        ("model A\n  parameter ", "type"),
        ("model A\n  parameter Mass m = 5 k", "unit"),
        ("model A\n  mass m at A.", "member"),
        ("model A\n  Link a(", "modifier"),
        ("model A\n  Link a(l = ", "expression"),
        ("model A\n  Link a(l = 1 m, ", "modifier"),
        ("model A\n  coordinate Angle q(der(", "modifier"),
        ("model A\n  parameter Mass m = f(", "expression"),
        ("model A\n  import Lag.", "package"),
        ('model A "te', "nothing"),
        ("model A // te", "nothing"),
        ("model A /* te", "nothing"),
        ("model A\nequation\n  x = ", "expression"),
        ("model A\n  force {1 N, 0} at ", "expression"),
    ],
)
def test_the_cursor_knows_what_may_be_written(typed: str, want: str) -> None:
    assert cursor_at(typed, len(typed)).want == want
