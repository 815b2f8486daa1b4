"""The motion that a page integrates is that of the command line, also after a slider moved."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import ALL, chosen
from numpy.typing import NDArray
from page.pages import MODELS, Elements, page_of

from lagdsl import compile as compile_model
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.signals.trajectory import Trajectory

needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
ROWS = 61
# A stop time, a parameter and its other value, a start and its other value.
CASES = {
    "double_pendulum": (2.0, {"m2": 0.7}, {"a": 0.8}),  # minimal coordinates
    "bouncing_ball": (2.0, {}, {"h": 1.3}),  # contact
    "four_bar": (1.0, {"coupler.m": 1.7}, {}),  # a closed loop
    "furuta_swing_up": (0.5, {}, {}),  # sampled control
    "rolling_coin": (0.4, {"m": 0.02}, {"lean": 0.2}),  # nonholonomic
    "free_rigid_body": (1.0, {}, {}),  # quaternion
    "clutch": (3.0, {"J2": 2.5}, {}),  # constraints that come and go
    "slider_crank": (1.0, {}, {}),
    "kapitza_pendulum": (0.2, {}, {}),  # prescribed motion
    "heavy_top": (0.3, {}, {}),
}


def integrated(
    name: str,
    folder: Path,
    stop: float,
    parameters: dict[str, float],
    start: dict[str, float],
    tape: str = "tape",
) -> Floats:
    """Rows (ROWS, ...) that the worker of the page gives."""
    width, answer = answered(Elements(page_of(name, stop)), folder, parameters, start, tape)
    assert answer["status"] == 0
    return np.array(answer["rows"]).reshape(-1, width)


def answered(
    elements: Elements,
    folder: Path,
    parameters: dict[str, float],
    start: dict[str, float],
    tape: str = "tape",
    by: Sequence[int] = (),
) -> tuple[int, dict[str, Any]]:
    """Numbers of a row, and the answer of the worker, with derivatives by the sliders of these numbers."""
    head = elements.head
    for part, file in (("worker", "worker.js"), ("wasm", "lag.wasm"), (tape, "model.tape")):
        (folder / file).write_bytes(elements.inflated(part))
    setup = {key: head[key] for key in ("start", "stop", "lasting")}
    (folder / "setup.json").write_text(json.dumps({**setup, "rows": ROWS, "tolerance": 1e-10, "by": by}))
    moved = {**parameters, **{f"{key}.start": value for key, value in start.items()}}
    strangers = set(moved) - {slider["name"] for slider in head["parameters"]}
    assert not strangers
    order = {
        "parameters": [moved.get(slider["name"], slider["value"]) for slider in head["parameters"]],
        "inputs": [slider["value"] for slider in head["inputs"]],
    }
    (folder / "orders.json").write_text(json.dumps([order]))
    subprocess.run(["node", Path(__file__).parent / "worker.mjs", folder], check=True)
    ready, answer = json.loads((folder / "answers.json").read_text())
    return ready["ready"], answer


@needs_node
@pytest.mark.parametrize("name", chosen(CASES, ("bouncing_ball",)))
def test_a_live_motion_is_that_of_the_command_line(name: str, tmp_path: Path) -> None:
    stop, parameters, start = CASES[name]
    model = compile_model(MODELS / f"{name}.lag", engine="c" if ALL else "tape")
    for values, starts in (({}, {}), (parameters, start)):
        rows = integrated(name, tmp_path, stop, values, starts)
        motion = model.simulate(stop=stop, interval=stop / (ROWS - 1), tolerance=1e-10, parameters=values, start=starts)
        sizes = sizes_of(motion)
        for index, column in enumerate(motion.columns):
            off = np.abs(rows[:, index] - column.values[sides(motion.time, rows[:, 0], stop)]).min(axis=0)
            assert off.max() <= 1e-9 * sizes[family(column.name)], column.name


def sides(times: Floats, wanted: Floats, stop: float) -> NDArray[np.intp]:
    """Two rows (2, n) of a motion for each time. They differ at an event only, where the page has one of its sides."""
    close = 1e-12 * stop
    before = np.searchsorted(times, wanted - close, side="left")
    return np.array([before, np.searchsorted(times, wanted + close, side="right") - 1])


def family(name: str) -> str:
    """The vector that an element belongs to: of zero as one of three numbers round-off is left, which has no size."""
    return name.split("[", maxsplit=1)[0]


def sizes_of(motion: Trajectory) -> dict[str, float]:
    """Range and largest value of each quantity."""
    found: dict[str, float] = {}
    for column in motion.columns:
        own = float(np.ptp(column.values) + np.abs(column.values).max())
        found[family(column.name)] = max(own, found.get(family(column.name), 0.0))
    return found
