"""Two programs of one model, evaluated at the same random states."""

from __future__ import annotations

from typing import Any

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import SIGNATURES
from lagdsl.derivation.program.program import Program

FUNCTIONS = tuple(SIGNATURES)


def random_arguments(program: Program, rng: np.random.Generator, states: int) -> dict[Group, Any]:
    """Starts and defaults of the model, moved about; every group of every signature, states along the leading axis."""
    layout = program.layout
    groups = dict.fromkeys(group for signature in SIGNATURES.values() for group in signature)
    arguments: dict[Group, Any] = {
        group: rng.normal(size=(states, layout.size(group))) for group in groups if group is not Group.TIME
    }
    arguments[Group.TIME] = rng.uniform(0.0, 2.0, size=states)
    arguments[Group.P] = np.array(layout.defaults) * rng.uniform(0.8, 1.25, size=(states, len(layout.defaults)))
    start = program.function("start")
    roots = [node for block in start.results for node in block.elements]
    values = iter(np.broadcast_to(v, (states,)) for v, _ in evaluate_with_size(program.graph, roots, arguments))
    for group, block in zip((Group.Q, Group.QD, Group.Z, Group.U), start.results, strict=True):
        for index in range(len(block.elements)):
            column = next(values)
            arguments[group][:, index] = column + 0.3 * np.maximum(np.abs(column), 0.5) * arguments[group][:, index]
    return arguments


def names(program: Program) -> dict[str, tuple[str, ...]]:
    """The layout by names."""
    layout = program.layout
    groups = ("coordinates", "states", "inputs", "parameters", "outputs", "constraints", "invariants")
    return {group: tuple(slot.name for slot in getattr(layout, group)) for group in groups}


def disagreement(first: Program, second: Program, function: str, arguments: dict[Group, Any]) -> dict[str, float]:
    """Largest difference of each result block, relative to the size of the terms it is made of."""
    worst: dict[str, float] = {}
    for a, b in zip(first.function(function).results, second.function(function).results, strict=True):
        assert a.shape == b.shape, (function, a.name, a.shape, b.shape)
        if (function, a.name) == ("monitor", "scale"):
            continue  # which terms an invariant is the sum of is not the same before and after differentiation
        x = evaluate_with_size(first.graph, a.elements, arguments)
        y = evaluate_with_size(second.graph, b.elements, arguments)
        worst[a.name] = max((_relative(*pair) for pair in zip(x, y, strict=True)), default=0.0)
    return worst


def _relative(a: tuple[Any, Any], b: tuple[Any, Any]) -> float:
    size = np.maximum(a[1], b[1])
    difference = np.abs(a[0] - b[0])
    assert np.all(np.isfinite(difference)), "a value is not finite"
    return float(np.max(np.where(difference == 0.0, 0.0, difference / np.maximum(size, 1e-300))))
