"""Comments and docstrings are plain technical English: the subject opens the sentence, not a clause."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]

# `Whether the step stops` becomes `True if the step stops`; `What an instance tells` becomes `Messages of an instance`.
CLAUSE = re.compile(r"(?:What|Whether|Those|Which|Whose|Who|Whatever)\b")
# These words may begin a condition inside a text, but no comment: `If rows depend on each other, ...`.
OPENING = re.compile(r"(?:Where|How)\b")
SENTENCE = re.compile(r"(?<=[.:;!?])\s+(?=[A-Z])")

PYTHON_TEXT = re.compile(r'^[^\S\n]*r?"""(.*?)"""|((?:^[^\S\n]*#[^\n]*\n)+)', re.DOTALL | re.MULTILINE)
C_TEXT = re.compile(r"/\*(.*?)\*/", re.DOTALL)
HEADING = re.compile(r"/\* -{4} (\w+\.c) -{4} \*/")


def _files(*suffixes: str) -> list[Path]:
    folders = [ROOT / name for name in ("lagdsl", "tests", "benchmarks")]
    found = [path for folder in folders for path in sorted(folder.rglob("*")) if path.suffix in suffixes]
    return [path for path in found if "build" not in path.parent.parts]


def _texts(path: Path) -> list[str]:
    """Docstrings and comments of a file, each on one line."""
    pattern = PYTHON_TEXT if path.suffix == ".py" else C_TEXT
    found = ("".join(filter(None, match.groups())) for match in pattern.finditer(path.read_text(encoding="utf-8")))
    return [re.sub(r"\s*\n\s*(?:[#*](?=\s))?\s*", " ", text).strip(" #*\n") for text in found]


def test_no_sentence_of_the_code_opens_with_a_clause() -> None:
    texts = [(path.relative_to(ROOT).as_posix(), text) for path in _files(".py", ".c", ".h") for text in _texts(path)]
    assert len(texts) > 8000, "the pattern of comments finds too few"
    found = [(path, s) for path, text in texts for s in SENTENCE.split(text) if CLAUSE.match(s)]
    found += [(path, text) for path, text in texts if OPENING.match(text)]
    assert found == []


def test_no_file_begins_with_the_code_of_a_diagnostic() -> None:
    """The head of a file names its subject; codes stand behind it: `Negative dampings (W0522)`."""
    files = sorted((ROOT / "lagdsl").rglob("*.py"))
    heads = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")[:9] for path in files}
    assert [path for path, head in heads.items() if re.match(r'"""[EWN]\d{4}', head)] == []


def test_headings_in_headers_name_sources() -> None:
    """`---- turning.c ----` stands above declarations of that file beside the header."""
    headers = _files(".h")
    named = [(path, name) for path in headers for name in HEADING.findall(path.read_text(encoding="utf-8"))]
    assert named
    assert [(path.name, name) for path, name in named if not (path.parent / name).exists()] == []
