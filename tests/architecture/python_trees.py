"""The modules of the package as syntax trees, parsed once for all tests of a process."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path


@cache
def nodes(tree: ast.Module) -> tuple[ast.AST, ...]:
    """All of the tree. Tests ask for them again and again, and to walk takes as long as to look at them."""
    return tuple(ast.walk(tree))


@cache
def trees(root: Path) -> dict[str, ast.Module]:
    """By path below `root`, sorted."""
    paths = sorted((root / "lagdsl").rglob("*.py"))
    return {path.relative_to(root).as_posix(): ast.parse(path.read_text(encoding="utf-8")) for path in paths}
