"""Entries of A, B, C and D that are zero by the structure of the functions, and states that nothing depends on.

A column of A is the derivative along a direction, in which dependent coordinates and rates follow. An entry is zero if
no number that moves along the direction influences its row, through the equations of motion or by itself.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.units.dimension import CHARGE
from lagdsl.motion.analysis.linearize import Reduced
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sparsity.accelerations import Accelerations, bits_of
from lagdsl.motion.analysis.sparsity.influence import Influence, Influences

_MOVED = (Group.Q, Group.QD, Group.Z, Group.U)
_SOLVED = (Group.QDD, Group.LAMBDA)
_FUNCTIONS = ("residual", "dynamics", "state_derivative", "output", "indicator")


def dependence(system: System, at: Reduced) -> tuple[Flags, Flags]:
    """Entries of (A, B; C, D) (nx + ny, nx + nu) that may differ from zero; states (nx,) that a relation reads."""
    program = system.program
    motion, states, outputs, relations = _influences(program)
    along = at.along
    moved = np.hstack([along.q, along.qd, along.z, along.u]) != 0.0
    width = moved.shape[1]
    rows = [*(motion[j] for j in at.partition.rate), *states, *outputs]
    reached = _pattern(rows, width) @ moved.T
    rates = along.qd[:, list(at.partition.position)].T != 0.0
    watched = np.any(_pattern(relations, width) @ moved[: len(at.value)].T, axis=0)
    return np.vstack([rates, reached]), watched


def idle_charges(system: System, at: Reduced, entries: Flags, watched: Flags) -> list[int]:
    """States that are charges and influence nothing but each other: no other state, no output, no relation."""
    coordinates = system.flat.coordinates
    charges = {i for i, j in enumerate(at.partition.position) if coordinates[j].dimension == CHARGE and not watched[i]}
    idle = sorted(charges)
    while True:
        others = [i for i in range(len(entries)) if i not in idle]
        kept = [j for j in idle if not np.any(entries[others, j])]
        if kept == idle:
            return idle
        idle = kept


def _influences(program: Program) -> tuple[list[Influence], list[Influence], list[Influence], list[Influence]]:
    """On accelerations, rates of states, outputs and indicators; bits are coordinates, rates, states, inputs."""
    graph, layout = program.graph, program.layout
    symbols = [graph.symbol(group, i) for group in (*_MOVED, *_SOLVED) for i in range(layout.size(group))]
    bits = {symbol: 1 << place for place, symbol in enumerate(symbols)}
    first = sum(layout.size(group) for group in _MOVED)
    loads = [graph.symbol(Group.W, place) for place, kind in enumerate(layout.kinds) if kind == "load"]
    bits |= dict.fromkeys(loads, (1 << first) - 1)  # they follow from accelerations and multipliers, so from everything
    blocks = {name: program.function(name).results for name in _FUNCTIONS if program.has(name)}
    roots = [node for results in blocks.values() for block in results for node in block.elements]
    found = Influences(graph, roots, bits)
    solution = Accelerations(program, found, first, frozenset(), pulled=False)
    states, outputs, relations = (
        [solution.resolve(found[node]) for block in blocks.get(name, ())[:1] for node in block.elements]
        for name in ("state_derivative", "output", "indicator")
    )
    return solution.solved[: solution.n], states, outputs, relations


def _pattern(rows: Sequence[Influence], width: int) -> Flags:
    result = np.zeros((len(rows), width), dtype=np.bool_)
    for flags, influence in zip(result, rows, strict=True):
        flags[[bit for bit in bits_of(influence[0]) if bit < width]] = True
    return result
