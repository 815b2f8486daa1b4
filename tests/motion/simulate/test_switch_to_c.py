"""A motion that begins on the tape and goes on in C is that of the tape, to the bit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen

import lagdsl
from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.run import Run
from lagdsl.motion.simulate import stepping

MODELS = Path(__file__).parents[3] / "models"
# Smooth, contacts, closed loops with clocks, Zeno's series, friction, singular positions, stiff, states and inputs.
CHOSEN = chosen(
    ("double_pendulum", "bouncing_ball", "pick_and_place", "newtons_cradle", "clutch", "parallelogram", "half_car"),
    ("bouncing_ball", "clutch", "parallelogram"),
)


@pytest.fixture
def switches(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[float]:
    """The times at which runs go over to C: after one step, for which the compiler is waited for."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(stepping, "FIRST_STEPS", 1)
    worked, change, times = AutoEngine.worked, Run.change, []

    def wait(self: AutoEngine, seconds: float, left: float = 0.0) -> None:
        worked(self, 100.0, 100.0)
        if self._build is not None:
            self._build._thread.join()

    def remember(self: Run, model: object) -> None:
        times.append(self.t)
        change(self, model)  # type: ignore[arg-type]

    monkeypatch.setattr(AutoEngine, "worked", wait)
    monkeypatch.setattr(Run, "change", remember)
    return times


@pytest.mark.parametrize("name", CHOSEN)
def test_the_motion_is_that_of_the_tape(name: str, switches: list[float]) -> None:
    on_tape = lagdsl.compile(MODELS / f"{name}.lag", engine="tape").simulate()
    assert switches == []
    both = lagdsl.compile(MODELS / f"{name}.lag").simulate()
    (switch,) = switches
    assert on_tape.time[0] < switch < on_tape.time[-1]
    assert both.names == on_tape.names
    assert both.events == on_tape.events
    for column in on_tape.names:
        np.testing.assert_array_equal(both[column], on_tape[column], err_msg=column)


def test_short_first_steps_foretell_a_hundred_times_their_work(monkeypatch: pytest.MonkeyPatch) -> None:
    class ForeseenError(Exception):
        def __init__(self, seconds: float, left: float) -> None:
            self.seconds, self.left = seconds, left

    def tell(self: AutoEngine, seconds: float, left: float = 0.0) -> None:
        raise ForeseenError(seconds, left)

    monkeypatch.setattr(AutoEngine, "worked", tell)
    with pytest.raises(ForeseenError) as of_the_start:
        lagdsl.compile(MODELS / "pendulum.lag").simulate(stop=1e7, interval=1e7)
    assert of_the_start.value.left == stepping.FORETOLD * of_the_start.value.seconds


def test_a_run_is_not_given_another_model(monkeypatch: pytest.MonkeyPatch) -> None:
    one, other = (lagdsl.compile(MODELS / f"{name}.lag", engine="tape")._engine for name in ("pendulum", "four_bar"))
    started: list[Run] = []
    begin = Run.begin

    def keep(self: Run, t: float, x: np.ndarray) -> object:
        started.append(self)
        return begin(self, t, x)

    monkeypatch.setattr(Run, "begin", keep)
    monkeypatch.setattr(Run, "leave", lambda self: None)  # it goes on
    lagdsl.compile(MODELS / "pendulum.lag", engine="tape").simulate(stop=0.1)
    with pytest.raises(AssertionError, match="another one"):
        started[0].change(other.native)
    started[0].change(one.native)
