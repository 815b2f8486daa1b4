"""FMUs of texts in tests."""

from __future__ import annotations

from functools import cache

import fmpy

from fmi.exported import Exported, place
from lagdsl.diagnostics import Sink
from lagdsl.fmi.export import export
from lagdsl.fmi.variables.ports import Ports
from lagdsl.pipeline import compile_flat, flatten_file
from lagdsl.source import SourceFile


@cache
def exported_text(text: str, version: int, *, clocks: bool = False) -> Exported:
    sink = Sink()
    flat = flatten_file(SourceFile("text.lag", text), sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    folder = place() / f"{flat.name}-{version}{'-clocks' * clocks}"
    path = folder.with_suffix(".fmu")
    export(compilation, path, version=version, documented=False, ports=Ports(clocks=clocks))
    fmpy.extract(str(path), str(folder))
    return Exported(path, folder)
