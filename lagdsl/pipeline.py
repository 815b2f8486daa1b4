"""The compiler on one screen: text, tree, flat model, program, structure.

Every stage reports into one sink and the next one runs only on sound input, so one wrong line is told once.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

from lagdsl.diagnostics import Diagnostic, Sink
from lagdsl.semantics.flatten import flatten
from lagdsl.semantics.library import read_source
from lagdsl.semantics.wellformed import check as check_wellformed
from lagdsl.source import SourceFile
from lagdsl.syntax.parser import parse

if TYPE_CHECKING:
    from lagdsl.mechanics.structure import Structure
    from lagdsl.program.program import Program
    from lagdsl.semantics.flat_model import FlatModel

Derivation: TypeAlias = Literal["graph", "textbook"]

_DEEPEST_RECURSION = 20_000


@dataclass(frozen=True, slots=True, kw_only=True)
class Compilation:
    """A model that compiled: `diagnostics` are its warnings and notes."""

    flat: FlatModel
    program: Program
    structure: Structure
    diagnostics: tuple[Diagnostic, ...]


def read(source: Path | str, sink: Sink) -> SourceFile | None:
    """The text behind `source`: a path, or a model text (a string that holds a line end or a semicolon)."""
    if isinstance(source, str) and ("\n" in source or ";" in source):
        return SourceFile("<text>", source.replace("\r\n", "\n").removeprefix("\ufeff"))
    return read_source(Path(source), sink)


def front(
    file: SourceFile, sink: Sink, *, model: str | None = None, structural: Mapping[str, float] | None = None
) -> FlatModel | None:
    """Text to a flat model that passed every check made before deriving; None after errors."""
    with _deep_recursion():
        unit = parse(file, sink)
        if unit is None or sink.has_errors:
            return None
        flat = flatten(unit, sink, model=model, structural=structural or {})
        if flat is None or sink.has_errors:
            return None
        check_wellformed(flat, sink)
    return None if sink.has_errors else flat


def derive(flat: FlatModel, derivation: Derivation = "graph") -> Program:
    """The equations of motion as a program, by the route of that name."""
    with _deep_recursion():
        match derivation:
            case "graph":
                from lagdsl.mechanics.derive import derive as derive_on_graph

                return derive_on_graph(flat)
            case "textbook":
                from lagdsl.textbook.derive import derive as derive_by_textbook
                from lagdsl.textbook.lower import lower

                return lower(derive_by_textbook(flat), flat)


def middle(flat: FlatModel, sink: Sink, derivation: Derivation = "graph") -> Compilation | None:
    """Flat model to program, with ranks, degrees of freedom and redundant rows; None after errors."""
    from lagdsl.mechanics.structure import analyze

    structure = analyze(flat, derive(flat, derivation), sink)
    if sink.has_errors:
        return None
    return Compilation(flat=flat, program=structure.program, structure=structure, diagnostics=sink.diagnostics)


def compile_source(
    source: Path | str,
    *,
    model: str | None = None,
    structural: Mapping[str, float] | None = None,
    derivation: Derivation = "graph",
) -> Compilation:
    """A path or text to a program. Raises CompilationFailed with everything that was found."""
    sink = Sink()
    file = read(source, sink)
    flat = front(file, sink, model=model, structural=structural) if file is not None else None
    compilation = middle(flat, sink, derivation) if flat is not None else None
    sink.raise_if_errors()
    assert compilation is not None, "internal error: a stage gave up without saying why"
    return compilation


@contextmanager
def _deep_recursion() -> Iterator[None]:
    """Room for expressions nested as deeply as the parser accepts."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, _DEEPEST_RECURSION))
    try:
        yield
    finally:
        sys.setrecursionlimit(limit)
