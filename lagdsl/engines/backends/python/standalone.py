"""Parts that all modules in Python have: bodies, the table of functions, files of support code."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence
from pathlib import Path

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import ALONG_MANY, BY_NAME
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.derivation.program.program import Function, Program
from lagdsl.engines.backends.python.body import body, body_name
from lagdsl.engines.backends.python.tables import tables


def single(program: Program) -> list[Function]:
    """The functions of one direction."""
    return [function for function in program.functions if function.name not in ALONG_MANY]


def bodies(program: Program) -> list[str]:
    """The bodies of all functions."""
    return [body(program, function) for function in single(program)]


def named_rows(program: Program) -> str:
    """FUNCTIONS with the names of results: body, (name, length) of every argument, (name, shape) of every result."""
    rows = "".join(f"    {function.name!a}: {_row(program, function)},\n" for function in single(program))
    head = "# body, (name, length) of every argument, (name, shape) of every result"
    return f"{head}\nFUNCTIONS: dict[str, Row] = {{\n{rows}}}\n"


def _row(program: Program, function: Function) -> str:
    names = [result.name for result in BY_NAME[function.name].results]
    results = tuple(zip(names, (block.shape for block in function.results), strict=True))
    return f"({body_name(function.name)}, {signature(program, function)!r}, {results!r})"


def signature(program: Program, function: Function) -> tuple[tuple[str, int | None], ...]:
    """Name and length of every argument; the time has no axis of its own."""
    return tuple(
        (ARGUMENT_NAMES[group], None if group is Group.TIME else program.layout.size(group))
        for group in function.arguments
    )


def module_over(
    program: Program,
    support_files: Sequence[Path],
    introduction: str,
    imports: str,
    last: Sequence[str],
    definition: Callable[[Program, Function], str] = body,
) -> str:
    """The text of a module for a package: tables, files of support code, a definition of each function, then `last`."""
    program = written_out(program)
    written = [definition(program, function) for function in single(program)]
    parts = [introduction, imports, tables(program), *map(support, support_files), *written, named_rows(program)]
    return "\n".join([*parts, *last, ""])


def lengths(program: Program) -> tuple[int, ...]:
    """Of q, qd, z, u, w, p."""
    return tuple(program.layout.size(group) for group in (Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P))


def support(path: Path, dropped: Sequence[str] = ()) -> str:
    """A file as part of a module: without its imports, and without lines that begin as `dropped`, its docstring as a
    comment."""
    text = path.read_text(encoding="utf-8")
    imports = [node for node in ast.parse(text).body if isinstance(node, ast.Import | ast.ImportFrom)]
    imported = {number for node in imports for number in range(node.lineno, (node.end_lineno or node.lineno) + 1)}
    lines = [line for number, line in enumerate(text.splitlines(), start=1) if number not in imported]
    _, docstring, code = "\n".join(lines).split('"""', 2)
    kept = [line for line in code.splitlines() if not line.startswith(tuple(dropped))]
    comment = "\n".join(f"# {line}".rstrip() for line in docstring.strip().splitlines())
    return f"# {'-' * 117}\n{comment}\n\n{_squeezed(kept)}"


def _squeezed(lines: list[str]) -> str:
    kept: list[str] = []
    for line in lines:
        if line or kept[-2:] != ["", ""]:
            kept.append(line)
    return "\n".join(kept).strip("\n") + "\n\n"
