"""Arrows of a page: closed forms, the model's own reactions, and the same motion as that of the machine."""

from __future__ import annotations

import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from named_models import compiled
from page.pages import MODELS, Elements, page_of
from page.test_live import integrated

from lagdsl.derivation.scene.vectors import with_vectors
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.pipeline import Route, compile_flat
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.simulate import simulate

PENDULUM = """model A
  parameter Mass m = 2 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  point P = {l*sin(theta), -l*cos(theta)};
  gravity = -g_n*world.y;
  mass m at P;
  annotation(experiment(StopTime = 1, Tolerance = 1e-11));
end A;
"""
WIRE = """model A
  parameter Mass m = 2 kg;
  coordinate Length x(start = 0.3 m), y(start = 0.09 m);
  gravity = -g_n*world.y;
  mass m at {x, y};
  constraint wire: y = x^2/(1 m);
  annotation(experiment(StopTime = 1, Tolerance = 1e-11));
end A;
"""


@cache
def moved(
    source: str | Path, route: Route = "graph", stop: float | None = None
) -> tuple[Trajectory, dict[str, Floats]]:
    """The motion, and by kind and name of an arrow its vector (rows, 3)."""
    pointed = with_vectors(compiled(source).flat)
    made = compile_flat(pointed.flat, Sink(), route)
    assert made is not None
    motion = simulate(engine_of(made.program, "tape"), made.flat, interval=0.05, stop=stop)
    found = {}
    for shape in pointed.scene.shapes:
        first = pointed.scene.first(shape.numbers["vector"])
        name = f"{shape.kind} {shape.name} {shape.texts.get('coordinate', '')}".strip()
        found[name] = np.stack([motion[f"scene[{first + k}]"] for k in (1, 2, 3)], axis=1)
    return motion, found


def test_a_pendulum_by_closed_forms() -> None:
    motion, arrows = moved(PENDULUM)
    theta, rate = motion["theta"], motion["der(theta)"]
    along = np.stack([np.cos(theta), np.sin(theta), 0 * theta], axis=1)
    inward = np.stack([-np.sin(theta), np.cos(theta), 0 * theta], axis=1)
    turning = -9.80665 / 0.5 * np.sin(theta)
    assert set(arrows) == {"velocity P", "acceleration P", "admissible P theta", "reaction reaction(P)"}
    assert arrows["velocity P"] == pytest.approx(0.5 * rate[:, None] * along, abs=1e-12)
    assert arrows["admissible P theta"] == pytest.approx(0.5 * along, abs=1e-15)
    expected = 0.5 * (turning[:, None] * along + (rate**2)[:, None] * inward)
    assert arrows["acceleration P"] == pytest.approx(expected, abs=1e-12)
    pull = 2.0 * (0.5 * rate**2 + 9.80665 * np.cos(theta))
    assert arrows["reaction reaction(P)"] == pytest.approx(pull[:, None] * inward, abs=1e-11)


def test_the_force_of_a_wire() -> None:
    """lambda grad(y - x^2), which is m a + m g: it stands across the wire."""
    motion, arrows = moved(WIRE)
    (name,) = [key for key in arrows if key.startswith("constraint")]
    assert name == "constraint wire on mass 1"
    across = np.stack([-2 * motion["x"], np.ones(len(motion)), np.zeros(len(motion))], axis=1)
    assert np.cross(arrows[name], across) == pytest.approx(0, abs=1e-9)
    assert arrows[name] == pytest.approx(2.0 * (arrows["acceleration mass 1"] + [0, 9.80665, 0]), abs=1e-9)


def test_reactions_of_joints_are_those_of_the_model() -> None:
    path = MODELS / "library" / "spatial_top.lag"
    arrows = moved(path, stop=0.2)[1]
    own = simulate(engine_of(compiled(path).program, "tape"), compiled(path).flat, interval=0.05, stop=0.2)
    support = np.stack([own[f"support[{k}]"] for k in (1, 2, 3)], axis=1)
    assert arrows["reaction reaction(tip).force"] == pytest.approx(support, abs=1e-7 * np.abs(support).max())
    assert arrows["reaction torque reaction(tip).torque"] == pytest.approx(0, abs=1e-9)


def test_both_derivations_have_the_same_arrows() -> None:
    ours, theirs = moved(WIRE)[1], moved(WIRE, "textbook")[1]
    assert list(ours) == list(theirs)
    for name, arrow in ours.items():
        assert arrow == pytest.approx(theirs[name], abs=1e-8)


def test_a_velocity_is_the_sum_of_admissible_motions() -> None:
    motion, arrows = moved(MODELS / "double_pendulum.lag", stop=1.0)
    parts = [arrows[f"admissible P2 {name}"] * motion[f"der({name})"][:, None] for name in ("a", "b")]
    assert arrows["velocity P2"] == pytest.approx(parts[0] + parts[1], abs=1e-12)


@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
def test_arrows_and_machine_are_one_motion_in_the_browser(tmp_path: Path) -> None:
    folders = tmp_path / "machine", tmp_path / "arrows"
    for folder in folders:
        folder.mkdir()
    machine = integrated("double_pendulum", folders[0], 2.0, {"m2": 0.7}, {"a": 0.8})
    arrows = integrated("double_pendulum", folders[1], 2.0, {"m2": 0.7}, {"a": 0.8}, tape="vectors")
    head = Elements(page_of("double_pendulum", 2.0)).head
    first = head["vectors"]["first"]
    assert arrows[:, :first] == pytest.approx(machine[:, :first], abs=1e-9)
    shape = next(each for each in head["vectors"]["shapes"] if each["kind"] == "velocity" and each["name"] == "P1")
    velocity = arrows[:, first + shape["numbers"]["vector"]]
    assert velocity == pytest.approx(0.5 * arrows[:, 3] * np.cos(arrows[:, 1]), abs=1e-12)


def test_a_model_without_masses_has_no_arrows() -> None:
    assert Elements(page_of("van_der_pol", 1.0)).head["vectors"] is None
