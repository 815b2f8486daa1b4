"""Ranks and sizes of rows are found when a model is compiled, and by the runtime where parameters or start values are
others. For those of the text both tell the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen

import lagdsl
from lagdsl.engines.runtime.structures import InitialFault
from lagdsl.motion.simulate.placed import placed, start_values

MODELS = Path(__file__).parents[3] / "models"
# Loops in the plane and in space with redundant rows, rolling, contacts with friction, quaternions.
CHOSEN = (
    "bead_on_circular_wire_redundant",
    "billiard_ball_swerves",
    "four_bar_spatial",
    "free_rigid_body",
    "parallelogram",
    "rolling_coin",
    "watt_governor",
)


@pytest.mark.parametrize("name", chosen(sorted(path.stem for path in MODELS.glob("*.lag")), CHOSEN))
def test_compiler_and_runtime_agree(name: str) -> None:
    model = lagdsl.compile(MODELS / f"{name}.lag", engine="tape")
    compilation, engine = model._compilation, model._engine
    flat, structure = compilation.flat, compilation.structure
    p, t = np.array(engine.layout.defaults), flat.experiment.start_time
    q, u = start_values(engine, t, p)
    run = placed(flat, engine, p, u, t0=t)
    # A start value that is given, even its own, lets the runtime walk along the constraints.
    found = run.find(t, dict(enumerate(q[:1].tolist())), equations=bool(flat.initial_equations))
    run.leave()
    assert found.fault is InitialFault.NONE
    assert found.rank == structure.rank
    lasting = [row for row in range(len(structure.redundant)) if row not in structure.contacts]
    assert [bool(found.dependent[row]) for row in lasting] == [structure.redundant[row] for row in lasting]
    # Medians at other points; a factor of two is none for ranks.
    assert np.all(np.abs(np.log2(found.row_sizes / structure.space.row_sizes)) < 1.0)
