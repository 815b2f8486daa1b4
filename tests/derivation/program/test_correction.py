"""The function `correction`: M change - J' lam = 0, J change = -residual, as a dense solution has it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from compiled_programs import program_of

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group

MODELS = Path(__file__).parents[3] / "benchmarks" / "models"


def test_correction_is_the_projection_along_the_mass_matrix() -> None:
    program = program_of(MODELS / "four_bars.lag", {"N": 4})
    layout, graph = program.layout, program.graph
    random = np.random.default_rng(3)
    n, m = len(layout.coordinates), len(layout.constraints)
    residual = random.normal(size=m)
    symbols = {
        Group.TIME: 0.0,
        Group.Q: np.tile([1.0, -0.6, 1.4], 4).reshape(3, 4, order="F").ravel() + 0.1 * random.normal(size=n),
        Group.QD: random.normal(size=n),
        Group.P: np.array(layout.defaults),
        Group.LAMBDA: residual,
    }

    def values(name: str, result: int) -> np.ndarray:
        block = program.function(name).results[result]
        found = evaluate(graph, list(block.elements), {group: np.asarray(symbols[group])[None] for group in symbols})
        return np.array([float(np.squeeze(value)) for value in found]).reshape(block.shape)

    change, lam = values("correction", 0), values("correction", 1)
    mass, jacobian = values("mass_matrix", 0), values("velocity_constraint", 1)
    assert np.max(np.abs(jacobian @ change + residual)) < 1e-10 * np.max(np.abs(residual))
    assert np.max(np.abs(mass @ change - jacobian.T @ lam)) < 1e-10 * np.max(np.abs(mass @ change))
