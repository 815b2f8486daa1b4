"""Pygments and TextMate colour model texts as the parser reads them; what is generated is what is stored."""

from __future__ import annotations

import json
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest
from choice import spread

from highlight.kinds_of_texts import GAP, ROOT, TRAPS, as_the_parser_reads, difference, texts
from highlight.textmate_engine import Engine
from lagdsl.language.highlight.generate import TEXTMATE, files
from lagdsl.language.highlight.pygments_lexer import TOKENS, LagLexer
from lagdsl.language.highlight.rules import Kind
from lagdsl.language.highlight.textmate import SCOPES

TEXTS = {**{f"trap {number}": text for number, text in enumerate(TRAPS)}, **texts()}
BY_TOKEN = {token: kind for kind, token in TOKENS.items()}
ENGINE = Engine(json.loads(files()[TEXTMATE]))
CHECKER = ROOT / "editors" / "vscode" / "node_modules" / ".bin" / "vscode-tmgrammar-test"
NO_NAMES = sorted(scope for kind, scope in SCOPES.items() if kind not in (Kind.NAME, Kind.TYPE))


def by_pygments(text: str) -> list[str]:
    kinds: list[str] = []
    for _, token, value in LagLexer().get_tokens_unprocessed(text):
        kinds += [BY_TOKEN.get(token, str(token))] * len(value)
    return kinds


def wrong(names: list[str], coloured: dict[str, list[str]]) -> list[tuple[str, str]]:
    found = []
    for name in names:
        expected = as_the_parser_reads(TEXTS[name])
        place = None if expected is None else difference(TEXTS[name], expected, coloured[name])
        if place is not None:
            found.append((name, place))
    return found


def chosen_texts() -> list[str]:
    return [name for name in TEXTS if name.startswith("trap")] + spread(sorted(TEXTS), 80)


def test_pygments_colours_what_the_parser_reads() -> None:
    names = chosen_texts()
    assert wrong(names, {name: by_pygments(TEXTS[name]) for name in names}) == []


def test_textmate_colours_what_the_parser_reads() -> None:
    names = chosen_texts()
    assert wrong(names, {name: ENGINE.kinds(TEXTS[name]) for name in names}) == []


@pytest.mark.skipif(not CHECKER.exists() or shutil.which("node") is None, reason="needs node and `npm ci`")
def test_vscode_colours_what_the_parser_reads(tmp_path: Path) -> None:
    """The engine of VS Code, with Oniguruma, by vscode-tmgrammar-test: each text with its scopes below its lines."""
    for number, name in enumerate(chosen_texts()):
        expected = as_the_parser_reads(TEXTS[name])
        if expected is not None:
            (tmp_path / f"{number}.lag").write_text(with_scopes(name, TEXTS[name], expected), encoding="utf-8")
    (tmp_path / "wrong.lag").write_text(with_scopes("wrong", "model A end A;", [Kind.STRING] * 5), encoding="utf-8")
    command = [CHECKER, "--compact", "--grammar", ROOT / TEXTMATE, tmp_path / "*.lag"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    told = [line for line in done.stdout.splitlines() if "ERROR" in line and "wrong.lag" not in line]
    assert told == [], done.stderr
    assert "wrong.lag" in done.stdout


def with_scopes(name: str, text: str, kinds: list[str]) -> str:
    """A text of vscode-tmgrammar-test: below each line the scopes of its characters; a name has those of none else."""
    lines, at = [f'§ SYNTAX TEST "source.lag" "{name}"'], 0
    for line in text.split("\n"):
        lines.append(line)
        columns = [
            (GAP if character.isspace() else kind, len(character.encode("utf-16-le")) // 2)
            for character, kind in zip(line, kinds[at : at + len(line)], strict=False)
        ]
        lines += _scopes(columns)
        at += len(line) + 1
    return "\n".join(lines)


def _scopes(columns: list[tuple[str, int]]) -> list[str]:
    """One line for each kind; `<-` stands for the first column, where the mark of these lines is."""
    told = []
    for kind in sorted({kind for kind, _ in columns} - {GAP}):
        marks = "".join(("^" if each == kind else " ") * width for each, width in columns)
        scopes = f"- {' '.join(NO_NAMES)}" if kind == Kind.NAME else SCOPES[Kind(kind)]
        told += [f"§<- {scopes}"] if marks[0] == "^" else []
        told += [f"§{marks[1:]} {scopes}"] if "^" in marks[1:] else []
    return told


def test_texts_are_read_by_the_parser() -> None:
    """The comparison is about many texts, and every kind occurs in them."""
    traps = [as_the_parser_reads(text) for text in TRAPS]
    assert None not in traps
    kinds = {kind for each in traps if each is not None for kind in each}
    assert kinds >= set(Kind) - {Kind.TYPE, Kind.LITERAL}
    assert len(TEXTS) > 700


def test_the_first_line_of_a_cell_changes_no_colour() -> None:
    """`%%lag pendulum` is no part of the model: what follows is coloured as without it."""
    line = "%%lag pendulum\n"
    for colour in (by_pygments, ENGINE.kinds):
        kinds = colour(line + TRAPS[0])
        expected = as_the_parser_reads(TRAPS[0])
        assert expected is not None
        assert difference(TRAPS[0], expected, kinds[len(line) :]) is None


def test_a_wrong_colour_is_found() -> None:
    """The comparison fails where one character has another kind."""
    text = TRAPS[0]
    expected = as_the_parser_reads(text)
    assert expected is not None
    kinds = by_pygments(text)
    kinds[text.index("Mass")] = Kind.KEYWORD
    assert difference(text, expected, kinds) == "line 4, column 3: `  Mass mass = 1 kg;`: name, not keyword"


def test_unfinished_texts_keep_their_characters() -> None:
    """A lexer of an editor sees every prefix of a text: no character is lost, and the rest of the text is coloured."""
    for text in TRAPS:
        for end in range(0, len(text), 7):
            assert len(by_pygments(text[:end])) == end
            assert len(ENGINE.kinds(text[:end])) == end


@pytest.mark.parametrize("name", sorted(files()))
def test_stored_grammars_are_generated(name: str) -> None:
    assert (ROOT / name).read_text(encoding="utf-8") == files()[name], "run `make update`"


def test_pygments_finds_the_lexer() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["entry-points"]["pygments.lexers"] == {"lag": f"{LagLexer.__module__}:{LagLexer.__name__}"}
