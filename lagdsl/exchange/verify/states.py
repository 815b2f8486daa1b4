"""States at random, on the constraints, at which a program is compared: the same ones in every run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.points import natural_sizes
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel

Arrays: TypeAlias = dict[Group, Any]
"""Values by group, one row for each state."""

STATES = 20
_SEED = 20
_ROUNDS = 40
_WELL_DETERMINED = 1e6
_ON_CONSTRAINTS = 1e-9


def random_states(flat: FlatModel, program: Program, count: int = STATES) -> Arrays:
    """`count` regular states about the start, or fewer where so many are not found, none as an empty mapping; with
    accelerations, multipliers and directions at random, so that every function can be evaluated."""
    random = np.random.default_rng(_SEED)
    rows: list[Arrays] = []
    for _ in range(_ROUNDS):
        one = (drawn_parameters(flat, program, random, 1) for _ in range(count - len(rows)))
        each = [drawn_states(flat, program, random, p) for p in one]
        drawn = {group: np.concatenate([state[group] for state in each]) for group in each[0]}
        sound = np.flatnonzero(_is_sound(program, drawn))
        rows += [{group: values[i] for group, values in drawn.items()} for i in sound]
        if len(rows) == count:
            break
    return {group: np.array([row[group] for row in rows]) for group in rows[0]} if rows else {}


def drawn_parameters(flat: FlatModel, program: Program, random: np.random.Generator, count: int) -> Floats:
    """(count, np): each within a tenth of its default."""
    defaults = np.array(program.layout.defaults, dtype=float)
    spread = random.uniform(0.9, 1.1, (count, len(defaults)))
    return np.asarray(defaults * np.where(whole_parameters(flat), 1.0, spread))


def drawn_states(
    flat: FlatModel, program: Program, random: np.random.Generator, p: Floats, *, widely: bool = False
) -> Arrays:
    """One state about the start for each row of parameters, on the constraints where these can be met. Every other one
    has, where they are asked for `widely`, numbers of all sizes."""
    layout = program.layout
    t = random.uniform(0.0, 1.0, len(p))
    start = values(program, "start", {Group.TIME: t, Group.P: p})
    q, qd, z, u = (about(np.asarray(block, dtype=float), random) for block in start)
    if widely:
        q, qd, z, u = (_widely(block, least, random) for block, least in ((q, -1), (qd, -4), (z, -4), (u, -1)))
    state: Arrays = {Group.TIME: t, Group.Q: q, Group.QD: qd, Group.Z: z, Group.U: u, Group.P: p}
    state[Group.W] = random_discretes(flat, program, t, p, random)
    state = _on_constraints(program, state)
    sizes = {g: layout.size(g) for g in Group if g not in (Group.RELEASE, Group.RELEASE_RATE)}
    return state | {g: random.normal(size=(len(p), n)) for g, n in sizes.items() if g not in state}


def coordinate_sizes(flat: FlatModel, program: Program, p: Floats) -> Floats:
    """Natural sizes (nq,) of the coordinates."""
    (start, _, _, _) = values(program, "start", {Group.TIME: np.asarray(flat.experiment.start_time), Group.P: p})
    return natural_sizes(flat.coordinates, program.layout.components, np.asarray(start, dtype=float))


def whole_parameters(flat: FlatModel) -> Flags:
    """(np) True where a parameter is a Boolean or an Integer, which keeps its value."""
    return np.array([p.kind != "Real" for p in flat.parameters if not p.structural], dtype=np.bool_)


def about(start: Floats, random: np.random.Generator) -> Floats:
    """Within a third of the start value; where that is zero, of one SI unit or of the largest neighbor."""
    return np.asarray(start + 0.3 * drawn_sizes(start) * random.uniform(-1, 1, start.shape))


def drawn_sizes(start: Floats) -> Floats:
    """Of the start values; where one is zero, of the largest neighbor, or one SI unit."""
    size = np.max(np.abs(start), axis=-1, initial=0.0, keepdims=True)
    return np.where(start != 0, np.abs(start), np.where(size > 0, size, 1.0))


def _widely(values: Floats, least: int, random: np.random.Generator) -> Floats:
    """Every other row times powers of ten, from `least` on; those of rates of either sign."""
    factor = 10.0 ** random.uniform(least, 0.3, values.shape)
    if least < -1:
        factor *= random.choice((-1.0, 1.0), values.shape)
    factor[::2] = 1.0
    return values * factor


def random_discretes(flat: FlatModel, program: Program, t: Any, p: Floats, random: np.random.Generator) -> Floats:
    """(..., nw): contacts open and closed, slips free and held, relations true and false, numbers about their start;
    for each t and p.

    Entries that follow from the time alone are those of t: others stand for no instant.
    """
    layout = program.layout
    if not layout.discretes:
        return np.zeros((*np.shape(t), 0))
    w = np.asarray(values(program, "discrete_start", {Group.TIME: t, Group.P: p})[0], dtype=float)
    whole = {item.name: item.kind == "Integer" for item in flat.events.discretes if item.kind != "Boolean"}
    for k, (slot, kind) in enumerate(zip(layout.discretes, layout.kinds, strict=True)):
        if kind == "timed":
            continue
        if kind == "impacts" or whole.get(slot.name):
            w[..., k] += random.integers(0, 4, np.shape(t))
        elif kind == "direction":
            w[..., k] = random.integers(-1, 2, np.shape(t))
        elif kind in ("delay", "delay_rate", "load") or slot.name in whole:
            w[..., k] = about(w[..., k : k + 1], random)[..., 0]
        else:
            w[..., k] = random.integers(0, 2, np.shape(t))
    return w


def _on_constraints(program: Program, state: Arrays) -> Arrays:
    """Newton's method in the positions, one step in the rates; rows where it is no number stay as they are."""
    q, qd = state[Group.Q], state[Group.QD]
    moving = np.ones(len(q), dtype=np.bool_)
    for _ in range(30):
        phi, jacobian = values(program, "position_constraint", state | {Group.Q: q})
        moving &= _are_finite(phi) & _are_finite(jacobian)
        if not (phi.size and moving.any()):
            break
        step = _shortest(np.where(moving[:, None, None], jacobian, 0.0), np.where(moving[:, None], phi, 0.0))
        q = q - step
        moving &= np.max(np.abs(step), axis=1) > 1e-15 * np.max(np.abs(q), axis=1)
    residual, jacobian = values(program, "velocity_constraint", state | {Group.Q: q, Group.QD: qd})
    if residual.size:
        sound = _are_finite(residual) & _are_finite(jacobian)
        qd = qd - _shortest(np.where(sound[:, None, None], jacobian, 0.0), np.where(sound[:, None], residual, 0.0))
    return state | {Group.Q: q, Group.QD: qd}


