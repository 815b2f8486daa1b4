"""The motion that a page integrates is that of the command line, also after a slider moved."""

from __future__ import annotations

import json
import math
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
    moved = {**parameters, **{f"{key}.start": x for key, x in start.items()}}
    width, answer = answered(Elements(page_of(name, stop)), folder, moved, tape)
    assert answer["status"] == 0
    return np.array(answer["rows"]).reshape(-1, width)


def answered(
    elements: Elements,
    folder: Path,
    moved: dict[str, float],
    tape: str = "tape",
    *,
    by: Sequence[int] = (),
    pull: dict[str, Any] | None = None,
) -> tuple[int, dict[str, Any]]:
    """Numbers of a row, and the answer to other values of sliders; its derivatives are by the sliders `by`."""
    head = elements.head
    for part, file in (("worker", "worker.js"), ("wasm", "lag.wasm"), (tape, "model.tape")):
        (folder / file).write_bytes(elements.inflated(part))
    setup = {key: head[key] for key in ("start", "stop", "lasting")}
    setup |= {"rows": ROWS, "tolerance": 1e-10, "entries": len(head["blamed"]["entries"]), "by": by, "longest": 60_000}
    (folder / "setup.json").write_text(json.dumps(setup))
    strangers = set(moved) - {slider["name"] for slider in head["parameters"]}
    assert not strangers
    order = {
        "parameters": [moved.get(slider["name"], slider["value"]) for slider in head["parameters"]],
        "inputs": [slider["value"] for slider in head["inputs"]],
        "pull": pull,
    }
    (folder / "orders.json").write_text(json.dumps([order]))
    subprocess.run(["node", Path(__file__).parent / "worker.mjs", folder], check=True)
    ready, answer = json.loads((folder / "answers.json").read_text())
    return ready["ready"], answer


@needs_node
def test_events_and_what_is_to_blame_are_those_of_the_command_line(tmp_path: Path) -> None:
    elements = Elements(page_of("bouncing_ball", 2.0))
    head = elements.head
    _, answer = answered(elements, tmp_path, {"h.start": 1.3})
    kinds = head["event_names"]
    found = [
        (t, kinds[int(what)]["kind"], kinds[int(what)]["names"][int(which)]) for t, what, which in answer["events"]
    ]
    motion = compile_model(MODELS / "bouncing_ball.lag").simulate(stop=2.0, tolerance=1e-10, start={"h": 1.3})
    assert [(e.kind, e.name) for e in motion.events] == [each[1:] for each in found] != []
    assert [each[0] for each in found] == pytest.approx([e.time for e in motion.events], abs=1e-9)
    _, below = answered(elements, tmp_path, {"h.start": -0.3})
    assert below["rows"] == [] and str(below["status"]) in head["words"]
    assert {head["blamed"]["entries"][k] for k in below["blamed"]} == {"floor"}


@needs_node
def test_a_place_goes_where_it_is_pulled_and_loops_stay_closed(tmp_path: Path) -> None:
    """The crank of a four-bar linkage, whose end moves on a circle of 0.4 m: it is nearest on the line to the goal."""
    elements = Elements(page_of("four_bar", 1.0))
    head = elements.head
    names = [each["name"] for each in head["parameters"]]
    columns = [each["name"] for each in head["columns"]]
    link = next(p for s in head["scene"]["shapes"] for p in s["parts"] if "to" in p["numbers"])
    starts = [
        {"parameter": names.index(f"{name}.start"), "column": columns.index(name), "size": 1.0}
        for name in ("A.q", "B.q", "C.q")
    ]
    first = head["scene"]["first"]
    pull = {
        "parts": [[first + link["numbers"]["to"], 1.0]],
        "goal": [0.5 * math.cos(1.3), 0.5 * math.sin(1.3), 0.0],
        "across": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        "starts": starts,
    }
    width, answer = answered(elements, tmp_path, {}, pull=pull)
    row = dict(zip(columns, answer["rows"][:width], strict=False))
    assert answer["status"] == 0 and row["A.q"] == pytest.approx(1.3, abs=1e-3)
    for each in starts:  # the sliders have the starts that close the loop
        assert answer["parameters"][each["parameter"]] == pytest.approx(row[columns[each["column"]]], abs=1e-12)
    ends = [(0.4, "A.q"), (1.0, "B.q"), (0.8, "C.q")]
    x = y = turned = 0.0
    for length, name in ends:
        turned += row[name]
        x, y = x + length * math.cos(turned), y + length * math.sin(turned)
    assert (x, y) == pytest.approx((1.0, 0.0), abs=1e-8)


@needs_node
def test_a_place_of_a_body_that_turns_goes_where_it_is_pulled(tmp_path: Path) -> None:
    """On the rim of a wheel, along its second axis, which is the product of those that a row has."""
    elements = Elements(page_of("reaction_wheel_pendulum", 1.0))
    head = elements.head
    columns = [each["name"] for each in head["columns"]]
    names = [each["name"] for each in head["parameters"]]
    numbers = next(p["numbers"] for s in head["scene"]["shapes"] for p in s["parts"] if s["kind"] == "disc")
    at, x, z = (head["scene"]["first"] + numbers[role] for role in ("at", "x", "z"))

    def place(width: int, rows: list[float]) -> Floats:
        row = np.array(rows[:width])
        return np.asarray(row[at : at + 3] + 0.05 * np.cross(row[z : z + 3], row[x : x + 3]))

    turned = {"phi.start": 1.0}  # else arm and axis are in line
    width, answer = answered(elements, tmp_path, turned)
    goal = place(width, answer["rows"]) + np.array([0.02, -0.01, 0.0])
    pull = {
        "parts": [[at, 1.0], [z, 0.05, x]],
        "goal": goal.tolist(),
        "across": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        "starts": [
            {"parameter": names.index(f"{name}.start"), "column": columns.index(name), "size": 1.0}
            for name in ("theta", "phi")
        ],
    }
    width, answer = answered(elements, tmp_path, turned, pull=pull)
    assert place(width, answer["rows"]) == pytest.approx(goal, abs=1e-6)


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
