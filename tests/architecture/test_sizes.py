"""Sizes that a reader can hold in mind: files of a folder, lines of a module, fields of an object that changes."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from python_trees import nodes, trees

SOURCES = (".py", ".c", ".h")
MOST_FILES, MOST_LINES, MOST_FIELDS = 25, 400, 10

# Longer files, each with what stands in the way of two.
LONG: dict[str, str] = {"structures.py": "it is generated: a mirror of the structures of C"}
# Objects that change with more fields, each with what stands in the way of fewer.
LARGE: dict[str, str] = {}


def test_folders_hold_few_files(root: Path) -> None:
    folders = {path.parent for suffix in SOURCES for path in (root / "lagdsl").rglob(f"*{suffix}")}
    sizes = {folder: sum(path.suffix in SOURCES for path in folder.iterdir()) for folder in folders}
    assert {str(folder.relative_to(root)): size for folder, size in sizes.items() if size > MOST_FILES} == {}


def test_modules_are_short(root: Path) -> None:
    sizes = {
        path: len(path.read_text(encoding="utf-8").splitlines())
        for suffix in SOURCES
        for path in (root / "lagdsl").rglob(f"*{suffix}")
    }
    found = {path.name: size for path, size in sizes.items() if size > MOST_LINES}
    assert {name: size for name, size in found.items() if name not in LONG} == {}
    assert LONG.keys() - found.keys() == set(), "no longer long: take it off the list"


def _is_mutable_dataclass(node: ast.ClassDef) -> bool:
    made = [ast.unparse(decorator) for decorator in node.decorator_list]
    return any(text.startswith(("dataclass", "mutable_record")) and "frozen=True" not in text for text in made)


def _attributes(node: ast.ClassDef) -> set[str]:
    """Attributes that the methods of a class put into `self`."""
    return {
        at.attr
        for at in ast.walk(node)
        if isinstance(at, ast.Attribute) and isinstance(at.ctx, ast.Store) and ast.unparse(at.value) == "self"
    }


def large(tree: ast.Module) -> Iterator[str]:
    """Classes whose objects change and have too many fields: dataclasses that are not frozen, and plain ones."""
    for node in nodes(tree):
        if isinstance(node, ast.ClassDef):
            fields = [item for item in node.body if isinstance(item, ast.AnnAssign) and _is_mutable_dataclass(node)]
            if max(len(fields), len(_attributes(node))) > MOST_FIELDS:
                yield node.name


def test_objects_that_change_have_few_fields(root: Path) -> None:
    found = {name for tree in trees(root).values() for name in large(tree)}
    assert found - LARGE.keys() == set()
    assert LARGE.keys() - found == set(), "no longer large: take it off the list"


@pytest.mark.parametrize(
    ("decorator", "fields", "found"),
    [
        ("dataclass", 11, ["A"]),
        ("dataclass(slots=True)", 11, ["A"]),
        ("mutable_record()", 11, ["A"]),
        ("dataclass", 10, []),
        ("record()", 11, []),
    ],
)
def test_the_search_finds_them(decorator: str, fields: int, found: list[str]) -> None:
    body = "\n".join(f"    x{k}: int" for k in range(fields))
    assert list(large(ast.parse(f"@{decorator}\nclass A:\n{body}\n"))) == found


@pytest.mark.parametrize("fields", [10, 11])
def test_the_search_finds_plain_classes(fields: int) -> None:
    body = "\n".join(f"        self.x{k} = {k}" for k in range(fields))
    assert list(large(ast.parse(f"class A:\n    def __init__(self):\n{body}\n"))) == ["A"] * (fields > MOST_FIELDS)
