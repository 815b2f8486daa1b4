"""Exported C simulates events by itself: built by its own Makefile, run, compared with closed forms and with NumPy."""

from __future__ import annotations

import csv
import math
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from choice import ALL, chosen, repeats, spread
from click.testing import CliRunner
from made_modules import PLAIN, SANITIZED, Made

import lagdsl
from lagdsl.engines.runtime.building.platforms import PLATFORMS, platform_of, this_machine
from lagdsl.exchange.fmi.package.installed_objects import installed_runtime
from lagdsl.interfaces.cli.main import lag

G = 9.80665
BALL = """
model Ball
  coordinate Length h(start = 1 m);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = 0.8;
  output Force N = multiplier(floor);
end Ball;
"""
MACHINE = """
model Machine "A ball hops, and is pushed to and fro by a sampled controller between a spring and a wall"
  coordinate Length h(start = 0.1 m), x(der(start = 1 m/s));
  discrete Force f(start = 0);
  discrete Integer turns(start = 0);
  state Real a(start = 0);
  gravity = -g_n*world.y;
  mass 1 kg at {x, h};
  force f - a*(1 N) on x;
  force (if x < -0.1 m then -(500 N/m)*(x + 0.1 m) else 0) on x;
  contact floor: h >= 0 with restitution = 0.5;
  output Force N = multiplier(floor);
equation
  der(a) = (der(x)/(1 m/s) - a)/(0.1 s);
  when sample(0, 0.05 s) then
    f = if x > 0 then -1 N else 1 N;
  end when;
  when x > 0.1 m then
    reinit(der(x), -0.9*der(x) - 0.02 m/s);
    turns = pre(turns) + 1;
  end when;
  when turns >= 5 then
    terminate("turned, turned");
  end when;
end Machine;
"""
CIRCLE = """
model Circle "A mass on a circle, without gravity"
  coordinate Length x(start = 0.6 m, der(start = 1 m/s)), y(start = -0.8 m);
  gravity = {0, 0, 0};
  mass 1 kg at {x, y};
  constraint x^2 + y^2 = 1 m2;
  annotation(experiment(StartTime = 1, StopTime = 2));
end Circle;
"""
SPUN = """
model Spun "A rod on two pins at one place: the angle of one of them is known up to whole turns"
  import Lag.Planar.*;
  Revolute a(q(der(start = 30 rad/s))), b;
  Link rod(l = 1 m, m = 1 kg);
  gravity = 0;
  connect(world, a, rod);
  connect(world.rotz(1 rad), b, rod.frame_a);
end Spun;
"""
EVENTFUL = ("newtons_cradle", "rimless_wheel", "ladder_leaving_wall", "valve_train")
Row = dict[str, float]


@dataclass(frozen=True)
class Ran:
    """Output of the example: rows, events as (time, kind, name), the error output."""

    code: int
    rows: list[Row]
    events: list[tuple[float, str, str]]
    errors: str


@dataclass(frozen=True)
class Module:
    """An exported module that is built."""

    folder: Path
    stem: str

    def run(self, stop: float, interval: float, tolerance: float) -> Ran:
        happened = self.folder / "events.csv"
        command = [str(self.folder / self.stem), repr(stop), repr(interval), repr(tolerance), str(happened)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        rows = [{name: float(x) for name, x in row.items()} for row in csv.DictReader(done.stdout.splitlines())]
        with happened.open(encoding="utf-8", newline="") as file:
            events = [(float(row["time"]), row["event"], row["name"]) for row in csv.DictReader(file)]
        return Ran(done.returncode, rows, events, done.stderr)


Build = Callable[..., Module]


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory, made: Made) -> Build:
    """Exports a model text and makes it, once."""

    @cache
    def built(text: str, flags: str = PLAIN) -> Module:
        folder = tmp_path_factory.mktemp("module")
        (folder / "model.lag").write_text(text, encoding="utf-8")
        done = CliRunner().invoke(lag, ["build", str(folder / "model.lag"), "--target", "c", "-o", str(folder)])
        assert done.exit_code == 0, done.output
        ready = made(folder, f"CFLAGS={flags}")
        assert (ready.returncode, ready.stderr) == (0, "")
        (header,) = folder.glob("*.h")
        return Module(folder, header.stem)

    return built


