"""Derivatives in C, by lag/derivatives.h, of models compiled with everything that has a name."""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from named_models import compiled

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import engine_sources, model_symbol
from lagdsl.engines.runtime.building.compiler import FLAGS, find_compiler, run_compiler
from lagdsl.engines.runtime.building.platforms import library_name, this_machine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.foundation.resources import c_folder, runtime_library_folder
from lagdsl.motion.pipeline import with_names
from lagdsl.motion.simulate.initialize import initial_state

TIME = 0.3
GROUPS = (Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P)
MOVED = (Group.Q, Group.QD, Group.Z, Group.U, Group.P)


@cache
def program_of(path: Path) -> tuple[Program, dict[Group, np.ndarray]]:
    """The program, and the state it starts from, with two contacts closed."""
    compilation = compiled(path)
    program = with_names(compilation)
    engine = NumpyEngine(program)
    start = initial_state(compilation.flat, engine)
    u = engine.evaluate("start", 0.0, np.array(program.layout.defaults))[3]
    closed = [index for index, kind in enumerate(program.layout.kinds) if kind == "contact"][:2]
    w = np.zeros(program.layout.size(Group.W))
    w[closed] = 1.0
    at = {Group.Q: start.q, Group.QD: start.qd, Group.Z: start.z, Group.U: u, Group.W: w}
    return program, {**at, Group.P: np.array(program.layout.defaults)}


@cache
def library(path: Path) -> Any:
    program, _ = program_of(path)
    probe = (Path(__file__).parent / "engines" / "runtime" / "derivatives_probe.c").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        loaded = ctypes.CDLL(str(_linked({**engine_sources(program), "probe.c": probe}, Path(folder))))
    loaded.probe.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, *[ctypes.c_void_p] * 6]
    return loaded


def _linked(sources: Mapping[str, str], folder: Path) -> Path:
    """A library of these, which calls the runtime of the package: that is compiled already. All that counts are its
    values, so nothing is optimized."""
    runtime_library()  # built first where it is missing or old
    for name, text in sources.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    own = [name for name in sources if name.endswith(".c")]
    runtime = runtime_library_folder() / library_name(this_machine().partition("-")[0])
    words = [*FLAGS, "-O0", "-I.", f"-I{c_folder()}", "-shared", "-o", "probe.so", *own, str(runtime), "-lm"]
    run_compiler(find_compiler(), folder, words)
    return folder / "probe.so"


class Probe:
    def __init__(
        self, path: Path, at: dict[Group, np.ndarray], along: dict[Group, np.ndarray], time: float, rate: float
    ):
        program, _ = program_of(path)
        layout = program.layout
        n, m = len(layout.coordinates), len(layout.constraints)
        length = 2 * n + len(layout.states) + len(layout.outputs) + len(layout.definitions) + 3 + 3 * m
        state = np.concatenate([*(at[group] for group in GROUPS), [0.0]])
        direction = np.concatenate([*(along[group] for group in MOVED), [time]])
        values, changes, rows = np.zeros(n + m + 1), np.zeros(length + 1), np.zeros(m + 1)
        rank = ctypes.c_size_t()
        model = ctypes.addressof(ctypes.c_char.in_dll(library(path), model_symbol(program)))
        arrays = (x.ctypes.data for x in (state, direction, values, changes))
        status = library(path).probe(model, rate, TIME, *arrays, ctypes.addressof(rank), rows.ctypes.data)
        assert status == 0
        self.qdd, self.lam, self.changes = values[:n], values[n : n + m], changes[:length]
        self.rows = [int(row) for row in rows[: rank.value]]