def _shortest(jacobian: Any, residual: Any) -> Floats:
    """The least step that takes each row of `residual` (..., nc) away."""
    return np.asarray(np.einsum("...ij,...j->...i", np.linalg.pinv(jacobian, rcond=1e-10), residual))


def _are_finite(blocks: Any) -> Flags:
    return np.asarray(np.isfinite(blocks).reshape(len(blocks), -1).all(axis=1))


def _is_sound(program: Program, states: Arrays) -> Flags:
    """At which states are all functions finite, and the states regular?"""
    sound = is_regular(program, states)
    for function in program.functions:
        for block in values(program, function.name, states):
            never = np.isposinf(block) & (function.name == "time_event")  # an event that is not to come
            sound &= _are_finite(np.where(never, 0.0, block))
    return sound


def is_regular(program: Program, states: Arrays) -> Flags:
    """At which states is everything finite, on the constraints, and are the accelerations well determined?"""
    blocks = values(written_out(program), "dynamics", states)
    sound = np.ones(len(states[Group.TIME]), dtype=np.bool_)
    for block in blocks:
        sound &= _are_finite(block)
    phi, _ = values(program, "position_constraint", states)
    sound &= np.max(np.abs(np.nan_to_num(phi, nan=1.0)), axis=1, initial=0.0) < _ON_CONSTRAINTS
    for i in np.flatnonzero(sound):
        mass, rows = blocks[0][i], blocks[2][i]
        matrix = _scaled(mass, rows[independent_rows(program, rows)])
        sound[i] = not matrix.size or np.linalg.cond(matrix) < _WELL_DETERMINED
    return sound


def _scaled(mass: Any, jacobian: Any) -> Any:
    """The saddle point where units do not count: coordinates by their inertia, those without by their rows, rows by
    what they are then. So a small inertia beside a row, as that of a thin rod turned by quaternions, is not small."""
    inertia, slope = (np.max(np.abs(each), axis=0, initial=0.0) for each in (mass, jacobian))
    coordinates = np.sqrt(np.where(inertia > 0.0, inertia, np.where(slope > 0.0, slope**2, 1.0)))
    jacobian = jacobian / coordinates
    largest = np.max(np.abs(jacobian), axis=1, initial=0.0)[:, None]
    return saddle_point(mass / np.outer(coordinates, coordinates), jacobian / np.where(largest > 0.0, largest, 1.0))


def independent_rows(program: Program, jacobian: Any) -> list[int]:
    """Rows of J (..., nc, nq) that are not redundant; those of open contacts, and those that a discrete has switched
    off, are zero."""
    return [i for i, redundant in enumerate(program.layout.redundant) if not redundant and np.any(jacobian[..., i, :])]


def saddle_point(mass: Any, jacobian: Any) -> Any:
    """[[M, -J'], [J, 0]] of one state or, with leading axes, of many."""
    nothing = np.zeros((*jacobian.shape[:-1], jacobian.shape[-2]))
    above = np.concatenate([mass, -np.swapaxes(jacobian, -1, -2)], axis=-1)
    return np.concatenate([above, np.concatenate([jacobian, nothing], axis=-1)], axis=-2)


def values(program: Program, function: str, arrays: Arrays) -> list[Any]:
    """Results of a function at one state or at rows of states, by the interpreter of the graph; complex ones, too."""
    roots, given = _asked(program, function, arrays)
    return _blocks(program, function, evaluate(program.graph, roots, given), np.shape(arrays[Group.TIME]))


def values_with_size(program: Program, function: str, arrays: Arrays) -> list[tuple[Floats, Floats]]:
    """The same, real, each with the size of the terms that it is the sum of."""
    roots, given = _asked(program, function, arrays)
    pairs = evaluate_with_size(program.graph, roots, given)
    leading = np.shape(arrays[Group.TIME])
    found, sizes = (_blocks(program, function, [pair[i] for pair in pairs], leading) for i in (0, 1))
    return list(zip(found, sizes, strict=True))


def _asked(program: Program, function: str, arrays: Arrays) -> tuple[list[int], Arrays]:
    """All elements of the results at once: they share most of their nodes."""
    definition = program.function(function)
    roots = [element for block in definition.results for element in block.elements]
    return roots, {group: arrays[group] for group in definition.arguments}


def _blocks(program: Program, function: str, numbers: Sequence[Any], leading: tuple[int, ...]) -> list[Any]:
    blocks, at = [], 0
    for block in program.function(function).results:
        own = numbers[at : at + len(block.elements)]
        at += len(own)
        rows = (
            np.stack([np.broadcast_to(number, leading) for number in own], axis=-1) if own else np.zeros((*leading, 0))
        )
        blocks.append(rows.reshape(leading + block.shape))
    return blocks
