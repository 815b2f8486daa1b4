"""Properties of edits on all models: formatting and renaming keep the program, actions remove their diagnostic."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest
from choice import ALL, chosen, spread

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.lsp.features.actions import edit_of
from lagdsl.interfaces.lsp.features.formatting import formatting
from lagdsl.interfaces.lsp.features.rename import Refused, changed, rename
from lagdsl.interfaces.lsp.findings import findings
from lagdsl.interfaces.lsp.positions import offset_at
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.flat import expression_text
from lagdsl.language.flat.text import flat_text
from lagdsl.motion.pipeline import flatten_file

FOLDER = Path(__file__).parents[3] / "models"
EVERY = sorted(str(path.relative_to(FOLDER)) for path in FOLDER.rglob("*.lag"))
SOME = [
    "bouncing_ball.lag",
    "four_bar.lag",
    "half_car.lag",
    "ladder_leaving_wall.lag",
    "motor_pendulum.lag",
    "newtons_cradle.lag",
    "pendulum.lag",
    "van_der_pol.lag",
]
REJECTED = Path(__file__).parents[2] / "corpus" / "reject"
NEW = "zz_renamed"


def _text(name: str) -> str:
    return (FOLDER / name).read_text(encoding="utf-8")


def _flat(name: str, text: str) -> str:
    flat = flatten_file(SourceFile(str(FOLDER / name), text), Sink())
    assert flat is not None
    return "\n".join(line.partition("//")[0].rstrip() for line in flat_text(flat).split("\n"))


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_formatting_keeps_the_program(name: str) -> None:
    text = _text(name).replace("\n  ", "\n\t ").replace(" = ", "=")
    snapshot = Snapshot(str(FOLDER / name), text, 1)
    for edit in formatting(snapshot):
        start, end = offset_at(snapshot.file, edit.range.start), offset_at(snapshot.file, edit.range.end)
        text = snapshot.text[:start] + edit.new_text + snapshot.text[end:]
    assert formatting(Snapshot(str(FOLDER / name), text, 2)) == []
    assert _words(_flat(name, text)) == _words(_flat(name, _text(name)))


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_renaming_keeps_the_program(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every name of the text is renamed; the flat model is the same but for that name. A longer name makes no text so
    long that it is left out."""
    monkeypatch.setattr(expression_text, "_LONGEST", 2 * expression_text._LONGEST)
    text = _text(name)
    snapshot = Snapshot(str(FOLDER / name), text, 1)
    declarations = [each for each in snapshot.declarations() if each.name not in ("x", "y", "z", "e")]
    before = _flat(name, text)
    for each in declarations if ALL else declarations[:: max(len(declarations) // 2, 1)]:
        (spans,) = rename([snapshot], each, NEW).values()
        after = _flat(name, changed(text, spans, NEW))
        assert _words(after.replace(NEW, each.name)) == _words(before), (each, spans)


def _words(text: str) -> Counter[str]:
    """The words of a flat model; names that the compiler makes may change their order."""
    return Counter(re.findall(r"[\w.]+|\S", text))


def test_renaming_to_a_name_that_is_there_is_refused() -> None:
    snapshot = Snapshot("<text>", "model A\n  parameter Mass m = 1 kg;\n  parameter Mass n = 2*m;\nend A;\n", 1)
    wanted = next(each for each in snapshot.declarations() if each.name == "m")
    with pytest.raises(Refused, match="another meaning"):
        rename([snapshot], wanted, "n")
    with pytest.raises(Refused, match="no name"):
        rename([snapshot], wanted, "2m")


FAULTS = [
    (r"(?<![\w.])(\d+(?:\.\d+)?) (?:m|kg|N|s)\b(?=[;,)])", r"\1"),  # a unit left out
    (r"\bcos\(", "coss("),
    (r"end (\w+);\n\Z", r"end \1_;\n"),
    (r"\bgravity\b", "gravty"),
    (r"\bparameter Mass\b", "parameter Masss"),
    (r"\n", "\n  parameter Real unused_one = 1, unused_two = 2;\n"),
]


def _actions_remove_their_diagnostics(path: Path, text: str) -> int:
    """Applies each action to the text; the number of actions."""
    snapshot = Snapshot(str(path), text, 1)
    found = findings(snapshot)
    before = Counter((each.code, each.message) for each in found)
    edits = [(each, edit) for each in found if (edit := edit_of(snapshot, each)) is not None]
    for each, edit in edits:
        after = Snapshot(snapshot.file.name, text[: edit.span.start] + edit.text + text[edit.span.end :], 2)
        told = Counter((other.code, other.message) for other in findings(after))
        assert told[each.code, each.message] < before[each.code, each.message], (path, each, edit)
    return len(edits)


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_every_action_removes_its_diagnostic(name: str) -> None:
    for pattern, wrong in FAULTS:
        _actions_remove_their_diagnostics(FOLDER / name, re.sub(pattern, wrong, _text(name), count=1))


def test_every_action_on_texts_with_faults_removes_its_diagnostic() -> None:
    """Not where there are so many faults (N0199) that the next one takes the place of one that is repaired."""
    paths = spread([path for path in sorted(REJECTED.glob("*.lag")) if path.stem != "N0199"], 80)
    assert sum(_actions_remove_their_diagnostics(path, path.read_text(encoding="utf-8")) for path in paths) > 1
