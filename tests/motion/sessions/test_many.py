"""Many sessions in one call: each is what it is alone, to the bit, in any number of threads."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import together

import lagdsl
from lagdsl.motion.sessions import many

MODELS = Path(__file__).parents[3] / "models"
# x'' = F/m; it ends where x passes 2 m, and fails below -2 m.
ENDING = """
model Ending
  parameter Mass m = 2 kg;
  coordinate Length x(start = 1 m), q[2](start = {1 m, 2 m});
  input Force F;
  mass m at {x, 0};
  mass 1 kg at {q[1], q[2]};
  force F*world.x at {x, 0};
  output Length twice = 2*x;
equation
  when x > 2 m then
    terminate("far");
  end when;
  assert(x > -2 m, "lost");
end Ending;
"""


@pytest.mark.parametrize("threads", [1, 3])
def test_each_is_what_it_is_alone(threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many, "_FEWEST", 2)
    model = lagdsl.compile(MODELS / "bouncing_ball.lag", engine="tape")
    heights = np.linspace(0.5, 2.0, 7)
    runs = model.sessions(7, start={"h": heights}, parameters={}, threads=threads)
    alone = [model.session(start={"h": height}) for height in heights]
    for _ in range(10):
        runs.step("0.2 s")
        for each in alone:
            each.step(0.2)
        assert runs["h"].tolist() == [each["h"] for each in alone]
        assert runs["N"].tolist() == [each["N"] for each in alone]
    assert runs.t.tolist() == [2.0] * 7
    assert [run.save() for run in runs] == [each.save() for each in alone]
    assert len(runs[2].events) < len(alone[2].events)  # those of the last step


def test_inputs_of_each() -> None:
    """x = 1 + F t^2/(2 m)."""
    runs = lagdsl.compile(ENDING, engine="tape").sessions(3, parameters={"m": [1.0, 2.0, 4.0]})
    forces = np.array([1.0, -1.0, 2.0])
    runs.step(1.0, u=forces)
    expected = 1.0 + forces / (2.0 * np.array([1.0, 2.0, 4.0]))
    np.testing.assert_allclose(runs["x"], expected, rtol=1e-12)
    np.testing.assert_allclose(runs["twice"], 2.0 * expected, rtol=1e-12)
    np.testing.assert_array_equal(runs["q"], [[1.0, 2.0]] * 3)
    for given in (2.0, [[2.0], [2.0], [2.0]], {"F": "2 N"}, {"F": [2.0, 2.0, 2.0]}):
        runs.reset()
        runs.step(0.5, u=given)  # type: ignore[arg-type]
        np.testing.assert_allclose(runs["x"], 1.0 + 0.25 / np.array([1.0, 2.0, 4.0]), rtol=1e-12)


def test_one_that_has_ended_stays() -> None:
    """x = 1 + F t^2/4: 4 N lead to 2 m at 1 s, -6 N to -2 m before 1.5 s."""
    runs = lagdsl.compile(ENDING, engine="tape").sessions(3)
    runs.advance(2.0, u=[4.0, -6.0, 0.0])
    assert runs.ended.tolist() == [True, True, False]
    assert list(runs.failures) == [1]
    assert "lost" in runs.failures[1]
    assert runs.t[0] == pytest.approx(1.0, rel=1e-9)
    assert runs.t[2] == 2.0
    runs.step(1.0)
    assert runs.t[2] == 3.0
    assert runs.t[0] == pytest.approx(1.0, rel=1e-9)
    runs.reset(runs.ended, start={"x": [0.0, 0.5]})
    assert runs.ended.tolist() == [False, False, False]
    assert runs.failures == {}
    runs.step(0.5)
    assert runs["x"].tolist() == [0.0, 0.5, 1.0]
    assert runs.t.tolist() == [0.5, 0.5, 3.5]


def test_all_are_saved_and_restored() -> None:
    runs = lagdsl.compile(MODELS / "stick_slip_belt.lag", engine="tape").sessions(4, start={"x": [0.0, 0.1, 0.2, 0.3]})
    runs.step(3.0)
    states = runs.save()
    ends = []
    for _ in range(2):
        runs.step(2.0)
        ends.append(runs["x"].tolist())
        runs.restore(states)
    assert ends[0] == ends[1]


@together(
    ("call", "code"),
    [
        (lambda runs: runs.step(0.0), "E0896"),
        (lambda runs: runs.step(0.1, u=[1.0, 2.0]), "E0893"),
        (lambda runs: runs.step(0.1, u={"F": [1.0, 2.0]}), "E0893"),
        (lambda runs: runs.step(0.1, u=[1.0, np.nan, 2.0]), "E0893"),
        (lambda runs: runs.advance(0.05), "E0890"),
        (lambda runs: runs.reset([0], start={"x": [1.0, 2.0]}), "E0893"),
        (lambda runs: runs.reset(start={"y": 1.0}), "E0874"),
        (lambda runs: runs.restore([]), "E0891"),
        (lambda runs: runs["nothing"], "E0874"),
    ],
)
def test_bad_calls_change_nothing(call, code: str) -> None:  # type: ignore[no-untyped-def]
    runs = lagdsl.compile(ENDING, engine="tape").sessions(3)
    runs.step(0.1)
    before = runs.save()
    with pytest.raises((lagdsl.CallRefused, lagdsl.UnknownName)) as refused:
        call(runs)
    assert [each.code for each in refused.value.diagnostics] == [code]
    assert runs.save() == before


def test_one_of_them_may_go_its_own_way() -> None:
    """With other parameters it lies in other memory; rows that are known are those of before."""
    runs = lagdsl.compile(ENDING, engine="tape").sessions(3)
    runs.step(1.0, u=1.0)
    np.testing.assert_allclose(runs["twice"], [2.5, 2.5, 2.5], rtol=1e-12)
    runs[1].step(0.5)
    np.testing.assert_allclose(runs["twice"], [2.5, 3.125, 2.5], rtol=1e-12)
    runs[2].reset(parameters={"m": 1.0})
    with pytest.raises(lagdsl.SimulationFailed, match="lost"):
        runs[0].step(9.0, u=-9.0)
    assert (list(runs.failures), runs.ended.tolist()) == ([0], [True, False, False])
    runs.step(1.0, u=0.5)
    assert runs["twice"][2] == pytest.approx(2.0 * (1.0 + 0.25), rel=1e-12)
    assert runs.t[2] == 1.0


def test_numbers_of_sessions_and_threads() -> None:
    model = lagdsl.compile(ENDING, engine="tape")
    for count, threads in ((0, None), (3, 0)):
        with pytest.raises(ValueError, match="at least 1"):
            model.sessions(count, threads=threads)
    with pytest.raises(lagdsl.CallRefused, match="E0893"):
        model.sessions(3, start={"x": [1.0, 2.0]})
    called = model.sessions(40, inputs={"F": lambda t: 2.0 * t})  # x = 1 + t^3/6
    called.step(1.0)
    np.testing.assert_allclose(called["x"], 1.0 + 1.0 / 6.0, rtol=1e-9)
