"""Every models/*.lag and models/library/*.lag (`library/name`), compiled by both routes, and random states of it."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from lagdsl.diagnostics import Diagnostic, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.graph.evaluate import evaluate_with_size
from lagdsl.graph.operation import Group
from lagdsl.pipeline import Compilation, derive, front, middle, read
from lagdsl.program.program import Program
from lagdsl.runtime.engine import Engine
from lagdsl.source import SourceFile

ROOT = Path(__file__).parents[2]
MODELS = sorted(
    path.relative_to(ROOT / "models").with_suffix("").as_posix()
    for pattern in ("*.lag", "library/*.lag")
    for path in (ROOT / "models").glob(pattern)
)
STATES = 50
Arrays = dict[Group, Any]


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
    flat = front(source, sink)
    assert flat is not None, sink.diagnostics
    compilation = middle(flat, sink)
    assert compilation is not None, sink.diagnostics
    return Compiled(source, flat, compilation, sink.diagnostics)


@cache
def textbook(name: str) -> Program:
    return derive(compiled(name).flat, "textbook")


@cache
def numpy_engine(name: str) -> Engine:
    from lagdsl.runtime.numpy_engine import NumpyEngine

    return NumpyEngine(compiled(name).graph)


@cache
def c_engine(name: str) -> Engine:
    from lagdsl.runtime.c_engine import CEngine

    return CEngine(compiled(name).graph)


# ---- states ----------------------------------------------------------------------------------------------------------


@cache
def random_states(name: str) -> Arrays:
    """STATES random states about the start, on the constraints; those where something is singular are drawn again.

    Arrays by group, one row per state; accelerations, multipliers and directions too, so that every function can be
    evaluated.
    """
    random = np.random.default_rng(20)
    rows: list[Arrays] = []
    for _ in range(40 * STATES):
        state = _draw(name, random)
        if _regular(name, state):
            rows.append(state)
        if len(rows) == STATES:
            return {group: np.array([row[group] for row in rows]) for group in rows[0]}
    raise AssertionError(f"{name}: only {len(rows)} regular states found")


def _draw(name: str, random: np.random.Generator) -> Arrays:
    program = compiled(name).graph
    layout = program.layout
    p = np.array(layout.defaults) * random.uniform(0.9, 1.1, len(layout.defaults))
    p = np.where([parameter_is_whole(name, slot.name) for slot in layout.parameters], layout.defaults, p)
    t = random.uniform(0.0, 1.0)
    q, qd, z, u = (np.asarray(block, dtype=float) for block in values(program, "start", {Group.TIME: t, Group.P: p}))
    state: Arrays = {
        Group.TIME: t,
        Group.Q: about(q, random),
        Group.QD: about(qd, random),
        Group.Z: about(z, random),
        Group.U: about(u, random),
        Group.W: random_discretes(name, t, p, random),
        Group.P: p,
    }
    state = on_constraints(program, state)
    sizes = {g: layout.size(g) for g in Group if g not in (Group.RELEASE, Group.RELEASE_RATE)}
    return state | {g: random.normal(size=n) for g, n in sizes.items() if g not in state}


def random_discretes(name: str, t: Any, p: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """(..., nw): contacts open and closed, relations true and false, numbers about their start; for each t and p."""
    layout, flat = compiled(name).graph.layout, compiled(name).flat
    if not layout.discretes:
        return np.zeros((*np.shape(t), 0))
    w = np.asarray(values(compiled(name).graph, "discrete_start", {Group.TIME: t, Group.P: p})[0], dtype=float)
    whole = {item.name: item.kind == "Integer" for item in flat.events.discretes if item.kind != "Boolean"}
    for k, (slot, kind) in enumerate(zip(layout.discretes, layout.kinds, strict=True)):
        if kind == "impacts" or whole.get(slot.name):
            w[..., k] += random.integers(0, 4, np.shape(t))
        elif slot.name in whole:
            w[..., k] = about(w[..., k : k + 1], random)[..., 0]
        else:
            w[..., k] = random.integers(0, 2, np.shape(t))
    return w


def parameter_is_whole(name: str, parameter: str) -> bool:
    """Booleans and integers keep their value."""
    return next(p.kind != "Real" for p in compiled(name).flat.parameters if p.name == parameter)


def about(start: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Within a third of the start value; where that is zero, of one SI unit or of the largest neighbor."""
    size = np.max(np.abs(start), axis=-1, initial=0.0, keepdims=True)
    scale = np.where(start != 0, np.abs(start), np.where(size > 0, size, 1.0))
    return np.asarray(start + 0.3 * scale * random.uniform(-1, 1, start.shape))


