"""Every models/*.lag and models/library/*.lag (`library/name`), compiled by both routes, and random states of it."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.lower import lower
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.verify import states
from lagdsl.exchange.verify.states import Arrays
from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file, read

ROOT = Path(__file__).parents[2]
MODELS = sorted(
    path.relative_to(ROOT / "models").with_suffix("").as_posix()
    for pattern in ("*.lag", "library/*.lag")
    for path in (ROOT / "models").glob(pattern)
)
STATES = 50


def path_of(name: str) -> Path:
    return ROOT / "models" / f"{name}.lag"


@cache
def expectations(name: str) -> dict[str, Any]:
    path = Path(__file__).parent / f"{name}.toml"
    return tomllib.loads(path.read_text(encoding="utf-8"))


@dataclass(frozen=True)
class Compiled:
    source: SourceFile
    flat: FlatModel
    compilation: Compilation
    diagnostics: tuple[Diagnostic, ...]

    @property
    def graph(self) -> Program:
        return self.compilation.program


@cache
def compiled(name: str) -> Compiled:
    sink = Sink()
    source = read(path_of(name), sink)
    assert source is not None
    flat = flatten_file(source, sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return Compiled(source, compilation.flat, compilation, sink.diagnostics)


@cache
def textbook(name: str) -> Program:
    flat = compiled(name).flat
    return lower(derive(flat), flat)


@cache
def numpy_engine(name: str) -> Engine:
    from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

    return NumpyEngine(compiled(name).graph)


@cache
def c_engine(name: str) -> Engine:
    from lagdsl.engines.runtime.engines.c_engine import CEngine

    return CEngine(compiled(name).graph)


# ---- states ----------------------------------------------------------------------------------------------------------


@cache
def random_states(name: str) -> Arrays:
    """STATES random states about the start, on the constraints, by group."""
    found = states.random_states(compiled(name).flat, compiled(name).graph, STATES)
    count = len(found.get(Group.TIME, ()))
    assert count == STATES, f"{name}: only {count} regular states found"
    return found


def arguments(program: Program, function: str, arrays: Arrays, row: int) -> list[Any]:
    """Arguments of a function at one of the random states, as an engine takes them."""
    return [
        float(arrays[group][row]) if group is Group.TIME else np.ascontiguousarray(arrays[group][row])
        for group in program.function(function).arguments
    ]
