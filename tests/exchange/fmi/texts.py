"""FMUs of texts in tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import fmpy

from fmi.exported import Exported, export_quickly, place
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import compile_flat, flatten_file


@cache
def exported_text(text: str, version: int, *, clocks: bool = False, scalar: bool = False) -> Exported:
    """`scalar`: entries of arrays are variables of their own in FMI 3, too."""
    flat = _flat(text)
    folder = place() / f"{flat.name}-{version}{'-clocks' * clocks}{'-scalar' * scalar}"
    path = folder.with_suffix(".fmu")
    _export(flat, path, version, Ports(clocks=clocks, scalar=scalar))
    fmpy.extract(str(path), str(folder))
    return Exported(path, folder)


def export_text(text: str, path: Path, version: int = 2, **options: Any) -> None:
    """The FMU of a text, as `export_quickly` writes it."""
    _export(_flat(text), path, version, **options)


def _flat(text: str) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("text.lag", text), sink)
    assert flat is not None, sink.diagnostics
    return flat


def _export(flat: FlatModel, path: Path, version: int, ports: Ports | None = None, **options: Any) -> None:
    sink = Sink()
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    export_quickly(compilation, path, version=version, ports=ports, **options)
