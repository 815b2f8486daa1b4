"""The compiler on one screen.

    SourceFile -parse-> Unit -flatten-> FlatModel -form_equations-> Equations -arrange-> Program -analyze-> Structure,
    and with it -solve-> Program -emit-> Artifact

Each arrow is a function of the product before it, and each product is immutable to those who come after. Every stage
reports into one sink and the next one runs only on sound input, so one wrong line is reported once.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Collection, Mapping
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

from lagdsl.foundation.collection import without_collection
from lagdsl.foundation.diagnostics import CompilationFailed, Diagnostic, Severity, Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.semantics.classes.selection import complete_models
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.semantics.wellformed.check import check as check_physics
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse
from lagdsl.language.syntax.recursion import deep_recursion

if TYPE_CHECKING:
    from lagdsl.derivation.mechanics.equations import Equations
    from lagdsl.derivation.program.program import Program
    from lagdsl.derivation.structure.points import Geometry
    from lagdsl.derivation.structure.structure import Structure
    from lagdsl.language.flat.model import FlatModel
    from lagdsl.language.settings.structure import Reading

Route: TypeAlias = Literal["graph", "textbook"]
"""The derivation of the functions: on the graph, or literally as in a textbook, by SymPy."""


@record(kw_only=True)
class Compilation:
    """A model that compiled, with the product of every stage; `diagnostics` are its warnings and notes. `program` comes
    from `equations` where `route` is `graph`."""

    flat: FlatModel
    equations: Equations = field(compare=False, repr=False)
    structure: Structure
    program: Program
    diagnostics: tuple[Diagnostic, ...]
    route: Route = "graph"


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


def parse_file(file: SourceFile, sink: Sink) -> nodes.Unit | None:
    """None after errors."""
    with deep_recursion():
        unit = parse(file, sink)
    return None if sink.has_errors else unit


@without_collection()
def flatten_unit(
    unit: nodes.Unit,
    sink: Sink,
    *,
    model: str | None = None,
    structural: Mapping[str, float] | None = None,
    unknowns: Collection[str] = (),
) -> FlatModel | None:
    """The flat model of one class, which passed every check made before deriving; None after errors.

    `model` names one of several classes; `structural` gives structural parameters other values, in SI units.
    `unknowns` are coordinates that stay unknowns where their joint is cut.
    """
    numbers = structural or {}
    with deep_recursion():
        flat = flatten(unit, sink, model=model, structural=lambda each, _: numbers.get(each.name), unknowns=unknowns)
        if flat is not None and numbers:
            from lagdsl.language.settings.structure import check_structure

            check_structure(flat, numbers, sink)
        return _checked(flat, sink)


def _checked(flat: FlatModel | None, sink: Sink) -> FlatModel | None:
    """The same after the checks of its physics; None after errors."""
    if flat is not None and not sink.has_errors:
        check_physics(flat, sink)
    return None if sink.has_errors else flat


@without_collection()
def flatten_set(unit: nodes.Unit, sink: Sink, *, model: str | None, pairs: Mapping[str, str]) -> FlatModel | None:
    """The same with `pairs`, `{"m": "2 kg"}`, as if they stood in the text: nothing is said of the values there.

    Raises SettingError for unknown names and values that do not fit.
    """
    from lagdsl.language.flat.fixed_parameters import with_values
    from lagdsl.language.settings.settings import settings

    if not pairs:
        return flatten_unit(unit, sink, model=model)
    with deep_recursion():
        flat = _structured(unit, sink, model, pairs)
        if flat is None:
            return None
        chosen = settings(flat, pairs, sink)
        return _checked(with_values(flat, chosen.parameters, chosen.start), sink)


def _structured(
    unit: nodes.Unit, sink: Sink, model: str | None, pairs: Mapping[str, str], read: Reading | None = None
) -> FlatModel | None:
    """The flat model with the structural parameters of `pairs`, before physics is checked; coordinates of cut joints
    whose starts are set are unknowns of it."""
    from lagdsl.language.settings.settings import one_value
    from lagdsl.language.settings.structure import StructuralTexts, check_structure
    from lagdsl.language.settings.unknowns import coordinates_of

    texts = StructuralTexts(pairs, read or (lambda target, text: one_value(target, text).value))
    flat = flatten(unit, sink, model=model, structural=texts.value, unknowns=coordinates_of(pairs))
    if flat is not None:
        check_structure(flat, texts.of(flat), sink)
    return None if sink.has_errors else flat


@without_collection()
def flatten_for_runs(
    file: SourceFile, sink: Sink, *, model: str | None, pairs: Mapping[str, str], read: Reading | None = None
) -> FlatModel | None:
    """The flat model with the structural parameters of `pairs` only, as `read` reads them (one value unless given): all
    other values are for its runs. Raises SettingError for values that do not fit."""
    unit = parse_file(file, sink)
    with deep_recursion():
        return _checked(_structured(unit, sink, model, pairs, read), sink) if unit is not None else None


def flatten_file(
    file: SourceFile, sink: Sink, *, model: str | None = None, structural: Mapping[str, float] | None = None
) -> FlatModel | None:
    """Both in one."""
    unit = parse_file(file, sink)
    return None if unit is None else flatten_unit(unit, sink, model=model, structural=structural)


@without_collection()
def compile_flat(flat: FlatModel, sink: Sink, route: Route = "graph") -> Compilation | None:
    """The equations of `flat`, their ranks and their program; None after errors. The model of the result has the
    balances of forces along directions without inertia among its constraints.

    Raises CompilationFailed where the equations need a derivative that does not exist (E0304, E0308).
    """
    from lagdsl.derivation.mechanics.equations import form_equations
    from lagdsl.derivation.mechanics.idle_loads import report_idle_loads
    from lagdsl.derivation.mechanics.invariants import report_proofs
    from lagdsl.derivation.mechanics.solve import solve
    from lagdsl.derivation.structure.structure import analyze, constraint_space, flag_redundant

    with deep_recursion():
        equations = form_equations(flat)
        program = _arrange(equations, route)
    space = constraint_space(flat, program)
    if any(space.row_factors != 1.0):
        equations, program, space = _multiplied(equations, program, space, sink)
    structure = analyze(flat, space, sink)
    if sink.has_errors:
        return None
    if lacking := [each for each in structure.balances if each not in flat.constraints]:
        return compile_flat(replace(flat, constraints=(*flat.constraints, *lacking)), sink, route)
    program = flag_redundant(program, structure)
    if route == "graph" and flat.constraints:
        program = solve(equations, program, structure)
    if sys.flags.dev_mode:
        from lagdsl.derivation.program.verify import verify

        verify(program)
    report_idle_loads(equations, sink)
    report_proofs(equations, sink)
    return Compilation(
        flat=flat,
        equations=equations,
        structure=structure,
        program=program,
        diagnostics=sink.diagnostics,
        route=route,
    )


def _multiplied(
    equations: Equations, program: Program, space: Geometry, sink: Sink
) -> tuple[Equations, Program, Geometry]:
    """All with the rows of constraints that are far smaller than others multiplied, which N0612 tells."""
    from lagdsl.derivation.mechanics import equations as formed
    from lagdsl.derivation.program.passes.row_factors import with_row_factors
    from lagdsl.derivation.structure.constraints import report_row_factors
    from lagdsl.derivation.structure.functions import ProgramFunctions

    factors = space.row_factors.tolist()
    report_row_factors(equations.flat, space.row_factors, sink)
    program = with_row_factors(program, factors)
    return formed.with_row_factors(equations, factors), program, space.multiplied(ProgramFunctions(program))


def _arrange(equations: Equations, route: Route) -> Program:
    """The functions of a model before its ranks are known."""
    match route:
        case "graph":
            from lagdsl.derivation.mechanics.arrange import arrange

            return arrange(equations)
        case "textbook":
            from lagdsl.derivation.mechanics.arrange import with_events
            from lagdsl.derivation.textbook.derive import derive
            from lagdsl.derivation.textbook.lower import lower

            return with_events(equations, lower(derive(equations.flat), equations.flat, equations.graph))
        case _:
            raise ValueError(f"there is no derivation `{route}`; there are graph, textbook")


def compile_observed(compilation: Compilation, flat: FlatModel) -> Compilation:
    """`flat`, the model of `compilation` with other outputs and invariants and with further parameters that start
    values may name: nothing is formed, ranked or solved again.

    Raises CompilationFailed where an output needs a derivative that does not exist (E0304, E0308).
    """
    from lagdsl.derivation.mechanics.observed import with_observed

    assert compilation.route == "graph", "only the graph route forms further outputs"
    with deep_recursion():
        equations, program = with_observed(compilation.equations, compilation.program, flat)
    return replace(compilation, flat=flat, equations=equations, program=program)


def with_names(compilation: Compilation) -> Program:
    """The program of `compilation` with every named value of the model and the derivatives that exported models offer.

    Raises CompilationFailed where there is no such value (E0304, E0308).
    """
    from lagdsl.derivation.mechanics.named import with_names as named

    assert compilation.route == "graph", "only the graph route has named values"
    return named(compilation.equations, compilation.program)


def check(
    file: SourceFile, *, model: str | None = None, pairs: Mapping[str, str] | None = None
) -> tuple[tuple[Diagnostic, ...], Compilation | None]:
    """Everything that can be found before the first time step, the initial state included.

    `pairs`, `{"m": "2 kg"}`, count as if they stood in the text; they raise SettingError where they do not fit. Without
    `model` the faults of the file's other models are told, too: those that show before deriving.
    """
    sink = Sink()
    unit = parse_file(file, sink)
    if unit is None:
        return sink.diagnostics, None
    compilation = None
    try:
        flat = flatten_set(unit, sink, model=model, pairs=pairs or {})
        compilation = compile_flat(flat, sink) if flat is not None else None
        if compilation is not None:
            from lagdsl.engines.runtime.engines.selection import engine_of
            from lagdsl.motion.simulate.first_instant import check_first_instant
            from lagdsl.motion.simulate.initialize import initial_state

            engine = engine_of(compilation.program)
            initial = initial_state(compilation.flat, engine, sink=sink)
            if not sink.has_errors:
                check_first_instant(compilation.flat, engine, initial, sink)
        found = sink.diagnostics
    except CompilationFailed as failure:
        found = findings(sink, failure)
    for name in complete_models(unit)[:-1] if model is None else ():
        other = Sink()
        flatten_unit(unit, other, model=name)
        found = tuple(dict.fromkeys([*found, *other.diagnostics]))
    return found, None if any(d.severity is Severity.ERROR for d in found) else compilation


def findings(sink: Sink, failure: CompilationFailed) -> tuple[Diagnostic, ...]:
    """Everything that is known of a model: what the early stages collected and what a later one raised."""
    return tuple(dict.fromkeys([*sink.diagnostics, *failure.diagnostics]))
