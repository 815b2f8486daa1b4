"""Many random states of a model at once, on its constraints, and what a solution leaves in the equations there."""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.exchange.verify.states import (
    Arrays,
    about,
    is_regular,
    random_discretes,
    values,
    values_with_size,
    whole_parameters,
)
from models.corpus import compiled

MANY = 200
_ROUNDS = 8


def many_states(name: str) -> Arrays:
    """MANY random states about the start, as arrays by group, one row per state; those where something is singular or
    that do not reach the constraints are drawn again."""
    program, random = compiled(name).graph, np.random.default_rng(41)
    found: list[Arrays] = []
    for _ in range(_ROUNDS):
        state = onto_constraints(program, _draw(name, random))
        sound = is_regular(program, state)
        found.append({group: rows[sound] for group, rows in state.items()})
        if sum(len(part[Group.TIME]) for part in found) >= MANY:
            return {group: np.concatenate([part[group] for part in found])[:MANY] for group in STATE}
    raise AssertionError(f"{name}: too few regular states found")


def _draw(name: str, random: np.random.Generator) -> Arrays:
    program = compiled(name).graph
    layout, count = program.layout, MANY + MANY // 4
    whole = whole_parameters(compiled(name).flat)
    p = np.array(layout.defaults) * np.where(whole, 1.0, random.uniform(0.9, 1.1, (count, len(whole))))
    t = random.uniform(0.0, 1.0, count)
    start = values(program, "start", {Group.TIME: t, Group.P: p})
    q, qd, z, u = (about(np.asarray(block, dtype=float), random) for block in start)
    return {
        Group.TIME: t,
        Group.Q: q,
        Group.QD: qd,
        Group.Z: z,
        Group.U: u,
        Group.W: random_discretes(compiled(name).flat, program, t, p, random),
        Group.P: p,
    }


def onto_constraints(program: Program, state: Arrays) -> Arrays:
    """The states moved onto the constraints: Newton's method in the positions, one step in the rates."""
    q, qd = state[Group.Q], state[Group.QD]
    if not program.layout.constraints:
        return state
    for _ in range(30):
        phi, jacobian = values(program, "position_constraint", state | {Group.Q: q})
        step = _least(jacobian, phi)
        q = q - step
        if np.all(np.abs(step) <= 1e-15 * np.max(np.abs(q), axis=-1, keepdims=True)):
            break
    residual, jacobian = values(program, "velocity_constraint", state | {Group.Q: q, Group.QD: qd})
    return state | {Group.Q: q, Group.QD: qd - _least(jacobian, residual)}


def _least(jacobian: np.ndarray, right: np.ndarray) -> np.ndarray:
    """The least steps; none where something is no number."""
    sound = np.isfinite(jacobian).all(axis=(-1, -2)) & np.isfinite(right).all(axis=-1)
    inverse = np.linalg.pinv(np.where(sound[:, None, None], jacobian, 0.0), rcond=1e-10)
    return np.asarray((inverse @ np.where(sound[:, None], right, 0.0)[..., None])[..., 0])


def left_in_equations(
    program: Program, state: Arrays, qdd: np.ndarray, lam: np.ndarray, solved: Program | None = None
) -> float:
    """Residual that qdd and lam leave in M qdd - J'lam = f and J qdd = gamma, relative to the size of the terms; the
    worst row of all states. `solved` is the other derivation if its equations gave qdd and lam: a term that vanishes in
    one of them, because what it is the sum of is not written out, may be a sum with round-off in the other one.

    Where terms vanish at a state, relative to what they are the sum of, but not to more than is usual in that row;
    where all of them vanish, relative to a ten-thousandth of what the largest unknowns would make of it, or the
    accelerations of the forces alone. Rows of J that vanish everywhere (of a constraint that follows from another one)
    are round-off and say nothing. Balances of forces vanish everywhere: they are
    compared with their terms.
    """
    dynamics = [values_with_size(each, "dynamics", state) for each in (program, solved or program)]
    mass, force, rows, bias = (value for value, _ in dynamics[0])
    m_size, f_size, r_size, b_size = (np.maximum(a, b) for (_, a), (_, b) in zip(*dynamics, strict=True))
    a, lam = qdd[..., None], lam[..., None]
    across, r_across = np.swapaxes(rows, -1, -2), np.swapaxes(r_size, -1, -2)
    alone = np.concatenate([a, _least(mass, force)[..., None]], axis=-2)
    some, hard = (
        np.maximum(np.abs(x), 1e-4 * np.max(np.abs(largest), axis=-2, keepdims=True, initial=0.0))
        for x, largest in ((a, alone), (lam, lam))
    )
    motion = _part(
        mass @ a - force[..., None] - across @ lam,
        np.abs(mass) @ some + np.abs(force[..., None]) + np.abs(across) @ hard,
        m_size @ some + f_size[..., None] + r_across @ hard,
    )
    balances = {slot.name for slot in program.layout.constraints}
    light = [f"balance({slot.name})" in balances for slot in program.layout.coordinates]
    motion[:, light] = np.abs(mass @ a - force[..., None] - across @ lam)[:, light] / f_size[:, light, None]
    held = _part(
        rows @ a - bias[..., None],
        np.abs(rows) @ some + np.abs(bias[..., None]),
        r_size @ some + b_size[..., None],
    )
    length = np.max(np.abs(rows), axis=(0, -1), initial=0.0)
    held = held[:, length > 1e-10 * np.max(length, initial=0.0)]
    return float(max(np.max(motion, initial=0.0), np.max(held, initial=0.0)))


def _part(left: np.ndarray, terms: np.ndarray, inner: np.ndarray) -> np.ndarray:
    """Infinite where something is no number."""
    size = terms + np.minimum(inner, np.max(terms, axis=0))
    part = np.abs(left) / np.where(size > 0.0, size, 1.0)
    return np.where(np.isnan(part), np.inf, part)
