"""Each file of the hybrid core has a unit test of its rule in C, which names it in the comment at its head."""

from __future__ import annotations

import re
from pathlib import Path

from hybrid_core import hybrid_core

import lagdsl

RUNTIME = Path(lagdsl.__file__).parent / "engines/runtime/c/lag"
HEAD = re.compile(r"\s*/\*\s*(?:\*\s*)?Tests (.*?)\*/", re.DOTALL)
NAMED = re.compile(r"\b\w+/\w+\.c\b")


def named(text: str) -> set[str]:
    """Files, as `events/noise.c`, that the comment at the head of a test names; it begins with `Tests`."""
    head = HEAD.match(text)
    return set(NAMED.findall(head[1])) if head else set()


def _tested(root: Path) -> set[str]:
    return {
        name for path in (root / "tests" / "c").glob("test_*.c") for name in named(path.read_text(encoding="utf-8"))
    }


def test_heads_name_what_is_tested() -> None:
    text = "/*\n * Tests events/a.c (its rule) and\n * contacts/b.c.\n */\n/* Tests events/c.c */\n"
    assert named(text) == {"events/a.c", "contacts/b.c"}
    assert named("/* Tests events/a.c: its rule. */") == {"events/a.c"}
    assert named('/* Events. */\n#include "events/a.c"\n') == set()


def test_each_file_of_the_hybrid_core_has_a_unit_test(root: Path) -> None:
    core = {path.relative_to(RUNTIME).as_posix() for path in hybrid_core(RUNTIME) if path.suffix == ".c"}
    assert len(core) >= 25
    assert core - _tested(root) == set(), "write a test in tests/c that states the rule of the file, and name it there"


def test_files_that_are_tested_exist(root: Path) -> None:
    assert {name for name in _tested(root) if not (RUNTIME / name).is_file()} == set()
