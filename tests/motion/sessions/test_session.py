"""A motion by steps: closed forms, the motion of `simulate`, events inside a step, inputs that jump between steps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import engines, together

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

MODELS = Path(__file__).parents[3] / "models"
# A mass that a force pushes: with a held force F the place after h is x + v h + F h^2/(2 m), exactly.
PUSHED = """
model Pushed
  parameter Mass m = 2 kg;
  coordinate Length x(start = 1 m);
  input Force F(max = 9 N);
  mass m at {x, 0};
  force F*world.x at {x, 0};
  output Length twice = 2*x;
end Pushed;
"""
# The pivot of a pendulum is led with a speed. Where it jumps, the momentum of the angle stays: l th' + v cos(th).
LED = """
model Led
  coordinate Length x;
  coordinate Angle th(start = 0);
  input Velocity v(smooth = 1);
  mass 3 kg at {x, 0};
  mass 1 kg at {x, 0} + 2 m*{sin(th), -cos(th)};
  gravity = -g_n*world.y;
  constraint der(x) = v;
end Led;
"""


@pytest.mark.parametrize("engine", engines(["tape", "c", "auto"]))
def test_the_motion_is_that_of_simulate(engine: EngineName) -> None:
    model = lagdsl.compile(MODELS / "double_pendulum.lag", engine=engine)
    start, parameters = {"a": "20 deg", "der(b)": 0.3}, {"l1": "40 cm"}
    run = model.session(start=start, parameters=parameters, tolerance=1e-9)
    for _ in range(20):
        run.step("50 ms")
    motion = model.simulate(stop=1.0, interval=0.05, start=start, parameters=parameters, tolerance=1e-9)
    assert run.t == 1.0
    assert run.motion.names == motion.names
    np.testing.assert_array_equal(run.motion.time, motion.time)
    for name in motion.names:
        np.testing.assert_allclose(run.motion[name], motion[name], atol=1e-7)
        assert run[name] == run.motion[name][-1]


def test_a_method_of_fixed_step() -> None:
    """Of order four: half the step, a sixteenth of the error."""
    model = lagdsl.compile(
        "model S coordinate Length x(start = 1 m); mass 1 kg at {x, 0}; potential 1/2*(1 N/m)*x^2; end S;",
        engine="tape",
    )
    errors = []
    for step in (0.1, 0.05):
        run = model.session(solver="rk4", step=step)
        run.advance(2.0)
        errors.append(run["x"] - np.cos(2.0))
    assert errors[0] / errors[1] == pytest.approx(16.0, rel=0.1)
    for options in ({"solver": "rk4"}, {"solver": "none"}, {"tolerance": 1.0}, {"solver": "rk4", "step": -1.0}):
        with pytest.raises(ValueError, match=r"step|solver|tolerance"):
            model.session(**options)  # type: ignore[arg-type]


def test_bounces_inside_one_step() -> None:
    """A ball from the height h with restitution e: it strikes at t1 = sqrt(2 h/g), then after flights of 2 t1 e^k."""
    run = lagdsl.compile(MODELS / "bouncing_ball.lag", engine="tape").session(start={"h": "2 m"})
    run.step(4.5)
    times = np.array([event.time for event in run.events if event.kind == "impact"][:6])
    first = np.sqrt(2.0 * 2.0 / 9.80665)
    flights = 2.0 * first * 0.8 ** np.arange(1.0, 6.0)
    np.testing.assert_allclose(times, first + np.append(0.0, np.cumsum(flights)), rtol=1e-9)
    assert {event.name for event in run.events} == {"floor"}


def test_inputs_are_held_over_steps() -> None:
    run = lagdsl.compile(PUSHED, engine="tape").session(inputs={"F": "1 N"})
    x, v, h, forces = 1.0, 0.0, 0.1, [None, 3.0, {"F": "-4 N"}, [2.0], None]
    for given, force in zip(forces, [1.0, 3.0, -4.0, 2.0, 2.0], strict=True):
        run.step(h, u=given)
        x, v = x + h * v + force * h * h / 4.0, v + force * h / 2.0
        assert run["x"] == pytest.approx(x, rel=1e-13)
        assert run["der(x)"] == pytest.approx(v, rel=1e-13)
        assert run["twice"] == 2.0 * run["x"]
    assert run.t == 0.5  # five steps of 0.1 s, counted


def test_a_signal_follows_time_beside_them() -> None:
    """F = t up to 1 s, then 0: v = t^2/4, and stays."""
    run = lagdsl.compile(PUSHED, engine="tape").session(inputs={"F": ([0.0, 1.0, 1.0, 3.0], [0.0, 1.0, 0.0, 0.0])})
    run.advance("0.8 s")
    assert run["der(x)"] == pytest.approx(0.16, rel=1e-9)
    run.step(1.0)
    assert run["der(x)"] == pytest.approx(0.25, rel=1e-9)
    with pytest.raises(lagdsl.CallRefused, match=r"E0893.*ends at 3 s"):
        run.step(2.0)
    called = lagdsl.compile(PUSHED, engine="tape").session(inputs={"F": lambda t: 6.0 * t})
    called.step(1.0)
    assert called["der(x)"] == pytest.approx(1.5, rel=1e-9)


def test_a_speed_that_jumps_between_steps_is_a_blow() -> None:
    """th = 0 before it: l th' + v = 0 behind it, as no impulse acts along th."""
    run = lagdsl.compile(LED, engine="tape").session()
    run.step(0.5)
    assert run["der(th)"] == 0.0
    run.step(1e-6, u=1.5)
    assert run["der(x)"] == pytest.approx(1.5)
    assert run["der(th)"] == pytest.approx(-1.5 / 2.0, rel=1e-6)