def on_constraints(program: Program, state: Arrays) -> Arrays:
    """The state moved onto the constraints: Newton's method in the positions, one step in the rates."""
    q, qd = state[Group.Q], state[Group.QD]
    for _ in range(30):
        phi, jacobian = values(program, "position_constraint", state | {Group.Q: q})
        if not (phi.size and np.all(np.isfinite(jacobian)) and np.all(np.isfinite(phi))):
            break
        step = np.linalg.pinv(jacobian, rcond=1e-10) @ phi
        q = q - step
        if np.max(np.abs(step)) <= 1e-15 * np.max(np.abs(q)):
            break
    residual, jacobian = values(program, "velocity_constraint", state | {Group.Q: q, Group.QD: qd})
    if residual.size and np.all(np.isfinite(jacobian)):
        qd = qd - np.linalg.pinv(jacobian, rcond=1e-10) @ residual
    return state | {Group.Q: q, Group.QD: qd}


def _regular(name: str, state: Arrays) -> bool:
    """Everything is finite and the equations determine the accelerations well."""
    program = compiled(name).graph
    blocks = values(program, "dynamics", state)
    if not all(np.all(np.isfinite(block)) for block in blocks):
        return False
    others = [block for f in program.functions for block in values(program, f.name, state)]
    if not all(np.all(np.isfinite(block)) for block in others):
        return False
    phi, _ = values(program, "position_constraint", state)
    if phi.size and np.max(np.abs(phi)) > 1e-9:
        return False
    mass, _, jacobian, _ = blocks
    jacobian = jacobian[independent_rows(program, jacobian)]
    matrix = saddle_point(mass, jacobian)
    if not matrix.size:
        return True
    scale = 1 / np.sqrt(np.maximum(np.max(np.abs(matrix), axis=1), 1e-300))
    return bool(np.linalg.cond(scale[:, None] * matrix * scale) < 1e6)


def independent_rows(program: Program, jacobian: np.ndarray) -> list[int]:
    """Rows that are not redundant; those of open contacts, and those that a discrete has switched off, are zero."""
    return [i for i, redundant in enumerate(program.layout.redundant) if not redundant and np.any(jacobian[i])]


def saddle_point(mass: np.ndarray, jacobian: np.ndarray) -> np.ndarray:
    rows = jacobian.shape[0]
    return np.block([[mass, -jacobian.T], [jacobian, np.zeros((rows, rows))]])


# ---- values ----------------------------------------------------------------------------------------------------------


def values(program: Program, function: str, arrays: Arrays) -> list[np.ndarray]:
    """Result blocks of a function at one state or at rows of states, by the graph's own evaluator."""
    return [block for block, _ in values_with_size(program, function, arrays)]


def values_with_size(program: Program, function: str, arrays: Arrays) -> list[tuple[np.ndarray, np.ndarray]]:
    """The same, each with the size of the terms it is the sum of."""
    definition = program.function(function)
    leading = np.shape(arrays[Group.TIME])
    given = {group: arrays[group] for group in definition.arguments}
    roots = [element for block in definition.results for element in block.elements]
    pairs = evaluate_with_size(program.graph, roots, given)
    columns = [_stacked([pair[i] for pair in pairs], leading) for i in (0, 1)]
    blocks, at = [], 0
    for block in definition.results:
        end = at + len(block.elements)
        shape = leading + block.shape
        blocks.append((columns[0][..., at:end].reshape(shape), columns[1][..., at:end].reshape(shape)))
        at = end
    return blocks


def _stacked(numbers: list[Any], leading: tuple[int, ...]) -> np.ndarray:
    if not numbers:
        return np.zeros((*leading, 0))
    if not leading:
        return np.array(numbers)
    return np.stack([np.broadcast_to(number, leading) for number in numbers], axis=-1)


def arguments(program: Program, function: str, arrays: Arrays, row: int) -> list[Any]:
    """Arguments of a function at one of the random states, as an engine takes them."""
    return [
        float(arrays[group][row]) if group is Group.TIME else np.ascontiguousarray(arrays[group][row])
        for group in program.function(function).arguments
    ]
