"""No circle of dependencies, hidden ones included: imports for the type checker, imports inside functions, C calls."""

from __future__ import annotations

import ast
from pathlib import Path

from c_layers import between_rooms, cycles, defined, included, read, rooms
from python_trees import nodes, trees


def _module(path: str) -> str:
    parts = path.removesuffix(".py").split("/")
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def python_imports(root: Path) -> dict[str, set[str]]:
    """Modules of the package that each module imports anywhere in its text."""
    modules = {_module(path): tree for path, tree in trees(root).items()}
    found: dict[str, set[str]] = {}
    for name, tree in modules.items():
        needs: set[str] = set()
        for node in nodes(tree):
            if isinstance(node, ast.Import):
                needs |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module is not None:
                inner = {f"{node.module}.{alias.name}" for alias in node.names}
                needs |= inner & modules.keys()
                if inner - modules.keys():  # a name of the module itself
                    needs.add(node.module)
        found[name] = (needs & modules.keys()) - {name}
    return found


def test_no_modules_import_each_other(root: Path) -> None:
    assert cycles(python_imports(root)) == []


def _c(root: Path) -> tuple[Path, Path]:
    return root / "lagdsl" / "engines" / "runtime" / "c" / "lag", root / "lagdsl" / "exchange" / "fmi" / "c" / "lag"


def test_no_c_files_include_each_other(root: Path) -> None:
    assert cycles(included(read(*_c(root)))) == []


def test_no_rooms_of_c_need_each_other(root: Path) -> None:
    files = read(*_c(root))
    assert len(defined(files)) > 300
    assert {"linalg", "equations", "events", "run", "shell"} <= set(rooms(files).values())
    assert cycles(between_rooms(files)) == []


def test_the_search_finds_circles() -> None:
    assert cycles({"a": ["b"], "b": ["c"], "c": ["b"], "d": ["a"]}) == [["b", "c"]]
    files = {
        "low/a.c": '#include "lag/a.h"\nint lag_a(void) {\n    return lag_b(1);\n}\n',
        "a.h": "int lag_a(void);\n",
        "high/b.c": '#include "lag/a.h"\nint lag_b(int x) {\n    return lag_a();\n}\n',
    }
    assert rooms(files)["a.h"] == "low"
    assert cycles(between_rooms(files)) == [["high", "low"]]
