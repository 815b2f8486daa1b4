"""Mistakes of those who come from paper, Modelica, MATLAB, Python and SymPy: place, reason and way out.

Each entry of tests/corpus/typed is a statement of a pendulum's model; `⏎` begins a new line. `typed:` is the mistake,
`way:` a part of the help, `repaired:` the statement that the help leads to, which is accepted; then the message.
LAGDSL_UPDATE=1 rewrites the messages: read them.
"""

import os
from pathlib import Path
from typing import NamedTuple

import pytest
from choice import spread

from lagdsl.foundation.diagnostics import Diagnostic, Severity
from lagdsl.foundation.diagnostics.render import render_all
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check

FOLDER = Path(__file__).parents[2] / "corpus" / "typed"
FAMILIES = sorted(FOLDER.glob("*.txt"))

_MODEL = """model Pendulum
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  Length x = l*sin(theta), y = -l*cos(theta);
  mass m at {x, y};
STATEMENT
end Pendulum;
"""
_RULE = "-" * 80 + "\n"


class Entry(NamedTuple):
    typed: str
    way: str
    repaired: str
    message: str


def entries(text: str) -> list[Entry]:
    found = []
    for part in text.split(_RULE)[1:]:
        head, _, message = part.partition("\n\n")
        fields = {}
        for line in head.split("\n"):
            name, mark, rest = line.partition(": ")
            if mark and name in ("typed", "way", "repaired"):
                fields[name] = rest
        found.append(Entry(fields["typed"], fields["way"], fields.get("repaired", ""), message))
    return found


def told(statement: str) -> tuple[Diagnostic, ...]:
    model = _MODEL
    if "gravity" not in statement:
        model = model.replace("  mass m", "  gravity = -g_n*world.y;\n  mass m")
    model = model.replace("STATEMENT", "\n".join(f"  {line}" for line in statement.split("⏎")))
    diagnostics, _ = check(SourceFile("pendulum.lag", model))
    return diagnostics


@pytest.mark.parametrize("path", FAMILIES, ids=lambda path: path.stem)
def test_message_of_what_is_typed(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    written = text.split(_RULE)[0]
    for entry in entries(text):
        diagnostics = tuple(each for each in told(entry.typed) if each.severity is Severity.ERROR)
        assert diagnostics, entry.typed
        assert any(entry.way in (each.help or "") for each in diagnostics), entry.typed
        shown = render_all(diagnostics)
        repaired = f"repaired: {entry.repaired}\n" if entry.repaired else ""
        written += f"{_RULE}typed: {entry.typed}\nway: {entry.way}\n{repaired}\n{shown}"
    if os.environ.get("LAGDSL_UPDATE"):
        path.write_text(written, encoding="utf-8")
    assert written == text


@pytest.mark.parametrize("path", FAMILIES, ids=lambda path: path.stem)
def test_repaired_statement_is_accepted(path: Path) -> None:
    repaired = [entry.repaired for entry in entries(path.read_text(encoding="utf-8")) if entry.repaired]
    for statement in spread(repaired, 8):
        errors = [each for each in told(statement) if each.severity is Severity.ERROR]
        assert not errors, f"{statement}\n{render_all(tuple(errors))}"


@pytest.mark.parametrize(
    "statement",
    [
        "Real k = x" + "'" * 5000,
        "Real k = " + "θ" * 5000,
        "Real k = 1" + "_000" * 5000,
        "Real k = " + "x**" * 5000,
        "mass m at (" + "; x" * 5000,
        "Real k = 1 " + "y" * 5000,
        "Real k = |" + "x" * 5000 + "|",
        "Real k = 0" + ",5" * 5000,
    ],
)
def test_help_for_long_texts_stays_short(statement: str) -> None:
    diagnostics = told(f"{statement};")
    assert diagnostics
    assert max(len(each.help or "") for each in diagnostics) < 200


def test_every_help_writes_what_it_offers_or_says_what_to_do() -> None:
    """Errors have a way out; `way:` is a part of it. There are more than a hundred entries."""
    count = 0
    for path in FAMILIES:
        for entry in entries(path.read_text(encoding="utf-8")):
            count += 1
            assert entry.way
            assert entry.message.startswith("error[E")
            assert "\nhelp: " in entry.message
            assert "Traceback" not in entry.message
    assert count > 120
