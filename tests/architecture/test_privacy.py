"""A name with a leading underscore belongs to the module that defines it; tests may look inside."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from python_trees import nodes, trees

# Documented names, underscored so that fields cannot collide with them: of named tuples, of structures of ctypes.
PUBLIC = {"_replace", "_asdict", "_fields", "_make", "_fields_"}
# Names of other packages that have no public one.
FOREIGN = {
    "_parse_table": "Lark has no public name for its table",
    "_request_futures": "pygls 2.1 keeps futures of notifications there and drops none",
    "_width": "Lark keeps the widths of a pattern by it",
    "_get_width": "Lark computes the widths of a pattern by it",
    "_NamedFuncPointer": "typeshed names the type of a function of a library by it",
    "_CFunctionType": "typeshed names the type of a prototype by it",
}


def _is_private(name: str) -> bool:
    return name.startswith("_") and not name.endswith("__") and name not in PUBLIC | FOREIGN.keys()


def _own_names(tree: ast.Module) -> set[str]:
    """Names that the module defines: functions, classes, variables, fields, and attributes that it sets on `self`."""
    names: set[str] = set()
    for node in nodes(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names.add(node.id)
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and _is_own(node.value):
            names.add(node.attr)
    return names


def _is_own(value: ast.expr) -> bool:
    return isinstance(value, ast.Name) and value.id in ("self", "cls")


def intrusions(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Lines and private names of other modules that they import or read."""
    own = _own_names(tree)
    for node in nodes(tree):
        if isinstance(node, ast.ImportFrom) and node.module != "__future__":
            yield from ((node.lineno, alias.name) for alias in node.names if _is_private(alias.name))
            if any(_is_private(part) for part in (node.module or "").split(".")):
                yield node.lineno, node.module or ""
        elif isinstance(node, ast.Attribute) and _is_private(node.attr) and not _is_own(node.value):
            yield from [(node.lineno, node.attr)] if node.attr not in own else []


def test_private_names_stay_in_their_module(root: Path) -> None:
    found = {path: list(intrusions(tree)) for path, tree in trees(root).items()}
    assert {path: lines for path, lines in found.items() if lines} == {}


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("from a import _b", ["_b"]),
        ("from a._b import c", ["a._b"]),
        ("import a\na._b()", ["_b"]),
        ("def f(x):\n    return x._b", ["_b"]),
        ("class A:\n    _b: int\ndef f(x):\n    return x._b", []),
        ("class A:\n    def __init__(self):\n        self._b = 1\ndef f(x):\n    return x._b", []),
        ("row._replace(x=1)", []),
    ],
)
def test_the_search_finds_them(source: str, found: list[str]) -> None:
    assert [name for _, name in intrusions(ast.parse(source))] == found
