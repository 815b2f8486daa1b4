"""Examples of the documents are sound models, Python that runs, and commands with the output that the page shows.

Blocks of a page run in their order, in one folder with `models/` beside it. A block whose first line says `file=NAME`
is written there; one that says `fragment` does not stand alone and is left out; one that says `needs=PACKAGE` runs
where that is installed. LAGDSL_UPDATE=1 writes the output of commands into the pages. Pages about FMUs and about small
motions have tests of their own.
"""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Iterator
from importlib.util import find_spec
from math import inf
from pathlib import Path
from typing import NamedTuple

import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.interfaces.cli import progress
from lagdsl.interfaces.cli.main import lag

ROOT = Path(__file__).parents[2]
ELSEWHERE = {"reference/fmi.md", "howto/export_fmu.md", "howto/cosimulate.md", "explanation/oscillations.md"}
FENCE = re.compile(r"^```(?P<language>[a-z]+)(?P<marks>[^\n]*)\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)


def pages() -> list[str]:
    """Pages that a person wrote: those of diagnostics have their own test, records of decisions have no examples."""
    folder = ROOT / "docs"
    names = [path.relative_to(folder).as_posix() for path in sorted(folder.rglob("*.md"))]
    generated = ("notebooks/", "diagnostics/", "adr/", "reference/components/")
    return [name for name in names if not name.startswith(generated) and name not in ELSEWHERE]


class Block(NamedTuple):
    language: str
    marks: str
    text: str


def blocks(text: str) -> Iterator[Block]:
    """The blocks of code of a page, without fragments."""
    for found in FENCE.finditer(text):
        if "fragment" not in found["marks"]:
            yield Block(found["language"], found["marks"], found["text"])


def output(command: str) -> str:
    """Of a command on both streams, as a terminal shows it."""
    done = CliRunner().invoke(lag, shlex.split(command.removeprefix("lag ")))
    assert done.exit_code in (0, 1, 2, 3), done.output
    return "\n".join(line.rstrip() for line in done.output.rstrip().splitlines())


def session(text: str) -> str:
    """The commands of a console block, each with its output."""
    commands = re.findall(r"^\$ (lag .*)$", text, re.MULTILINE)
    assert commands, text
    return "\n".join(f"$ {command}\n{output(command)}".rstrip() for command in commands)


def rounded(text: str) -> str:
    """The text without numbers that are round-off, which every machine has its own of."""
    return re.sub(r"-?\d\.\d+e-1\d", "round-off", text)


@pytest.mark.parametrize("page", pages())
def test_examples_of_the_page(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "docs" / page
    text = path.read_text(encoding="utf-8")
    (tmp_path / "models").symlink_to(ROOT / "models")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(progress, "_PATIENCE_OF_LOGS", inf)  # a page shows no lines of machines that are slow
    names: dict[str, object] = {}
    missing = set()
    for block in blocks(text):
        needed = re.search(r"needs=(\w+)", block.marks)
        if needed and find_spec(needed[1]) is None:
            missing.add(needed[1])
            continue
        match block.language:
            case "modelica" | "lag":
                model(block)
            case "python":
                exec(compile(block.text, page, "exec"), names)
            case "xml" | "text":
                written(block)
            case "console":
                shown = session(block.text)
                if os.environ.get("LAGDSL_UPDATE"):
                    text = text.replace(f"```console\n{block.text}```", f"```console\n{shown}\n```")
                else:
                    assert rounded(shown) == rounded(block.text.rstrip("\n"))
            case _:
                pass
    if os.environ.get("LAGDSL_UPDATE"):
        path.write_text(text, encoding="utf-8")
    if missing:
        pytest.skip(f"some blocks need {', '.join(sorted(missing))}; the others ran")


def written(block: Block) -> None:
    """A block with a name is a file, for the blocks behind it."""
    named = re.search(r"file=(\S+)", block.marks)
    if named:
        Path(named[1]).write_text(block.text, encoding="utf-8")


def model(block: Block) -> None:
    """A text without errors and warnings; `reject` marks one that shall have some."""
    written(block)
    found = [d.code for d in lagdsl.check(block.text) if d.severity != "note"]
    assert bool(found) == ("reject" in block.marks), (found, block.text)