def test_the_ball_bounces_on_time_and_rests(build: Build) -> None:
    ran = build(BALL).run(6.0, 0.5, 1e-10)
    assert ran.code == 0, ran.errors
    assert ran.errors == ""
    impacts = [t for t, kind, _ in ran.events if kind == "impact"]
    fall = math.sqrt(2.0 / G)
    assert len(impacts) >= 20
    closed_form = fall + np.concatenate([[0.0], np.cumsum(2.0 * fall * 0.8 ** np.arange(1, len(impacts)))])
    np.testing.assert_allclose(impacts, closed_form, rtol=0.0, atol=1e-9)
    assert [kind for _, kind, _ in ran.events[-1:]] == ["closed"]
    assert ran.rows[-1]["N"] == pytest.approx(0.1 * G, rel=1e-12)
    assert abs(ran.rows[-1]["h"]) < 1e-12
    twice = [(a, b) for a, b in zip(ran.rows, ran.rows[1:], strict=False) if a["time"] == b["time"]]
    assert [a["time"] for a, _ in twice] == [t for t, _, _ in ran.events]
    for before, after in twice[:-2]:
        assert after["der(h)"] == pytest.approx(-0.8 * before["der(h)"], rel=1e-12)
    assert twice[-2][1]["der(h)"] == 0.0  # the last impact, where less than t_eps of the series is left
    assert [row["time"] for row in ran.rows if row["time"] * 2 % 1 == 0] == [0.5 * k for k in range(13)]


def test_the_same_events_as_numpy(build: Build) -> None:
    """Contact, clock, relation, clause and end; rows as near to each other as the tolerance."""
    ran = build(MACHINE).run(5.0, 0.05, 1e-9)
    motion = lagdsl.compile(MACHINE, engine="numpy").simulate(stop=5.0, interval=0.05, tolerance=1e-9)
    assert ran.code == 0, ran.errors
    assert [(kind, name) for _, kind, name in ran.events] == [(event.kind, event.name) for event in motion.events]
    assert {kind for _, kind, _ in ran.events} >= {"impact", "tick", "reinit", "true", "false", "terminate"}
    np.testing.assert_allclose([t for t, _, _ in ran.events], [event.time for event in motion.events], atol=1e-8)
    assert "turned, turned" in [name for t, _, name in ran.events if t == ran.events[-1][0]]
    instants = sorted({t for t, _, _ in ran.events if t > 0.0})
    grid = [t for t in (k / 20 for k in range(101)) if t < ran.events[-1][0]]
    assert sorted({row["time"] for row in ran.rows}) == sorted({*grid, *instants})
    for time in instants:
        (before, after) = (row for row in ran.rows if row["time"] == time)
        for side, found in (("left", before), ("right", after)):
            index = np.searchsorted(motion.time, time - 1e-7 if side == "left" else time + 1e-7) - (side == "right")
            for name in ("h", "x", "der(h)", "der(x)", "a", "f", "turns"):
                assert found[name] == pytest.approx(float(motion[name][index]), abs=1e-7), (time, side, name)
    assert ran.rows[-1]["turns"] == 5.0


def test_what_cannot_go_on_says_why(build: Build) -> None:
    pierced = build(BALL.replace("start = 1 m", "start = -1 m")).run(1.0, 0.1, 1e-8)
    assert pierced.code == 1
    assert "a contact is pierced at the start" in pierced.errors
    refused = build(BALL.replace("end Ball", 'equation when h < 0.5 m then assert(false, "low"); end when; end Ball'))
    ran = refused.run(1.0, 0.1, 1e-8)
    assert ran.code == 1
    assert f"t = {math.sqrt(1.0 / G):.6g} s: an assertion failed" in ran.errors


@pytest.mark.parametrize("method", spread(["rk4", "leapfrog", "ros2"], 2))
def test_steps_of_fixed_length_have_events_at_their_ends(build: Build, method: str) -> None:
    module = build(MACHINE)
    command = [str(module.folder / "realtime"), "1", "1e-4", method]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0
    quiet, eventful, height, sideways = done.stdout.splitlines()
    counts = [int(line.split()[0]) for line in (quiet, eventful)]
    assert sum(counts) == 10000
    exact = module.run(1.0, 1.0, 1e-9)
    ends = {math.ceil(t / 1e-4) for t, _, _ in exact.events if t > 0.0}  # what happens within one step is one there
    assert abs(counts[1] - len(ends)) <= 3
    assert re.fullmatch(r"\d+ steps of 0.0001 s with events: mean \S+ us, longest \S+ us, \d+ longer .*", eventful)
    assert float(sideways.split()[2]) == pytest.approx(exact.rows[-1]["x"], abs=2e-3)
    assert abs(float(height.split()[2])) < 1e-12  # at rest: what bounces for less than a step does not


