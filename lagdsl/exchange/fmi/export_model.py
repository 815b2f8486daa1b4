"""Input of an FMU export: the model with all functions that importers need, its start, and its variables."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import stem_of
from lagdsl.engines.backends.start import Start, start_of
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.fmi.description.description import Attribution
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.exchange.fmi.variables.variables import Kind, Table, Version, table
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.limits import check_limits
from lagdsl.motion.pipeline import Compilation, compile_flat, with_names
from lagdsl.motion.simulate.initialize import initial_state


@record(kw_only=True)
class ExportModel:
    """`compilation` has the program with every named value and the chosen defaults, `plain` the same without those
    values. `chosen` are further start values by name, `stem` names files and symbols."""

    compilation: Compilation
    plain: Program
    chosen: Mapping[str, float]
    start: Start
    table: Table
    attribution: Attribution
    stem: str

    @property
    def program(self) -> Program:
        return self.compilation.program


def export_model(
    compilation: Compilation,
    version: Version,
    kinds: Collection[Kind],
    parameters: Mapping[str, float],
    start: Mapping[str, float],
    sink: Sink,
    engine: EngineName = "auto",
    ports: Ports | None = None,
    attribution: Attribution | None = None,
) -> ExportModel:
    """`parameters` and `start` (SI) become the defaults, `engine` finds where the motion starts. Raises
    CompilationFailed where nothing starts from them."""
    graph = _by_graph(compilation)
    plain = _with_defaults(graph.program, parameters)
    defaults = plain.layout.defaults
    names = (slot.name for slot in plain.layout.parameters)
    check_limits(graph.flat, dict(zip(names, defaults, strict=True)), sink)
    _raise(sink)
    computing = engine_of(plain, engine)
    with np.errstate(all="ignore"):
        initial = initial_state(graph.flat, computing, start=start, sink=sink)
    _raise(sink)
    state = (*initial.q.tolist(), *initial.qd.tolist(), *initial.z.tolist())
    where = start_of(graph.flat, initial.t, [float(value) for value in state], start)
    whole = replace(graph, program=_with_defaults(with_names(graph), parameters))
    variables = table(
        whole,
        version,
        where,
        kinds=kinds,
        engine=computing,
        redundant=initial.redundant,
        parameters=[float(value) for value in initial.p],
        ports=ports,
        sink=sink,
    )
    _raise(sink)
    return ExportModel(
        compilation=whole,
        plain=plain,
        chosen=start,
        start=where,
        table=variables,
        attribution=Attribution() if attribution is None else attribution,
        stem=stem_of(whole.program),
    )


def _by_graph(compilation: Compilation) -> Compilation:
    """The same model by the route that knows named values and derivatives."""
    if compilation.route == "graph":
        return compilation
    found = compile_flat(compilation.flat, Sink())
    assert found is not None, "one route found the model sound and the other did not"
    return found


def _with_defaults(program: Program, parameters: Mapping[str, float]) -> Program:
    layout = program.layout
    pairs = zip(layout.parameters, layout.defaults, strict=True)
    defaults = tuple(float(parameters.get(slot.name, value)) for slot, value in pairs)
    return replace(program, layout=replace(layout, defaults=defaults))


def _raise(sink: Sink) -> None:
    if sink.has_errors:
        raise CompilationFailed(sink.diagnostics)
