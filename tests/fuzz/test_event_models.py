"""Random models with events: both engines carry out the same motion, by the measure of `agreement`."""

from __future__ import annotations

import numpy as np
import pytest
from choice import ALL, EXPLORE, engines, repeats, spread
from fuzz.agreement import MOST_GRAZING, compare, told
from fuzz.event_models import event_model

import lagdsl

COUNT = 1000 if EXPLORE else 24 if ALL else 1


@repeats("test_independent.py")
def test_engines_agree_on_random_models(capsys: pytest.CaptureFixture[str]) -> None:
    reports = {seed: compare(event_model(seed)) for seed in range(COUNT)}
    wrong, grazing = told("both", reports, capsys)
    assert wrong == {}
    assert len(grazing) <= MOST_GRAZING * COUNT


def test_a_seed_is_one_model() -> None:
    assert event_model(7) == event_model(7)
    assert len({event_model(seed) for seed in range(50)}) == 50


@pytest.mark.parametrize("changed", spread(["force", "restitution"], 1))
def test_another_model_is_told_from_it(changed: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The measure is one: an engine that integrates a slightly different model does not pass."""
    text = """
    model Judged
      coordinate Real h(start = 1);
      kinetic 1/2*der(h)^2;
      potential 9.81*h;
      dissipation 1/2*0.1*der(h)^2;
      contact floor: h >= 0 with restitution = 0.8;
      annotation(units = "none", experiment(StopTime = 2));
    end Judged;
    """
    other = text.replace("9.81", "9.8100002") if changed == "force" else text.replace("0.8;", "0.8000001;")
    assert compare(text).verdict == "same"
    compile_as_written = lagdsl.compile
    monkeypatch.setattr(
        lagdsl,
        "compile",
        lambda source, *, engine: compile_as_written(other if engine == "c" else source, engine=engine),
    )
    report = compare(text)
    assert report.verdict == "differs", report


SAMPLED = """
model Sampled
  coordinate Real x(start = 1, der(start = 0.3)), y(start = 0.2);
  discrete Real u(start = 0), i(start = 0);
  kinetic 1/2*der(x)^2 + 1/2*(2 + cos(x))*der(y)^2;
  potential 1/2*9*x^2 + 3*cos(x - y);
  force u on x;
  contact stop: x >= -0.4 with restitution = 0.6;
  annotation(units = "none", experiment(StopTime = 2));
equation
  when sample(0, 0.07) then i = pre(i) + 0.07*x; end when;
  when sample(0.01, 0.1) then u = -4*x - der(x) - pre(i)/(1 + y^2); end when;
end Sampled;
"""


@pytest.mark.parametrize("engine", engines(["numpy", "c"]))
def test_sampled_controllers_are_the_same_to_the_bit_for_any_grid(engine: str) -> None:
    model = lagdsl.compile(SAMPLED, engine=engine)  # type: ignore[arg-type]
    motions = [model.simulate(interval=interval) for interval in (2.0, 0.07, 0.01, 0.000937, 0.3333)]
    for motion in motions[1:]:
        assert motion.events == motions[0].events
        for column, other in zip(motion.columns[1:], motions[0].columns[1:], strict=True):
            assert column.values[-1] == other.values[-1], column.name
            at = np.searchsorted(motion.time, [event.time for event in motion.events], side="right") - 1
            there = np.searchsorted(motions[0].time, [event.time for event in motion.events], side="right") - 1
            np.testing.assert_array_equal(column.values[at], other.values[there])


@pytest.mark.parametrize("engine", engines(["numpy", "c"]))
def test_every_instant_has_two_rows(engine: str) -> None:
    motion = lagdsl.compile(SAMPLED, engine=engine).simulate(interval=0.05)  # type: ignore[arg-type]
    for time in {event.time for event in motion.events} - {0.0}:
        assert np.count_nonzero(motion.time == time) == 2
    assert np.all(np.diff(motion.time) >= 0.0)
