"""A session that was saved and restored goes on to the bit: in another session, in another process."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from choice import together

import lagdsl
from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.motion.sessions.session import Session

MODELS = Path(__file__).parents[3] / "models"
# Two masses of which one is pushed by a force that a controller computes one period late.
LATE = """
model Late
  coordinate Length x(start = 1 m), y;
  input Force F;
  Lag.Blocks.UnitDelay late(u = 3*x/(1 m) + der(x)*(1 s/m), period = 30 ms);
  mass 2 kg at {x, y};
  force (F - late.y*(1 N))*world.x at {x, y};
  force (F - 5*y*(1 N/m))*world.y at {x, y};
end Late;
"""
# Bounces and their end, chains of impacts, friction that sticks and slips, on belts, with forces that depend on
# multipliers, clocks, delays, stiff states, closed loops through singular positions, rolling, rocking.
TEXTS = {
    name: (MODELS / f"{name}.lag").read_text(encoding="utf-8")
    for name in (
        "bouncing_ball",
        "newtons_cradle",
        "stick_slip_belt",
        "sliding_cube",
        "drum_brake",
        "clutch",
        "furuta_swing_up",
        "van_der_pol",
        "parallelogram",
        "disc_starts_to_roll",
        "rocking_block",
    )
} | {"late": LATE}
STEPS = 23


@cache
def model(name: str) -> lagdsl.Model:
    return lagdsl.compile(TEXTS[name], engine="tape")


def length(name: str) -> float:
    experiment = model(name)._compilation.flat.experiment
    return 0.1 if name == "furuta_swing_up" else (experiment.stop_time - experiment.start_time) / STEPS


def values(run: Session) -> list[str]:
    return [float(run[name]).hex() for name in run.keys()]  # noqa: SIM118  a session is no dict


@together("name", TEXTS)
def test_the_rest_is_equal_to_the_bit(name: str) -> None:
    run, other = model(name).session(), model(name).session(record=False)
    h = length(name)
    for k in range(STEPS):
        state, known = run.save(), len(run.events)
        other.restore(state)
        assert other.save() == state
        for each in (run, other):
            each.step(h, u={"F": float(k % 5)} if name == "late" else None)
        assert values(other) == values(run)
        assert other.events == run.events[known:]
    assert other.save() == run.save()


def test_a_step_can_be_tried_and_taken_back() -> None:
    run, straight = model("late").session(), model("late").session()
    for k in range(10):
        state = run.save()
        run.step(0.5, u=20.0)
        run.restore(state)
        for each in (run, straight):
            each.step(0.1, u=float(k))
    assert values(run) == values(straight)
    assert run.motion.time[0] == pytest.approx(0.9)  # rows begin where it was restored


THERE = """
import json, sys
import lagdsl
for text, state, h, count in json.load(sys.stdin):
    run = lagdsl.compile(text, engine="auto").session()
    run.restore(bytes.fromhex(state))
    for _ in range(count):
        run.step(h)
    print(" ".join(float(run[name]).hex() for name in run.keys()))
"""


def test_another_process_goes_on_to_the_bit() -> None:
    """There on the engine `auto`, under another seed of hashes."""
    cases, expected = [], []
    for name in ("bouncing_ball", "stick_slip_belt", "drum_brake", "late"):
        run, h = model(name).session(), length(name)
        for _ in range(STEPS // 2):
            run.step(h)
        cases.append((TEXTS[name], run.save().hex(), h, 5))
        for _ in range(5):
            run.step(h)
        expected.append(" ".join(values(run)))
    done = subprocess.run(
        [sys.executable, "-c", THERE],
        input=json.dumps(cases),
        capture_output=True,
        text=True,
        check=True,
        env={"PYTHONHASHSEED": "7", "PATH": "/usr/bin:/bin"},
    )
    assert done.stdout.split("\n")[:-1] == expected


def test_parameters_inputs_and_tolerance_come_with_it() -> None:
    first = model("late").session(inputs={"F": 2.0}, tolerance=1e-5, start={"y": "30 cm"})
    first.step(0.4)
    second = model("late").session()
    second.restore(first.save())
    for each in (first, second):
        each.step(0.4)
    assert values(second) == values(first)
    ball = model("bouncing_ball")
    high, low = ball.session(start={"h": 3.0}), ball.session()
    high.step(1.0)
    low.restore(high.save())
    low.reset()
    assert low["h"] == 1.0


def test_free_parameters_are_those_that_were_found() -> None:
    text = """
    model Found
      parameter Stiffness k(fixed = false, start = 3 N/m);
      coordinate Length x(start = 0.1 m, fixed = true, der(start = 0, fixed = true));
      mass 1 kg at {x, 0};
      potential 1/2*k*x^2;
    initial equation
      der(der(x)) = -0.5 m/s^2;
    end Found;
    """
    found = lagdsl.compile(text, engine="tape")
    one, other = found.session(), found.session(start={"x": 0.2})
    one.step(0.3)
    other.restore(one.save())
    for each in (one, other):
        each.step(0.3)
    assert one["x"] == pytest.approx(0.1 * np.cos(np.sqrt(5.0) * 0.6), rel=1e-6)
    assert values(other) == values(one)


def test_foreign_bytes_are_refused() -> None:
    run, other = model("late").session(), model("clutch").session()
    run.step(0.1)
    state = run.save()
    called = lagdsl.compile(LATE, engine="tape").session(inputs={"F": lambda t: t})
    edited = lagdsl.compile(LATE.replace("2 kg", "3 kg"), engine="tape").session()
    aged = state.replace(lagdsl.__version__.encode(), b"0.0.0", 1)
    for session, given, why in [
        (run, b"", "no state"),
        (run, state[:-1], "cut off"),
        (run, state[:200] + bytes([state[200] ^ 1]) + state[201:], "changed"),
        (run, aged, "cut off or changed"),
        (other, state, "`Late`, not to `Clutch`"),
        (edited, state, "another text of `Late`"),
        (called, state, "no input followed time"),
    ]:
        before = session.save()
        with pytest.raises(lagdsl.CallRefused, match=f"E0891.*{why}"):
            session.restore(given)
        assert session.save() == before


def test_another_version_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    run = model("late").session()
    state = run.save()
    monkeypatch.setattr("lagdsl.motion.sessions.saved.__version__", "99.0")
    with pytest.raises(lagdsl.CallRefused, match=r"E0891.*this is version 99\.0"):
        run.restore(state)


def test_a_session_that_has_gone_over_to_c_is_saved(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The engine `auto` is told that there is much to do, and waited for; its bytes are those of the tape."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    auto, tape = lagdsl.compile(TEXTS["clutch"]), model("clutch").session()
    runs, run = auto.sessions(3), auto.session()
    engine = auto._engine
    assert isinstance(engine, AutoEngine)
    for k in range(10):
        for each in (runs, run, tape):
            each.step(0.05)
        if k == 3:
            engine.worked(100.0, 100.0)
            assert engine._build is not None
            engine._build._thread.join()
        assert engine.is_compiled == (k > 3)
        assert run.save() == runs[1].save() == tape.save()


def test_compiled_c_of_this_processor_rounds_otherwise() -> None:
    text = "model Free coordinate Length x(start = 1 m); mass 1 kg at {x, 0}; end Free;"
    run = lagdsl.compile(text, engine="tape").session()
    with pytest.raises(lagdsl.CallRefused, match=r"E0891.*round otherwise"):
        lagdsl.compile(text, engine="c").session().restore(run.save())
