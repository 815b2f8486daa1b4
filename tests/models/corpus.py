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
from lagdsl.pipeline import Compilation, compile_flat, flatten_file, read
from lagdsl.program.program import Program
from lagdsl.runtime.engines.engine import Engine
from lagdsl.source import SourceFile
from lagdsl.textbook.derive import derive
from lagdsl.textbook.lower import lower

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
    flat = flatten_file(source, sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return Compiled(source, flat, compilation, sink.diagnostics)


@cache
def textbook(name: str) -> Program:
    flat = compiled(name).flat
    return lower(derive(flat), flat)


@cache
def numpy_engine(name: str) -> Engine:
    from lagdsl.runtime.engines.numpy_engine import NumpyEngine

    return NumpyEngine(compiled(name).graph)


@cache
def c_engine(name: str) -> Engine:
    from lagdsl.runtime.engines.c_engine import CEngine

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
    for _ in range(40):
        drawn = [_draw(name, random) for _ in range(STATES - len(rows))]
        rows += [state for state, sound in zip(drawn, _sound(name, _by_group(drawn)), strict=True) if sound]
        if len(rows) == STATES:
            return _by_group(rows)
    raise AssertionError(f"{name}: only {len(rows)} regular states found")


def _by_group(rows: list[Arrays]) -> Arrays:
    return {group: np.array([row[group] for row in rows]) for group in rows[0]}


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
    """(..., nw): contacts open and closed, relations true and false, numbers about their start; for each t and p.

    Entries that follow from the time alone are those of t: others stand for no instant.
    """
    layout, flat = compiled(name).graph.layout, compiled(name).flat
    if not layout.discretes:
        return np.zeros((*np.shape(t), 0))
    w = np.asarray(values(compiled(name).graph, "discrete_start", {Group.TIME: t, Group.P: p})[0], dtype=float)
    whole = {item.name: item.kind == "Integer" for item in flat.events.discretes if item.kind != "Boolean"}
    for k, (slot, kind) in enumerate(zip(layout.discretes, layout.kinds, strict=True)):
        if kind == "timed":
            continue
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


def _sound(name: str, states: Arrays) -> np.ndarray:
    """Flags of the states that are regular, with all functions finite there."""
    program = compiled(name).graph
    finite = regular(program, states)
    for function in program.functions:
        for block in values(program, function.name, states):
            never = np.isposinf(block) if function.name == "time_event" else False  # an event that is not to come
            finite &= (np.isfinite(block) | never).reshape(len(block), -1).all(axis=1)
    return finite


def regular(program: Program, states: Arrays) -> np.ndarray:
    """At which of many states everything is finite, on the constraints, and determines the accelerations well."""
    blocks = values(program, "dynamics", states)
    finite = np.ones(len(states[Group.TIME]), dtype=bool)
    for block in blocks:
        finite &= np.isfinite(block).reshape(len(block), -1).all(axis=1)
    phi, _ = values(program, "position_constraint", states)
    finite &= np.max(np.abs(np.nan_to_num(phi, nan=1.0)), axis=1, initial=0.0) < 1e-9
    for i in np.flatnonzero(finite):
        rows = blocks[2][i]
        matrix = saddle_point(blocks[0][i], rows[independent_rows(program, rows)])
        if matrix.size:
            scale = 1 / np.sqrt(np.maximum(np.max(np.abs(matrix), axis=1), 1e-300))
            finite[i] = np.linalg.cond(scale[:, None] * matrix * scale) < 1e6
    return finite


def independent_rows(program: Program, jacobian: np.ndarray) -> list[int]:
    """Rows of (..., nc, nq) that are not redundant; those of open contacts, and those that a discrete has switched off,
    are zero."""
    return [i for i, redundant in enumerate(program.layout.redundant) if not redundant and np.any(jacobian[..., i, :])]


def saddle_point(mass: np.ndarray, jacobian: np.ndarray) -> np.ndarray:
    """[[M, -J'], [J, 0]] of one state or of many."""
    nothing = np.zeros((*jacobian.shape[:-1], jacobian.shape[-2]))
    above = np.concatenate([mass, -np.swapaxes(jacobian, -1, -2)], axis=-1)
    return np.concatenate([above, np.concatenate([jacobian, nothing], axis=-1)], axis=-2)


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
    columns = [stacked([pair[i] for pair in pairs], leading) for i in (0, 1)]
    blocks, at = [], 0
    for block in definition.results:
        end = at + len(block.elements)
        shape = leading + block.shape
        blocks.append((columns[0][..., at:end].reshape(shape), columns[1][..., at:end].reshape(shape)))
        at = end
    return blocks


def stacked(numbers: list[Any], leading: tuple[int, ...]) -> np.ndarray:
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
