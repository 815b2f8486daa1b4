"""Budgets of the C runtime and of pictures: numbers that may go down, and do not go up without a reason."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from hybrid_core import hybrid_core

import lagdsl

ROOT = Path(lagdsl.__file__).parent
RUNTIME, SHELL = ROOT / "engines/runtime/c/lag", ROOT / "exchange/fmi/c/lag"
PICTURES = ("derivation/scene", "documents/plot", "documents/page", "documents/report/figure")
CONSTANT = re.compile(r"^static const double [A-Za-z_]", re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*$", re.DOTALL | re.MULTILINE)
STRUCT = re.compile(r"\b(?:struct|union)\s*(\w*)\s*\{")
MEMBERS = 20
# The table of what is generated for a model: generated text fills it, member by member.
LARGE = {"lag_model": 119}
SINGULAR = ("singular_crossing", "collocation")


def _sources(*folders: Path) -> list[Path]:
    return [path for folder in folders for path in sorted(folder.rglob("*.[ch]"))]


def _lines(paths: list[Path]) -> int:
    return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in paths)


def _parts(text: str, separator: str) -> Iterator[str]:
    """Between separators that stand in no brackets."""
    depth, part = 0, ""
    for letter in text:
        if letter == separator and depth == 0:
            yield part
            part = ""
        else:
            part += letter
            depth += (letter in "([{") - (letter in ")]}")
    yield part


def _members(text: str) -> Iterator[tuple[str, int]]:
    """Every structure with a name, and how many members it declares; a pointer to a function is one."""
    bare = COMMENT.sub(" ", text)
    for found in STRUCT.finditer(bare):
        body = next(_parts(bare[found.end() :], "}"))
        declarations = [part for part in _parts(body, ";") if part.strip()]
        yield found[1], sum(len(list(_parts(part, ","))) for part in declarations)


def test_structs_have_few_members() -> None:
    counts = [
        each for path in _sources(RUNTIME, SHELL) for each in _members(path.read_text(encoding="utf-8")) if each[0]
    ]
    assert len(counts) > 100
    assert {name: count for name, count in counts if count > MEMBERS} == LARGE


def test_members_are_counted() -> None:
    text = """
    #define MANY struct x { \\
        int a; }
    typedef struct one {
        double *a, b[3]; /* int c; */
        void (*d)(int, int);
        struct { int e, f; } g;
        enum { X, Y } h;
    } one;
    """
    assert list(_members(text)) == [("one", 5), ("", 2)]


def test_few_constants_have_names() -> None:
    texts = [path.read_text(encoding="utf-8") for path in _sources(RUNTIME, SHELL)]
    assert sum(len(CONSTANT.findall(text)) for text in texts) <= 200


def test_the_hybrid_model_is_no_longer() -> None:
    assert _lines(hybrid_core(RUNTIME)) <= 6268


def test_crossings_of_singular_positions_are_short() -> None:
    found = [path for path in _sources(RUNTIME / "run") if path.stem in SINGULAR]
    assert len(found) == 3
    assert _lines(found) <= 600


def test_an_instance_of_an_fmu_is_short() -> None:
    assert _lines(_sources(SHELL / "instance")) <= 1812


def test_the_code_of_pictures_is_short() -> None:
    """Python and TypeScript; not what is installed or built."""
    found = [path for folder in PICTURES for suffix in ("py", "ts") for path in (ROOT / folder).rglob(f"*.{suffix}")]
    own = [path for path in found if not {"node_modules", "dist"} & set(path.parts)]
    assert len(own) > 60
    assert _lines(own) <= 8548
