"""Test for expressions of a model that are identically zero.

Nodes that are not the constant 0 as they stand are tried at random points with random parameters: an analytic
expression that is zero at all of them to rounding is zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.operation import STEPS, Group, Op
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.language.flat.events import entries
from lagdsl.language.flat.model import FlatModel, Parameter

_POINTS = 12
_ROUNDING = 1e-11
_KINKS = STEPS | {Op.SELECT, Op.ABS, Op.MIN, Op.MAX, Op.MOD}


def vanish(equations: Equations, nodes: Iterator[int] | Sequence[int]) -> bool:
    """True if all of `nodes` are identically zero: as they stand, or at random points where they are smooth."""
    graph = equations.graph
    open_ = [node for node in nodes if node != graph.zero]
    if not open_:
        return True
    if any(graph.op[node] in _KINKS for node in graph.live(open_)):
        return False
    symbols = _random_points(equations)
    return all(
        bool(np.all(np.isfinite(size)) and np.all(np.abs(value) <= _ROUNDING * size))
        for value, size in evaluate_with_size(graph, open_, symbols)
    )


def _random_points(equations: Equations) -> dict[Group, np.ndarray]:
    """Points near the starts, so that they lie where the model is meant; the same in every run."""
    flat, graph, symbols = equations.flat, equations.graph, equations.symbols
    random = np.random.default_rng(20)
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    defaults = {Group.P: np.array([parameter.value for parameter in independent]), Group.TIME: 0.0}
    starts = [equations.lowering.scalar(coordinate.start) for coordinate in flat.coordinates]
    centre = np.array([float(value) for value, _ in evaluate_with_size(graph, starts, defaults)])

    spread = random.uniform(-1.0, 1.0, (2, _POINTS, len(centre)))
    return {
        Group.TIME: random.uniform(0.1, 2.0, _POINTS),
        Group.Q: centre * (1.0 + 0.3 * spread[0]) + 0.7 * spread[1],
        Group.QD: random.uniform(-2.0, 2.0, (_POINTS, len(symbols.qd))),
        Group.Z: random.uniform(-1.0, 1.0, (_POINTS, len(symbols.z))),
        Group.U: random.uniform(-1.0, 1.0, (_POINTS, len(symbols.u))),
        Group.W: _discretes(flat, random),
        Group.P: np.stack([_varied(parameter, random) for parameter in independent], axis=-1)
        if independent
        else np.zeros((_POINTS, 0)),
    }


def _discretes(flat: FlatModel, random: np.random.Generator) -> np.ndarray:
    """Discrete variables, senses of slips, delayed values and loads of any value, truths of both."""
    numbers = ("variable", "direction", "delay", "delay_rate", "load")
    columns = [
        random.uniform(-1.0, 1.0, _POINTS) if entry.kind in numbers else random.integers(0, 2, _POINTS).astype(float)
        for entry in entries(flat.events)
    ]
    return np.stack(columns, axis=-1) if columns else np.zeros((_POINTS, 0))


def _varied(parameter: Parameter, random: np.random.Generator) -> np.ndarray:
    """Values of a parameter of the sign it has; switches and counts stay as they are, absent effects are given one."""
    if parameter.kind != "Real":
        return np.full(_POINTS, parameter.value)
    scale = parameter.value if parameter.value != 0.0 else 1.0
    return scale * random.uniform(0.6, 1.4, _POINTS)