def test_inputs_that_wait_for_the_next_step_are_saved() -> None:
    run = lagdsl.compile(LED, engine="tape").session()
    run.advance(0.0, u=1.5)
    other = lagdsl.compile(LED, engine="tape").session()
    other.restore(run.save())
    for each in (run, other):
        assert each["der(x)"] == 0.0
        each.step(1e-6)
        assert each["der(th)"] == pytest.approx(-1.5 / 2.0, rel=1e-6)


def test_relations_turn_with_an_input_between_steps() -> None:
    text = PUSHED.replace("output", "discrete Integer n(start = 0); when F > 2 N then n = pre(n) + 1; end when; output")
    run = lagdsl.compile(text, engine="tape").session()
    for force, count in [(1.0, 0), (3.0, 1), (4.0, 1), (0.0, 1), (5.0, 2)]:
        run.step(0.1, u=force)
        assert run["n"] == count
    assert [(e.time, e.kind) for e in run.events] == [(0.1, "true"), (0.3, "false"), (0.4, "true")]


def test_a_tick_at_the_end_of_a_step_belongs_to_the_next_one() -> None:
    text = PUSHED.replace("output", "discrete Force s(start = 0); when sample(0.3, 0.3) then s = F; end when; output")
    run = lagdsl.compile(text, engine="tape").session()
    for k in range(3):
        run.step(0.1, u=float(k))
    assert run["s"] == 0.0
    run.step(0.1, u=7.0)
    assert run["s"] == 7.0


def test_terminate_ends_it() -> None:
    text = PUSHED.replace("output", 'when x > 2 m then terminate("far"); end when; output')
    run = lagdsl.compile(text, engine="tape").session()
    run.step(5.0, u=4.0)  # x = 1 + t^2
    assert run.ended
    assert run.t == pytest.approx(1.0, rel=1e-9)
    assert [event.kind for event in run.events][-1] == "terminate"
    with pytest.raises(lagdsl.CallRefused, match=r"E0892.*far"):
        run.step(0.1)
    run.reset()
    assert (run.t, run["x"], run.ended, run.events) == (0.0, 1.0, False, ())
    run.step(0.1)
    assert run["x"] == 1.0  # the inputs are those of the start, too


def test_a_failure_keeps_the_motion() -> None:
    text = PUSHED.replace("end P", 'equation assert(x < 2 m, "too far"); end P')
    run = lagdsl.compile(text, engine="tape").session()
    run.step(0.5, u=4.0)
    with pytest.raises(lagdsl.SimulationFailed, match="too far") as failed:
        run.step(1.0)
    assert 1.0 < failed.value.time <= 1.5  # the end of the first step of the method behind it
    assert failed.value.trajectory["x"][1] == pytest.approx(1.25)
    with pytest.raises(lagdsl.CallRefused, match="E0892"):
        run.advance(2.0)