def test_events_are_clean_under_sanitizers(build: Build) -> None:
    module = build(MACHINE, flags=SANITIZED)
    ran = module.run(5.0, 0.05, 1e-6)
    assert ran.code == 0, ran.errors
    assert ran.errors == ""
    for method in ("rk4", "leapfrog", "ros2"):
        command = [str(module.folder / "realtime"), "1", "1e-3", method]
        assert subprocess.run(command, capture_output=True, text=True, check=False).returncode == 0


def test_the_motion_starts_where_the_model_says(build: Build) -> None:
    """The rate that is given stays, the other one follows from the constraint; at the time that is told."""
    first, last = build(CIRCLE).run(1.5, 0.5, 1e-10).rows
    np.testing.assert_allclose(list(first.values()), [1.0, 0.6, -0.8, 1.0, 0.75], rtol=1e-12)
    angle = math.atan2(-0.8, 0.6) + 0.5 * 1.25
    np.testing.assert_allclose(list(last.values())[:3], [1.5, math.cos(angle), math.sin(angle)], rtol=1e-8)


def test_the_angle_of_a_cut_joint_is_continuous_from_row_to_row(build: Build) -> None:
    for row in build(SPUN).run(1.0, 0.05, 1e-10).rows:
        assert row["a.q"] == pytest.approx(30 * row["time"], abs=1e-7)
        assert row["b.q"] == pytest.approx(30 * row["time"] - 1, abs=1e-7)


@repeats("test_the_same_events_as_numpy")
@pytest.mark.parametrize("name", chosen(EVENTFUL, EVENTFUL[:1]))
def test_models_with_events_run_as_under_numpy(build: Build, root: Path, name: str) -> None:
    text = (root / "models" / f"{name}.lag").read_text(encoding="utf-8")
    model = lagdsl.compile(text, engine="numpy")
    stop = {"newtons_cradle": 2.0, "rimless_wheel": 3.0, "ladder_leaving_wall": 1.0, "valve_train": 0.05}[name]
    motion = model.simulate(stop=stop, interval=stop, tolerance=1e-10)
    ran = build(text).run(stop, stop, 1e-10)
    assert ran.code == 0, ran.errors
    assert [(kind, what) for _, kind, what in ran.events] == [(event.kind, event.name) for event in motion.events]
    assert ran.events
    np.testing.assert_allclose([t for t, _, _ in ran.events], [event.time for event in motion.events], atol=1e-9)
    for column in (*model.coordinates, *model.outputs):
        scale = float(np.max(np.abs(motion[column]), initial=1e-3))
        assert ran.rows[-1][column] == pytest.approx(float(motion[column][-1]), abs=1e-7 * scale), column


def test_the_page_of_the_module_is_true(build: Build) -> None:
    """Every command on it does what it says."""
    module = build(BALL)
    page = (module.folder / "README.md").read_text(encoding="utf-8")
    assert "MODEL" not in page
    listed = re.findall(r"^\| (`.*?`) \|", page, re.MULTILINE)
    own = this_machine()
    brought = own in PLATFORMS and installed_runtime(
        platform_of(own)
    )  # nothing where the runtime was edited since its installation
    for name in re.findall(r"`([\w./]+)`", " ".join(listed)):
        assert (module.folder / name).exists() == (name != "lib/" or bool(brought)), name
    (example,) = re.findall(r"^```c\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    includes, statements = example.split("\n\n", 1)
    body = f"{includes}\n#include <stdlib.h>\nint main(void) {{\n{statements}\nreturn status != LAG_OK;\n}}\n"
    (module.folder / "own.c").write_text(body, encoding="utf-8")
    command = "cc -std=c11 -Wall -Werror -I. own.c libBall.a -lm -o own && ./own"
    done = subprocess.run(command, shell=True, cwd=module.folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    for block in re.findall(r"^```sh\n(.*?)^```", page, re.MULTILINE | re.DOTALL):  # the last one begins from nothing
        if "clang" in block and (not ALL or shutil.which("clang") is None):
            continue
        quick = block.replace("-O2", PLAIN)  # the command is what it is about, not what the compiler makes of it
        done = subprocess.run(["sh", "-e"], input=quick, cwd=module.folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
