"""Rules of events that random models have found wanting, each against a closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.motion.simulate.failure import SimulationFailed

ENGINES = engines(("numpy", "c"))


def model(text: str, engine: EngineName) -> lagdsl.Model:
    return lagdsl.compile(f'model M\nannotation(units = "none");\n{text}\nend M;', engine=engine)


@pytest.mark.parametrize("engine", ENGINES)
def test_flights_shorter_than_a_step_end_on_time(engine: EngineName) -> None:
    """The last of them last a ten thousandth of the steps that the integrator would take."""
    text = """
      coordinate Real h(start = 1);
      kinetic 1/2*der(h)^2;
      potential 10*h;
      contact floor: h >= 0 with restitution = 0.1, v_stick = 1e-7, t_eps = 1e-12;
    """
    events = model(text, engine).simulate(stop=1.0).events
    fall = math.sqrt(0.2)
    times = fall + np.concatenate([[0.0], np.cumsum(2.0 * fall * 0.1 ** np.arange(1, 7))])
    assert [event.kind for event in events[:7]] == ["impact"] * 7
    np.testing.assert_allclose([event.time for event in events[:7]], times, rtol=0, atol=1e-12)


@pytest.mark.parametrize("engine", ENGINES)
def test_bounces_rest_by_the_experiment_and_not_by_the_run(engine: EngineName) -> None:
    """2 v/g/(1 - e) = 2 e^n fall/(1 - e) is left after the impact n: it holds where that is less than 5e-6 s."""
    text = """
      coordinate Real h(start = 1);
      kinetic 1/2*der(h)^2;
      potential 10*h;
      contact floor: h >= 0 with restitution = 0.5;
      annotation(experiment(StopTime = 5));
    """
    found = [[event.time for event in model(text, engine).simulate(stop=stop).events] for stop in (1.5, 5.0, 90.0)]
    fall = math.sqrt(0.2)
    count = next(n for n in range(1, 99) if 4 * fall * 0.5**n < 5e-6)
    times = [*(fall * (1 + 2 * sum(0.5**k for k in range(1, n))) for n in range(1, count + 1)), 3 * fall]
    for each in found:
        np.testing.assert_allclose(each, times, rtol=0, atol=1e-9)


@pytest.mark.parametrize("engine", ENGINES)
def test_what_comes_and_goes_within_a_quarter_of_a_step_is_found(engine: EngineName) -> None:
    """x = sin(t) is above 0.9999 for 2 arccos(0.9999) = 0.03 s; steps are longer than a quarter of that."""
    text = """
      coordinate Real x(der(start = 1));
      discrete Integer n(start = 0);
      kinetic 1/2*der(x)^2;
      potential 1/2*x^2;
    equation
      when x > 0.9999 then n = pre(n) + 1; end when;
    """
    motion = model(text, engine).simulate(stop=14.0, tolerance=1e-4)
    half = math.acos(0.9999)
    tops = math.pi / 2 + 2.0 * math.pi * np.arange(2)
    times = np.sort(np.concatenate([tops - half, tops + half]))
    assert motion["n"][-1] == 2.0
    np.testing.assert_allclose([event.time for event in motion.events], times, atol=5e-3)


@pytest.mark.parametrize("engine", ENGINES)
def test_discretes_in_a_constraint_take_hold_by_the_least_impulse(engine: EngineName) -> None:
    """A mass on a line is caught by another: M v is kept, as after a plastic impact."""
    text = """
      coordinate Real x(der(start = 3)), y(start = 1);
      discrete Real caught(start = 0);
      kinetic 1/2*2*der(x)^2 + 1/2*4*der(y)^2;
      constraint caught*(der(x) - der(y)) = 0;
    equation
      when x >= 1 then caught = 1; end when;
    """
    motion = model(text, engine).simulate(stop=1.0)
    row = int(np.flatnonzero(np.diff(motion.time) == 0.0)[0]) + 1
    assert motion.time[row] == pytest.approx(1.0 / 3.0, abs=1e-12)
    for at in (row, -1):
        assert motion["der(x)"][at] == pytest.approx(1.0, abs=1e-12)
        assert motion["der(y)"][at] == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_blow_lifts_the_other_end_of_a_plank(engine: EngineName) -> None:
    """A ball falls beyond the left support of a plank on two: the right end leaves it, with the rates of the impact
    about the left support (e = 0): (J + m c^2 + mb d^2) w = mb d v."""
    text = """
      coordinate Real y, a, h(start = 1);
      kinetic 1/2*3*der(y)^2 + 1/2*0.5*der(a)^2 + 1/2*2*der(h)^2;
      potential 10*(3*y + 2*h);
      contact left: y - 0.5*a >= 0 with restitution = 0;
      contact right: y + 0.5*a >= 0 with restitution = 0;
      contact ball: h - (y - a) >= 0 with restitution = 0;
    """
    motion = model(text, engine).simulate(stop=0.5)
    told = {(event.name, event.kind) for event in motion.events if event.time < 0.45}
    assert ("right", "opened") in told and not any(name == "left" for name, _ in told)
    speed = math.sqrt(20.0)
    turning = 2.0 * 0.5 * speed / (0.5 + 3.0 * 0.25 + 2.0 * 0.25)
    time = next(event.time for event in motion.events if event.name == "right")
    row = int(np.flatnonzero(motion.time == time)[-1])
    assert time == pytest.approx(math.sqrt(0.2), abs=1e-9)
    assert motion["der(a)"][row] == pytest.approx(turning, rel=1e-9)
    assert motion["der(y)"][row] == pytest.approx(0.5 * turning, rel=1e-9)
    assert motion["der(h)"][row] == pytest.approx(-0.5 * turning, rel=1e-9)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_gap_that_a_discrete_opens_is_open(engine: EngineName) -> None:
    text = """
      coordinate Real h;
      discrete Real floor(start = 0);
      kinetic 1/2*der(h)^2;
      potential 10*h;
      contact c: h >= floor with restitution = 0;
    equation
      when time >= 0.5 then floor = -0.2; end when;
    """
    motion = model(text, engine).simulate(stop=1.0)
    kinds = [(event.kind, round(event.time, 9)) for event in motion.events if event.name == "c"]
    assert kinds == [("opened", 0.5), ("impact", 0.7), ("closed", 0.7)]
    assert motion["h"][-1] == pytest.approx(-0.2, abs=1e-12)


def test_a_rocking_box_comes_to_rest() -> None:
    """Each landing without rebound turns w into w (J - m c^2)/(J + m c^2); the landings accumulate."""
    text = """
      coordinate Real y(start = 0.05), a(start = 0.1);
      kinetic 1/2*der(y)^2 + 1/2*0.6*der(a)^2;
      potential 10*y;
      contact left: y - 0.5*a >= 0 with restitution = 0;
      contact right: y + 0.5*a >= 0 with restitution = 0;
    """
    motion = model(text, "c").simulate(stop=3.0)
    ratio, pull = (0.6 - 0.25) / 0.85, 10.0 * 0.5 / 0.85
    first = math.sqrt(2.0 * 0.1 / pull)
    landings = first + np.concatenate([[0.0], np.cumsum(2.0 * first * ratio ** np.arange(1, 6))])
    times = [event.time for event in motion.events if event.kind == "closed"]
    np.testing.assert_allclose(times[:6], landings, rtol=0, atol=1e-9)
    assert [event.name for event in motion.events if event.kind == "closed"][:4] == ["right", "left"] * 2
    assert times[-1] == pytest.approx(first + 2.0 * first * ratio / (1.0 - ratio), abs=1e-6)  # the sum of them all
    assert len(times) <= 1 + math.ceil(
        math.log(3e-6 * (1.0 - ratio) / (2.0 * first)) / math.log(ratio)
    )  # then they are held
    assert abs(motion["a"][-1]) < 1e-12 and abs(motion["der(a)"][-1]) < 1e-12


@pytest.mark.parametrize("engine", ENGINES)
def test_an_input_that_jumps_is_an_event(engine: EngineName) -> None:
    text = """
      input Real u = 0;
      coordinate Real x;
      discrete Integer n(start = 0);
      kinetic 1/2*der(x)^2;
      force u on x;
    equation
      when u > 0.5 then n = pre(n) + 1; end when;
    """
    table = ([0.0, 0.3, 0.3, 0.6, 0.6, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0, 0.0])
    motion = model(text, engine).simulate(stop=1.0, inputs={"u": table})
    assert [(event.kind, event.time) for event in motion.events] == [("true", 0.3), ("false", 0.6)]
    assert motion["n"][-1] == 1.0
    assert motion["x"][-1] == pytest.approx(0.5 * 0.3**2 + 0.3 * 0.4, rel=1e-9)
    before, after = np.flatnonzero(motion.time == 0.3)
    assert (motion["n"][before], motion["n"][after]) == (0.0, 1.0)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_relation_reset_to_zero_fires_once(engine: EngineName) -> None:
    text = """
      coordinate Real h(start = 1);
      discrete Integer n(start = 0);
      kinetic 1/2*der(h)^2;
      potential 9.81*h;
    equation
      when h <= 0.3 then reinit(der(h), 0); n = pre(n) + 1; end when;
    """
    motion = model(text, engine).simulate(stop=0.7)
    fall = math.sqrt(1.4 / 9.81)
    assert motion["n"][-1] == 1.0
    assert motion["h"][-1] == pytest.approx(0.3 - 0.5 * 9.81 * (0.7 - fall) ** 2, rel=1e-9)


@pytest.mark.parametrize("engine", ENGINES)
def test_rows_and_ticks_are_the_same_numbers(engine: EngineName) -> None:
    """0.05 k and 1/20 k differ in the last bit; a row that is asked for at a tick is not written beside it."""
    text = """
      coordinate Real x;
      discrete Integer n(start = 0);
      kinetic 1/2*der(x)^2;
    equation
      when sample(0, 0.05) then n = pre(n) + 1; end when;
    """
    motion = model(text, engine).simulate(stop=1.0, interval=0.05)
    assert len(motion.time) == 1 + 2 * 20
    np.testing.assert_array_equal(motion.time[1::2], motion.time[2::2])
    np.testing.assert_array_equal(motion.time[1::2], np.arange(1, 21) / 20)


def test_a_constraint_that_asks_for_other_positions_is_refused() -> None:
    text = """
      coordinate Real x(der(start = 1)), y;
      discrete Real n(start = 0);
      kinetic 1/2*der(x)^2 + 1/2*der(y)^2;
      constraint c: y = n;
    equation
      when time >= 0.5 then n = x; end when;
    """
    with pytest.raises(SimulationFailed) as failure:
        model(text, "numpy").simulate(stop=1.0)
    assert failure.value.diagnostic.code == "E0835"
    assert failure.value.time == pytest.approx(0.5, abs=1e-12)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_contact_whose_pull_ends_with_a_relation_stays_closed(engine: EngineName) -> None:
    """A spring with play presses a mass against a stop and is then withdrawn: at the gap of the play the relation turns
    and the force that held the contact is zero for good. What does not pull stays closed."""
    text = """
      coordinate Real x;
      kinetic 1/2*der(x)^2;
      contact stop: x >= 0 with restitution = 0.3;
      force -100*(if x + sin(time + 0.7) > 0.5 then x + sin(time + 0.7) - 0.5 else 0) on x;
    """
    motion = model(text, engine).simulate(stop=3.0)
    (event,) = motion.events
    assert event.kind == "false"
    assert event.time == pytest.approx(math.pi - math.asin(0.5) - 0.7, abs=1e-9)
    np.testing.assert_array_equal(motion["x"], 0.0)