def test_reset_takes_other_starts_and_parameters() -> None:
    run = lagdsl.compile(PUSHED, engine="tape").session(start={"x": 3.0}, inputs={"F": 8.0})
    run.step(0.3, u=1.0)
    run.reset(start={"der(x)": "1 m/s"}, parameters={"m": "4 kg"})
    run.step(1.0)
    assert run["x"] == pytest.approx(3.0 + 1.0 + 1.0, rel=1e-12)
    with pytest.raises(lagdsl.UnknownName):
        run.reset(start={"y": 1.0})
    assert run["x"] == pytest.approx(5.0, rel=1e-12)


def test_a_reset_without_a_start_ends_it() -> None:
    text = PUSHED.replace("output", "parameter Length a = 2 m; coordinate Length z(start = 1 m); output").replace(
        "end P", "constraint z^2 = a^2 - 1 m^2; mass 1 kg at {0, z}; end P"
    )
    run = lagdsl.compile(text, engine="tape").session()
    run.step(0.1)
    with pytest.raises(lagdsl.CompilationFailed, match="E0802"):
        run.reset(parameters={"a": "50 cm"})
    with pytest.raises(lagdsl.CallRefused, match="E0892"):
        run.step(0.1)
    run.reset(parameters={"a": np.sqrt(5.0)})
    assert run["z"] == pytest.approx(2.0)


def test_without_a_record_it_keeps_the_last_step() -> None:
    run = lagdsl.compile(MODELS / "bouncing_ball.lag", engine="tape").session(record=False)
    run.step(0.6)
    assert len(run.events) == 1
    run.step(0.1)
    assert run.events == ()
    with pytest.raises(lagdsl.CallRefused, match="E0895"):
        _ = run.motion


def test_the_motion_shows_figures_and_no_page() -> None:
    run = lagdsl.compile(PUSHED, engine="tape").session()
    run.step(1.0, u=1.0)
    assert run.motion._repr_html_() is None
    with pytest.raises(lagdsl.CallRefused, match="E0897"):
        run.motion.show()


def test_warnings_go_to_the_sink() -> None:
    sink = lagdsl.foundation.diagnostics.Sink()  # type: ignore[attr-defined]
    run = lagdsl.compile(PUSHED, engine="tape").session(sink=sink)
    run.step(0.1, u=12.0)
    run.step(0.1, u=13.0)
    assert [each.code for each in sink.diagnostics] == ["W0328"]


@together(
    ("call", "code"),
    [
        (lambda run: run.step(0.0), "E0896"),
        (lambda run: run.step(-1.0), "E0896"),
        (lambda run: run.step(float("nan")), "E0896"),
        (lambda run: run.step("2 kg"), "E0896"),
        (lambda run: run.step(None), "E0896"),
        (lambda run: run.advance("2 kg"), "E0896"),
        (lambda run: run.advance(float("inf")), "E0896"),
        (lambda run: run.advance(0.05), "E0890"),
        (lambda run: run["nothing"], "E0874"),
        (lambda run: run.step(0.1, u=[1.0, 2.0]), "E0893"),
        (lambda run: run.step(0.1, u="much"), "E0893"),
        (lambda run: run.step(0.1, u=float("nan")), "E0893"),
        (lambda run: run.step(0.1, u={"G": 1.0}), "E0874"),
        (lambda run: run.step(0.1, u={"F": [1.0, 2.0]}), "E0893"),
        (lambda run: run.restore(b"nothing"), "E0891"),
    ],
)
def test_bad_calls_change_nothing(call, code: str) -> None:  # type: ignore[no-untyped-def]
    run = lagdsl.compile(PUSHED, engine="tape").session()
    run.step(0.1, u=1.0)
    before = run.save()
    with pytest.raises((lagdsl.CallRefused, lagdsl.UnknownName)) as refused:
        call(run)
    assert [each.code for each in refused.value.diagnostics] == [code]
    assert run.save() == before


def test_inputs_that_a_step_cannot_set() -> None:
    text = PUSHED.replace("F*world.x", "(F + 2 N.s/m*der(w))*world.x").replace(
        "output", "input Length w(smooth = 1); output"
    )
    run = lagdsl.compile(text, engine="tape").session(inputs={"F": lambda t: t})
    for given in ({"w": 1.0}, {"der(w)": 1.0}, {"F": 1.0}):
        with pytest.raises(lagdsl.CallRefused, match="E0893"):
            run.step(0.1, u=given)
    with pytest.raises(lagdsl.CallRefused, match="E0894"):
        lagdsl.compile(PUSHED, engine="numpy").session()
