"""FMUs of texts in tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import fmpy

from fmi.exported import Exported, export_quickly, place
from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.fmi.variables.ports import Ports
from lagdsl.pipeline import compile_flat, flatten_file
from lagdsl.source import SourceFile


@cache
def exported_text(text: str, version: int, *, clocks: bool = False) -> Exported:
    flat = _flat(text)
    folder = place() / f"{flat.name}-{version}{'-clocks' * clocks}"
    path = folder.with_suffix(".fmu")
    _export(flat, path, version, clocks=clocks)
    fmpy.extract(str(path), str(folder))
    return Exported(path, folder)


def export_text(text: str, path: Path, version: int = 2) -> None:
    """The FMU of a text, as `export_quickly` writes it."""
    _export(_flat(text), path, version)


def _flat(text: str) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("text.lag", text), sink)
    assert flat is not None, sink.diagnostics
    return flat


def _export(flat: FlatModel, path: Path, version: int, *, clocks: bool = False) -> None:
    sink = Sink()
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    export_quickly(compilation, path, version=version, ports=Ports(clocks=clocks))
