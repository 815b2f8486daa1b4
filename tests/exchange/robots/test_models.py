"""The arms of models/robots: sound texts, whose power is the change of their energy.

They are translations: the comparison with Pinocchio is that of their URDF files (test_peers.py). So they are not among
the models that every test takes.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.manual.models import model_names, model_title
from lagdsl.language.syntax.printer import format_text

FOLDER = Path(__file__).parents[3] / "models" / "robots"
NAMES = sorted(path.stem for path in FOLDER.glob("*.lag"))


@pytest.mark.parametrize("name", NAMES)
def test_the_text_is_formatted_and_can_be_started_from(name: str) -> None:
    text = (FOLDER / f"{name}.lag").read_text(encoding="utf-8")
    assert format_text(SourceFile(name, text), Sink()) == text
    assert f"robots/{name}" in model_names() and model_title(f"robots/{name}").startswith("Imported from ")
    assert f"({name}.lag)" in (FOLDER / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", chosen(NAMES, ["ur5"]))
def test_efforts_change_the_energy(name: str) -> None:
    """dE/dt = efforts * rates + losses of the dampers, by a central difference of the energy."""
    assert [each.code for each in lagdsl.check(FOLDER / f"{name}.lag") if each.severity != "note"] == []
    model = lagdsl.compile(FOLDER / f"{name}.lag", engine="tape")
    random, h = np.random.default_rng(6), 1e-5
    for q, qd, qdd in random.normal(size=(5, 3, len(model.coordinates))):
        ends = [model.energy(0.0, q + dt * qd + dt**2 / 2 * qdd, qd + dt * qdd) for dt in (-h, h)]
        missing = model.inverse_dynamics(0.0, q, qd, qdd)  # rotations of the rates are symmetric: half of them is loss
        losses = (missing - model.inverse_dynamics(0.0, q, -qd, qdd)) @ qd / 2
        power = missing @ qd - losses
        assert abs((ends[1] - ends[0]) / (2 * h) - power) < 1e-6 * (abs(power) + np.abs(missing).max())
