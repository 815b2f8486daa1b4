"""A match over a closed set of classes names every class: a wildcard there would hide the next class that is added.

mypy completes the rule: `exhaustive-match` is an error, and `assert_never` types what is left. Texts, numbers and
sequences of any length are open sets, where a wildcard stands for what cannot be listed.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from python_trees import nodes, trees


def _leaves(pattern: ast.pattern) -> Iterator[ast.pattern]:
    """The alternatives of a pattern."""
    if isinstance(pattern, ast.MatchOr):
        for part in pattern.patterns:
            yield from _leaves(part)
    elif isinstance(pattern, ast.MatchAs) and pattern.pattern is not None:
        yield from _leaves(pattern.pattern)
    else:
        yield pattern


def _is_wildcard(pattern: ast.pattern) -> bool:
    return isinstance(pattern, ast.MatchAs) and pattern.pattern is None


def _names_members(pattern: ast.pattern) -> bool:
    """A class, a member of an enumeration (a dotted name), or several of them."""
    if isinstance(pattern, ast.MatchSequence):
        return any(_names_members(leaf) for part in pattern.patterns for leaf in _leaves(part))
    return isinstance(pattern, ast.MatchClass) or (
        isinstance(pattern, ast.MatchValue) and isinstance(pattern.value, ast.Attribute)
    )


def _ends_in_assert_never(case: ast.match_case) -> bool:
    last = case.body[-1]
    return (
        isinstance(last, ast.Expr)
        and isinstance(last.value, ast.Call)
        and ast.unparse(last.value.func) == "assert_never"
    )


def wildcards(tree: ast.Module) -> list[int]:
    """Lines of wildcard cases that stand for the rest of a closed set."""
    found = []
    for match in (node for node in nodes(tree) if isinstance(node, ast.Match)):
        named = [leaf for case in match.cases for leaf in _leaves(case.pattern) if not _is_wildcard(leaf)]
        closed = any(_names_members(leaf) for leaf in named)
        found += [
            case.pattern.lineno
            for case in match.cases
            if closed and _is_wildcard(case.pattern) and not _ends_in_assert_never(case)
        ]
    return found


def test_no_wildcard_stands_for_the_rest_of_a_closed_set(root: Path) -> None:
    found = {path: wildcards(tree) for path, tree in trees(root).items()}
    assert {path: lines for path, lines in found.items() if lines} == {}


@pytest.mark.parametrize(
    ("cases", "lines"),
    [
        ("case A():\n  pass\n case _:\n  pass", [4]),
        ("case A() | B():\n  pass\n case rest:\n  print(rest)", [4]),
        ("case A():\n  pass\n case _ if x:\n  pass\n case _:\n  assert_never(x)", [4]),
        ("case Op.ADD:\n  pass\n case _:\n  pass", [4]),
        ("case A():\n  pass\n case None:\n  pass\n case _:\n  assert_never(x)", []),
        ("case 'a':\n  pass\n case _:\n  pass", []),
        ("case A(), B():\n  pass\n case _:\n  pass", [4]),
        ("case [a, b]:\n  pass\n case _:\n  pass", []),
    ],
)
def test_the_search_finds_them(cases: str, lines: list[int]) -> None:
    assert wildcards(ast.parse(f"match x:\n {cases}\n")) == lines
