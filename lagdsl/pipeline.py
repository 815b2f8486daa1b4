"""The compiler on one screen: text, tree, flat model, program, structure, initial state.

Every stage reports into one sink and the next one runs only on sound input, so one wrong line is told once.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

from lagdsl.diagnostics import CompilationFailed, Diagnostic, Severity, Sink
from lagdsl.record import record
from lagdsl.runtime.engines.engine import ENGINES, EngineName
from lagdsl.semantics.classes.library import read_source
from lagdsl.semantics.classes.selection import complete_models
from lagdsl.semantics.flatten import flatten
from lagdsl.semantics.wellformed.check import check as check_physics
from lagdsl.source import SourceFile
from lagdsl.syntax import nodes
from lagdsl.syntax.parser import parse

if TYPE_CHECKING:
    from lagdsl.flat.model import FlatModel
    from lagdsl.mechanics.derive import Derivation as GraphDerivation
    from lagdsl.mechanics.derive import Derived
    from lagdsl.program.program import Program
    from lagdsl.runtime.engines.broadcast import BatchEngine
    from lagdsl.structure.structure import Structure

Derivation: TypeAlias = Literal["graph", "textbook"]

_DEEPEST_RECURSION = 20_000


@record(kw_only=True)
class Compilation:
    """A model that compiled: `diagnostics` are its warnings and notes, `derivation` what the graph route made it of."""

    flat: FlatModel
    program: Program
    structure: Structure
    diagnostics: tuple[Diagnostic, ...]
    derivation: GraphDerivation | None = field(default=None, compare=False, repr=False)


def read(source: Path | str, sink: Sink) -> SourceFile | None:
    """The text behind `source`: a path, or a model text (a string that holds a line end or a semicolon, or nothing).

    Anything else is no source, which is reported as a file that cannot be read.
    """
    if not isinstance(source, (str, os.PathLike)):
        reason = f"a path or a model text is a string, this is {type(source).__name__}"
        sink.report("E0134", None, name=repr(source)[:40], reason=reason)
        return None
    if isinstance(source, str) and ("\n" in source or "\r" in source or ";" in source or not source.strip()):
        return SourceFile("<text>", source.replace("\r\n", "\n").replace("\r", "\n").removeprefix("\ufeff"))
    return read_source(Path(source), sink)


def front(
    file: SourceFile, sink: Sink, *, model: str | None = None, structural: Mapping[str, float] | None = None
) -> FlatModel | None:
    """Text to a flat model that passed every check made before deriving; None after errors."""
    unit = tree(file, sink)
    return None if unit is None else elaborate(unit, sink, model=model, structural=structural)


def tree(file: SourceFile, sink: Sink) -> nodes.Unit | None:
    """Text to tree; None after errors."""
    with _deep_recursion():
        unit = parse(file, sink)
    return None if sink.has_errors else unit


def elaborate(
    unit: nodes.Unit, sink: Sink, *, model: str | None = None, structural: Mapping[str, float] | None = None
) -> FlatModel | None:
    """Tree to a flat model that passed every check made before deriving; None after errors."""
    with _deep_recursion():
        flat = flatten(unit, sink, model=model, structural=structural or {})
        if flat is None or sink.has_errors:
            return None
        check_physics(flat, sink)
    return None if sink.has_errors else flat


def derive(flat: FlatModel, derivation: Derivation = "graph") -> Program:
    """The equations of motion as a program, by the route of that name; as they are before ranks are known."""
    program, _ = _derived(flat, derivation)
    return program


def _derived(flat: FlatModel, derivation: Derivation) -> tuple[Program, Derived | None]:
    """With what the graph route made the program from."""
    with _deep_recursion():
        match derivation:
            case "graph":
                from lagdsl.mechanics.derive import derived

                found = derived(flat)
                return found.program, found
            case "textbook":
                from lagdsl.textbook.derive import derive as derive_by_textbook
                from lagdsl.textbook.lower import lower

                return lower(derive_by_textbook(flat), flat), None
            case _:
                raise ValueError(f"there is no derivation `{derivation}`; there are graph, textbook")


def middle(flat: FlatModel, sink: Sink, derivation: Derivation = "graph") -> Compilation | None:
    """Flat model to program, with ranks, degrees of freedom and redundant rows; None after errors."""
    from lagdsl.structure.structure import analyze

    program, derived = _derived(flat, derivation)
    structure = analyze(flat, program, sink)
    if sink.has_errors:
        return None
    if derived is not None:
        from lagdsl.mechanics.derive import solved

        structure = replace(structure, program=solved(derived, structure))
    if flat.invariants or flat.loads:
        from lagdsl.mechanics.derive import form_equations
        from lagdsl.mechanics.idle_loads import report_idle_loads
        from lagdsl.mechanics.invariants import report_proofs

        equations = form_equations(flat) if derived is None else derived.derivation
        report_idle_loads(equations, sink)
        report_proofs(equations, sink)
    return Compilation(
        flat=flat,
        program=structure.program,
        structure=structure,
        diagnostics=sink.diagnostics,
        derivation=None if derived is None else derived.derivation,
    )


def with_names(compilation: Compilation) -> Program:
    """The program of `compilation` with every named value of the model and the derivatives that exported models offer.

    Raises CompilationFailed where there is no such value (E0304, E0308).
    """
    from lagdsl.mechanics.named import with_names as named

    assert compilation.derivation is not None, "only the graph route has named values"
    return named(compilation.derivation, compilation.program)


def engine_of(program: Program, name: EngineName = "auto") -> BatchEngine:
    """What computes the functions of `program`: `tape` at once and without a compiler, `c` compiled for this processor,
    `auto` the tape, and C where that pays; `numpy` functions in Python, to compare with.

    Raises CompilationFailed where `c` is asked for and no C compiler is found.
    """
    match name:
        case "auto":
            from lagdsl.runtime.engines.auto_engine import AutoEngine

            return AutoEngine(program)
        case "tape":
            from lagdsl.runtime.engines.tape_engine import TapeEngine

            return TapeEngine(program)
        case "numpy":
            from lagdsl.runtime.engines.numpy_engine import NumpyEngine

            return NumpyEngine(program)
        case "c":
            from lagdsl.runtime.engines.c_engine import CEngine

            return CEngine(program)
        case _:
            raise ValueError(f"there is no engine `{name}`; there are {', '.join(ENGINES)}")


def check(file: SourceFile, *, model: str | None = None) -> tuple[tuple[Diagnostic, ...], Compilation | None]:
    """Everything that can be found before the first time step, the initial state included.

    Without `model` the faults of the file's other models are told, too: those that show before deriving.
    """
    sink = Sink()
    unit = tree(file, sink)
    if unit is None:
        return sink.diagnostics, None
    compilation = None
    try:
        flat = elaborate(unit, sink, model=model)
        compilation = middle(flat, sink) if flat is not None else None
        if compilation is not None:
            from lagdsl.simulate.first_instant import check_first_instant
            from lagdsl.simulate.initialize import initial_state

            engine = engine_of(compilation.program)
            initial = initial_state(compilation.flat, engine, sink=sink)
            if not sink.has_errors:
                check_first_instant(compilation.flat, engine, initial, sink)
        found = sink.diagnostics
    except CompilationFailed as failure:
        found = findings(sink, failure)
    for name in complete_models(unit)[:-1] if model is None else ():
        other = Sink()
        elaborate(unit, other, model=name)
        found = tuple(dict.fromkeys([*found, *other.diagnostics]))
    return found, None if any(d.severity is Severity.ERROR for d in found) else compilation


def findings(sink: Sink, failure: CompilationFailed) -> tuple[Diagnostic, ...]:
    """Everything that is known of a model: what the early stages collected and what a later one raised."""
    return tuple(dict.fromkeys([*sink.diagnostics, *failure.diagnostics]))


@contextmanager
def _deep_recursion() -> Iterator[None]:
    """Room for expressions nested as deeply as the parser accepts."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, _DEEPEST_RECURSION))
    try:
        yield
    finally:
        sys.setrecursionlimit(limit)
