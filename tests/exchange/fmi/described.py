"""Tables of variables and descriptions of models, without anything compiled."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from xml.etree import ElementTree

from models.corpus import compiled

from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.fmi.description.fmi2_description import fmi2_description
from lagdsl.exchange.fmi.description.fmi3_description import fmi3_description
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.exchange.fmi.variables.variables import KINDS, Kind, Table, Version, table
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file, with_names
from lagdsl.motion.simulate.initialize import initial_state

TOKEN = "{0123}"


def of_text(text: str) -> Compilation:
    sink = Sink()
    flat = flatten_file(SourceFile("text.lag", text), sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation


def table_of(
    compilation: Compilation,
    version: Version,
    kinds: tuple[Kind, ...] = KINDS,
    ports: Ports | None = None,
    sink: Sink | None = None,
) -> Table:
    engine = engine_of(compilation.program)
    initial = initial_state(compilation.flat, engine, sink=Sink())
    start = Start(initial.t, (*initial.q.tolist(), *initial.qd.tolist(), *initial.z.tolist()))
    program = with_names(compilation)
    whole = replace(compilation, program=program)
    return table(whole, version, start, kinds=kinds, engine=engine, ports=ports, sink=sink)


@cache
def table_of_model(name: str, version: Version) -> Table:
    return table_of(compiled(name).compilation, version)


@cache
def table_of_text(text: str, version: Version) -> Table:
    return table_of(of_text(text), version)


def description(given: Table) -> str:
    if given.version == 2:
        return fmi2_description(given, identifier="Model", source_files=["Model.c"], token=TOKEN)
    return fmi3_description(given, identifier="Model", token=TOKEN)


def tree(given: Table) -> ElementTree.Element:
    return ElementTree.fromstring(description(given))
