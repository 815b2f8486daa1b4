"""States at random, on the constraints, at which a program is compared: the same ones in every run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.graph.operation import Group
from lagdsl.numerics.rank import Floats
from lagdsl.program.program import Program

Arrays: TypeAlias = dict[Group, Any]
"""Values by group, one row for each state."""

STATES = 20
_SEED = 20
_ROUNDS = 40
_WELL_DETERMINED = 1e6
_ON_CONSTRAINTS = 1e-9


def random_states(flat: FlatModel, program: Program) -> Arrays:
    """STATES regular states about the start, or fewer where so many are not found; with accelerations, multipliers and
    directions at random, so that every function can be evaluated."""
    random = np.random.default_rng(_SEED)
    rows: list[Arrays] = []
    for _ in range(_ROUNDS):
        drawn = [_drawn(flat, program, random) for _ in range(STATES - len(rows))]
        found = {group: np.array([row[group] for row in drawn]) for group in drawn[0]}
        rows += [row for row, sound in zip(drawn, _is_sound(program, found), strict=True) if sound]
        if len(rows) == STATES:
            break
    if not rows:
        return {}
    return {group: np.array([row[group] for row in rows]) for group in rows[0]}


def _drawn(flat: FlatModel, program: Program, random: np.random.Generator) -> Arrays:
    layout = program.layout
    whole = np.array([p.kind != "Real" for p in flat.parameters if not p.structural], dtype=bool)
    p = np.array(layout.defaults) * np.where(whole, 1.0, random.uniform(0.9, 1.1, len(whole)))
    t = random.uniform(0.0, 1.0)
    start = values(program, "start", {Group.TIME: t, Group.P: p})
    q, qd, z, u = (_about(np.asarray(block, dtype=float), random) for block in start)
    state: Arrays = {Group.TIME: t, Group.Q: q, Group.QD: qd, Group.Z: z, Group.U: u, Group.P: p}
    state[Group.W] = _discretes(flat, program, t, p, random)
    state = _on_constraints(program, state)
    sizes = {g: layout.size(g) for g in Group if g not in (Group.RELEASE, Group.RELEASE_RATE)}
    return state | {g: random.normal(size=n) for g, n in sizes.items() if g not in state}


def _about(start: Floats, random: np.random.Generator) -> Floats:
    """Within a third of the start value; where that is zero, of one SI unit or of the largest neighbor."""
    size = np.max(np.abs(start), initial=0.0)
    scale = np.where(start != 0, np.abs(start), size if size > 0 else 1.0)
    return np.asarray(start + 0.3 * scale * random.uniform(-1, 1, start.shape))


def _discretes(flat: FlatModel, program: Program, t: float, p: Floats, random: np.random.Generator) -> Floats:
    """Contacts open and closed, relations true and false, numbers about their start; entries of time as they are."""
    layout = program.layout
    if not layout.discretes:
        return np.zeros(0)
    w = np.asarray(values(program, "discrete_start", {Group.TIME: t, Group.P: p})[0], dtype=float)
    whole = {item.name: item.kind == "Integer" for item in flat.events.discretes if item.kind != "Boolean"}
    for k, (slot, kind) in enumerate(zip(layout.discretes, layout.kinds, strict=True)):
        if kind == "timed":
            continue
        if kind == "impacts" or whole.get(slot.name):
            w[k] += random.integers(0, 4)
        elif slot.name in whole:
            w[k] = _about(w[k : k + 1], random)[0]
        else:
            w[k] = random.integers(0, 2)
    return w


def _on_constraints(program: Program, state: Arrays) -> Arrays:
    """Newton's method in the positions, one step in the rates."""
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


def _is_sound(program: Program, states: Arrays) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """At which of the states all is finite, the constraints hold and the accelerations are well determined?"""
    count = len(states[Group.TIME])
    sound = np.ones(count, dtype=np.bool_)
    for function in program.functions:
        for block in values(program, function.name, states):
            never = np.isposinf(block) if function.name == "time_event" else np.zeros(block.shape, dtype=np.bool_)
            sound &= (np.isfinite(block) | never).reshape(count, -1).all(axis=1)
    for i in np.flatnonzero(sound):
        one = {group: rows[i] for group, rows in states.items()}
        phi, jacobian = values(program, "position_constraint", one)
        size = max(1.0, float(np.max(np.abs(one[Group.Q]), initial=0.0)))
        met = float(np.max(np.abs(phi), initial=0.0)) <= _ON_CONSTRAINTS * size
        mass = values(program, "dynamics", one)[0]
        sound[i] = met and _condition(mass, jacobian[independent_rows(program, jacobian)]) < _WELL_DETERMINED
    return sound


def _condition(mass: Floats, jacobian: Floats) -> float:
    """Of the saddle point, for coordinates of one inertia and rows of length one: units do not count."""
    if not mass.size:
        return 1.0
    inertia = np.abs(np.diag(mass))
    scale = 1.0 / np.sqrt(np.where(inertia > 0.0, inertia, 1.0))
    rows = jacobian * scale
    rows = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    return float(np.linalg.cond(saddle_point(mass * np.outer(scale, scale), rows)))


def independent_rows(program: Program, jacobian: Floats) -> list[int]:
    """Rows of J (nc, nq) that are not redundant and not switched off."""
    return [i for i, redundant in enumerate(program.layout.redundant) if not redundant and np.any(jacobian[i] != 0)]


def saddle_point(mass: Any, jacobian: Any) -> Any:
    """[[M, -J'], [J, 0]] of one state or, with leading axes, of many."""
    nothing = np.zeros((*jacobian.shape[:-1], jacobian.shape[-2]))
    above = np.concatenate([mass, -np.swapaxes(jacobian, -1, -2)], axis=-1)
    return np.concatenate([above, np.concatenate([jacobian, nothing], axis=-1)], axis=-2)


def values(program: Program, function: str, arrays: Arrays) -> list[Any]:
    """Results of a function at one state or at rows of states, by the interpreter of the graph; complex ones, too."""
    definition = program.function(function)
    leading = np.shape(arrays[Group.TIME])
    given = {group: arrays[group] for group in definition.arguments}
    blocks = []
    for block in definition.results:
        numbers = evaluate(program.graph, block.elements, given)
        blocks.append(_stacked(numbers, leading).reshape(leading + block.shape))
    return blocks


def values_with_size(program: Program, function: str, arrays: Arrays) -> list[tuple[Floats, Floats]]:
    """The same, real, each with the size of the terms that it is the sum of."""
    definition = program.function(function)
    leading = np.shape(arrays[Group.TIME])
    given = {group: arrays[group] for group in definition.arguments}
    found = []
    for block in definition.results:
        pairs = evaluate_with_size(program.graph, block.elements, given)
        value, size = (_stacked([pair[i] for pair in pairs], leading).reshape(leading + block.shape) for i in (0, 1))
        found.append((value, size))
    return found


def _stacked(numbers: Sequence[Any], leading: tuple[int, ...]) -> Any:
    if not numbers:
        return np.zeros((*leading, 0))
    return np.stack([np.broadcast_to(number, leading) for number in numbers], axis=-1)
