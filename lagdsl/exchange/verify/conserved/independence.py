"""Functional independence: a function of quantities that are constant is constant, and is nothing new."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.exchange.verify.conserved.samples import Samples
from lagdsl.exchange.verify.states import Arrays, values
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.pipeline import Compilation

_STATES = 3
_STEP = 1e-30  # of complex steps
_RANK = 1e-9
_NEAR = 1e-6


@record()
class Gradients:
    """Derivatives of values at some states: for each a matrix (directions, candidates), along directions of (q, qd)
    that stay on the constraints; `natural` are the sizes of the values there (states, candidates)."""

    along: tuple[Floats, ...]
    natural: Floats


def gradients(compilation: Compilation, nodes: Sequence[int], at: Samples) -> Gradients:
    found = []
    for i in range(_STATES):
        state = {group: rows[i] for group, rows in at.states.items()}
        moved = _stepped(state, _tangent(compilation, state))
        columns = evaluate(compilation.equations.graph, nodes, moved)
        count = len(moved[Group.Q])
        found.append(np.stack([np.broadcast_to(np.imag(each) / _STEP, (count,)) for each in columns], axis=1))
    return Gradients(tuple(found), at.natural[:_STATES])


def is_independent(weights: Floats, used: list[int], known: Sequence[tuple[Floats, list[int]]], at: Gradients) -> bool:
    """Is the gradient of a combination, at one of the states, no combination of those of known ones? Weights
    (candidates used,) are given with the columns that they belong to."""
    for slopes in at.along:
        new = slopes[:, used] @ weights
        size = float(np.max(np.abs(slopes[:, used]) @ np.abs(weights), initial=0.0))
        if not (np.isfinite(new).all() and size > 0.0):
            continue
        basis = np.stack([np.zeros(len(new)), *(slopes[:, columns] @ own for own, columns in known)], axis=1)
        lengths = np.max(np.abs(basis), axis=0)
        basis = basis / np.where(lengths > 0.0, lengths, 1.0)
        best = np.linalg.lstsq(basis, new / size, rcond=1e-10)[0]
        if np.max(np.abs(basis @ best - new / size)) > _NEAR:
            return True
    return False


def _tangent(compilation: Compilation, state: Arrays) -> Floats:
    """Directions of (q, qd) that stay on the constraints, as rows."""
    program = compilation.program
    size = 2 * len(program.layout.coordinates)
    moved = _stepped(state, np.eye(size))
    names = ("position_constraint", "velocity_constraint")
    rows = np.concatenate([values(program, name, moved)[0] for name in names], axis=1).imag.T / _STEP
    if not rows.size:
        return np.eye(size)
    _, lengths, axes = np.linalg.svd(rows)
    return np.asarray(axes[int(np.count_nonzero(lengths > _RANK * lengths[0])) :])


def _stepped(state: Arrays, directions: Floats) -> Arrays:
    """The state an imaginary step along each row, as rows of states."""
    n = len(state[Group.Q])
    count = len(directions)
    many = {group: np.broadcast_to(value, (count, *np.shape(value))) for group, value in state.items()}
    steps = 1j * _STEP * directions
    return many | {Group.Q: many[Group.Q] + steps[:, :n], Group.QD: many[Group.QD] + steps[:, n:]}
