"""Derivatives of motions by parameters, start values and inputs: closed forms at every tolerance, differences of whole
runs, and what has none."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import exp, pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from tests.choice import chosen

MODELS = Path(__file__).parents[3] / "models"

OSCILLATOR = """
model Oscillator
  parameter Mass m = 2 kg;
  parameter Stiffness k = 8 N/m;
  input Force u = 0.5 N;
  coordinate Length x(start = 0.3 m, der(start = 0.1 m/s));
  mass m at {x, 0};
  potential k*x^2/2;
  force u on x;
  output Force pull = k*x;
end Oscillator;
"""

TWO_BALLS = """
model TwoBalls
  parameter Mass m = 1 kg;
  coordinate Length a(start = 0, der(start = 1 m/s)), b(start = 1 m, der(start = 0));
  mass m at {a, 0};
  mass m at {b, 0};
  contact hit: b - a >= 0.2 m with restitution = 1;
  annotation(experiment(StopTime = 2));
end TwoBalls;
"""

BALL = """
model Ball
  parameter Mass m = 1 kg;
  parameter Real e = 0.8;
  parameter Acceleration g = 9.81 m/s2;
  coordinate Length h(start = 1 m);
  mass m at {0, h};
  gravity = {0, -g};
  contact floor: h >= 0 with restitution = e;
  annotation(experiment(StopTime = 5));
end Ball;
"""


def _height(h0: float, e: float, g: float, t: float) -> float:
    """Of the ball at time t, bounce by bounce."""
    since, speed = t - sqrt(2.0 * h0 / g), e * sqrt(2.0 * g * h0)
    if since < 0.0:
        return h0 - 0.5 * g * t * t
    while speed > 1e-300:
        if since < 2.0 * speed / g:
            return speed * since - 0.5 * g * since * since
        since -= 2.0 * speed / g
        speed *= e
    return 0.0


def _complex_height(h0: complex, e: complex, g: complex, t: float) -> complex:
    """The same, along imaginary parts that are too small to change the order of bounces."""
    since, speed = t - np.sqrt(2.0 * h0 / g), e * np.sqrt(2.0 * g * h0)
    if since.real < 0.0:
        return h0 - 0.5 * g * t * t
    while abs(speed) > 1e-200:
        if since.real < (2.0 * speed / g).real:
            return complex(speed * since - 0.5 * g * since * since)
        since = since - 2.0 * speed / g
        speed = speed * e
    return 0.0 * h0


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_an_oscillator_is_differentiated_as_its_closed_form(tolerance: float, solver: str) -> None:
    """x = u/k + (x0 - u/k) cos wt + v0/w sin wt, w^2 = k/m, to a few times the tolerance."""
    names = ["m", "k", "u", "x.start", "der(x).start"]
    motion = lagdsl.compile(OSCILLATOR).simulate(
        stop=7.0, interval=0.1, tolerance=tolerance, solver=solver, tangents=names
    )

    def closed(m: complex, k: complex, u: complex, x0: complex, v0: complex) -> NDArray[np.complex128]:
        w = np.sqrt(k / m)
        return np.asarray(u / k + (x0 - u / k) * np.cos(w * motion.time) + v0 / w * np.sin(w * motion.time))

    values: tuple[complex, ...] = (2.0, 8.0, 0.5, 0.3, 0.1)
    for number, name in enumerate(names):
        moved = list(values)
        moved[number] += 1e-30j
        exact = closed(*moved).imag / 1e-30
        size = max(1.0, float(np.abs(exact).max()))
        found = motion.derivative("x", name)
        assert np.abs(found - exact).max() <= (30.0 * tolerance + 1e-12) * size
        own = motion["x"] if name == "k" else 0.0
        assert motion.derivative("pull", name) == pytest.approx(8.0 * found + own, abs=1e-12 * size)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-10])
def test_two_equal_balls_exchange_their_derivatives(tolerance: float) -> None:
    """Behind one elastic impact d(a, b)/d(a0, b0) = (0, 1; 1, 0), shifted by the contact: nimblephysics #97."""
    starts = ["a.start", "b.start", "der(a).start", "der(b).start"]
    motion = lagdsl.compile(TWO_BALLS).simulate(tolerance=tolerance, tangents=starts)
    found = [[motion.derivative(of, by)[-1] for by in starts] for of in ("a", "b", "der(a)", "der(b)")]
    exact = [[0, 1, 0, 2], [1, 0, 2, 0], [0, 0, 0, 1], [0, 0, 1, 0]]
    assert np.abs(np.array(found) - exact).max() <= 1e-13


@pytest.mark.parametrize("tolerance", [1e-3, 1e-8])
def test_a_ball_is_differentiated_through_its_bounces_and_their_limit(tolerance: float) -> None:
    motion = lagdsl.compile(BALL).simulate(tolerance=tolerance, interval=0.37, tangents=["h.start", "e", "g"])
    events = np.array([event.time for event in motion.events])
    rows = [row for row, t in enumerate(motion.time) if np.abs(events - t).min() > 1e-6]
    assert len(rows) > 10
    for row in rows:
        t = float(motion.time[row])
        assert motion["h"][row] == pytest.approx(_height(1.0, 0.8, 9.81, t), abs=1e-11)
        for number, name in enumerate(("h.start", "e", "g")):
            values: list[complex] = [1.0, 0.8, 9.81]
            values[number] += 1e-30j
            exact = _complex_height(*values, t).imag / 1e-30
            bounces = int(np.sum(events < t))
            bound = 1e-11 * 0.8 ** -max(bounces - 9, 0)  # an error of the speed outlives a bounce, the height does not
            assert motion.derivative("h", name)[row] == pytest.approx(exact, abs=bound * (1.0 + abs(exact)))


@pytest.mark.parametrize("tolerance", [1e-3, 1e-10])
def test_times_of_bounces_and_of_their_end_have_derivatives(tolerance: float) -> None:
    """t1 = sqrt(2 h/g); the bounces end at t1 (1 + e)/(1 - e)."""
    motion = lagdsl.compile(BALL).simulate(tolerance=tolerance, tangents=["h.start", "e", "g"])
    first, last = motion.events[0], motion.events[-1]
    t1 = sqrt(2.0 / 9.81)
    assert (first.kind, last.kind) == ("impact", "closed")
    assert first.time_derivative("h.start") == pytest.approx(t1 / 2.0, abs=1e-14)
    assert first.time_derivative("g") == pytest.approx(-t1 / (2.0 * 9.81), abs=1e-14)
    assert first.time_derivative("e") == pytest.approx(0.0, abs=1e-14)
    assert last.time_derivative("h.start") == pytest.approx(t1 / 2.0 * 9.0, abs=1e-10)
    assert last.time_derivative("e") == pytest.approx(2.0 * t1 / 0.04, abs=1e-10)


def test_a_relation_of_time_and_a_clock_carry_their_parameters() -> None:
    """Speed 1 m/s up to T, then 3 m/s; a counter that adds x at ticks of period h."""
    model = lagdsl.compile(
        """
model Switched
  parameter Time T = 0.7 s, h = 0.3 s;
  state Length x(start = 0);
  discrete Length sum(start = 0);
  output Length total = sum;
equation
  der(x) = (if time > T then 3 else 1)*(1 m/s);
  when sample(h, h) then
    sum = pre(sum) + x;
  end when;
end Switched;
"""
    )
    motion = model.simulate(stop=1.0, tangents=["T", "h", "x.start"])
    assert motion["x"][-1] == pytest.approx(0.7 + 0.9)
    assert motion.derivative("x", "T")[-1] == pytest.approx(-2.0, abs=1e-12)
    # ticks at h, 2 h and 3 h: x(h) = h, x(2 h) = 2 h, x(3 h) = T + 3 (3 h - T)
    assert motion.derivative("sum", "h")[-1] == pytest.approx(1.0 + 2.0 + 9.0, abs=1e-12)
    assert motion.derivative("sum", "T")[-1] == pytest.approx(-2.0, abs=1e-12)
    assert motion.derivative("sum", "x.start")[-1] == pytest.approx(3.0, abs=1e-12)
    switch = next(event for event in motion.events if event.kind == "true")
    assert switch.time_derivative("T") == pytest.approx(1.0, abs=1e-12)


def test_a_level_is_crossed_later_from_a_longer_pendulum() -> None:
    """cos(w t) = 1/2 of a small pendulum: t = pi/(3 w), w = sqrt(g/l)."""
    model = lagdsl.compile(
        """
model Level
  parameter Length l = 2 m, far = 0.2 m;
  parameter Acceleration g = 9.81 m/s2;
  coordinate Length x(start = far);
  discrete Integer count(start = 0);
  mass 1 kg at {x, 0};
  potential (1 kg)*g/l*x^2/2;
equation
  when x < far/2 then
    count = pre(count) + 1;
  end when;
end Level;
"""
    )
    motion = model.simulate(stop=1.0, tolerance=1e-10, tangents=["l", "far", "g"])
    (crossing,) = [event for event in motion.events if event.kind == "true"]
    w = sqrt(9.81 / 2.0)
    assert crossing.time == pytest.approx(pi / (3.0 * w), abs=1e-9)
    assert crossing.time_derivative("l") == pytest.approx(pi / (3.0 * w) / 4.0, abs=1e-9)
    assert crossing.time_derivative("far") == pytest.approx(0.0, abs=1e-9)


def test_sliding_ends_at_a_time_with_a_derivative() -> None:
    """A block with speed v0 on a rough table stops at v0/(mu g), v0^2/(2 mu g) from where it began."""
    model = lagdsl.compile(
        """
model Block
  parameter Real mu = 0.4;
  coordinate Length s(der(start = 2 m/s)), z;
  mass 3 kg at {s, z};
  gravity = {0, -10 m/s2};
  contact table: z >= 0 with restitution = 0, friction = mu, slip = der(s);
end Block;
"""
    )
    motion = model.simulate(stop=1.0, tangents=["mu", "der(s).start"])
    stop = next(event for event in motion.events if event.kind == "sticks")
    assert stop.time == pytest.approx(0.5, abs=1e-9)
    assert stop.time_derivative("der(s).start") == pytest.approx(0.25, abs=1e-10)
    assert stop.time_derivative("mu") == pytest.approx(-2.0 / (0.16 * 10.0), abs=1e-10)
    assert motion.derivative("s", "mu")[-1] == pytest.approx(-4.0 / (2.0 * 0.16 * 10.0), abs=1e-10)
    assert motion.derivative("s", "der(s).start")[-1] == pytest.approx(0.5, abs=1e-10)


def _differences(model: lagdsl.Model, of: str, by: str, options: Mapping[str, float]) -> NDArray[np.float64]:
    """(rows,): Richardson's differences of whole runs."""
    start = by.endswith(".start")
    name = by.removesuffix(".start")
    state = model.initial_state()
    names = [*model.coordinates, *(f"der({each})" for each in model.coordinates), *model.states]
    here = state.x[names.index(name)] if start else state.p[model.parameters.index(name)]
    step = 1e-4 * (abs(here) or 1.0)

    def moved(by_steps: int) -> NDArray[np.float64]:
        given = {name: float(here + by_steps * step)}
        chosen_ones: Mapping[str, Mapping[str, float]] = {"start" if start else "parameters": given}
        return _at_grid(model.simulate(**options, **chosen_ones), of, options)  # type: ignore[arg-type]

    near, far = moved(1) - moved(-1), moved(2) - moved(-2)
    return (8.0 * near - far) / (12.0 * step)


def _at_grid(motion: lagdsl.Trajectory, of: str, options: Mapping[str, float], by: str = "") -> NDArray[np.float64]:
    """Values, or derivatives, at the rows of the grid, behind events."""
    count = round((motion.time[-1] - motion.time[0]) / options["interval"])
    grid = motion.time[0] + options["interval"] * np.arange(count + 1)
    rows = [np.flatnonzero(np.abs(motion.time - t) < 1e-9)[-1] for t in grid]
    return np.asarray((motion.derivative(of, by) if by else motion[of])[rows])


# Model, column, quantities, stop time: a loop, sampled control, rolling, friction, impacts.
_CASES = {
    "four_bar": ("B.q", ("crank.l", "coupler.m", "A.q.start"), 0.5),
    "furuta_swing_up": ("theta", ("L", "m"), 0.3),
    "rolling_coin": ("x", ("R", "lean.start"), 0.4),
    "clutch": ("a", ("J1", "drive"), 2.0),
    "stick_slip_belt": ("x", ("m", "k"), 3.0),
    "pick_and_place": ("grip[2]", ("l1", "p1"), 1.2),
    "rimless_wheel": ("x", ("l", "x.start"), 3.0),
    "billiard_ball_swerves": ("x", ("mu", "R"), 0.6),
    "stewart_platform": ("pose.r[3]", ("R_top",), 0.3),
    "viscoelastic_mount": ("x", ("m",), 0.5),
}


@pytest.mark.parametrize(
    "name", chosen(list(_CASES), ["four_bar", "clutch", "pick_and_place", "billiard_ball_swerves"])
)
def test_derivatives_are_those_of_differences(name: str) -> None:
    of, quantities, stop = _CASES[name]
    model = lagdsl.compile(MODELS / f"{name}.lag")
    options = {"stop": stop, "interval": stop / 5.0, "tolerance": 1e-11}
    motion = model.simulate(**options, tangents=quantities)  # type: ignore[arg-type]
    for by in quantities:
        differences = _differences(model, of, by, options)
        found = _at_grid(motion, of, options, by)
        assert np.abs(found - differences).max() <= 1e-7 * max(float(np.abs(differences).max()), 1e-3)


_GRAZING = """
model Grazing
  coordinate Length x(der(start = 1 m/s));
  mass 1 kg at {x, 0};
  force -2 N on x;
  contact wall: 0.25 m - 1e-10 m - x >= 0 with restitution = 1;
end Grazing;
"""

_RESTING = """
model Resting
  coordinate Length h(start = 0);
  mass 1 kg at {0, h};
  gravity = {0, -9.81 m/s2};
  contact floor: h >= 0 with restitution = 0;
end Resting;
"""


@pytest.mark.parametrize(
    ("text", "tangents", "code"),
    [(_GRAZING, ["der(x).start"], "E0881"), (_RESTING, ["h.start"], "E0882")],
)
def test_a_motion_without_derivatives_says_where_it_ends(text: str, tangents: list[str], code: str) -> None:
    with pytest.raises(lagdsl.SimulationFailed, match=code):
        lagdsl.compile(text).simulate(stop=1.0, tangents=tangents)


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda model: model.simulate(tangents=["lenght"]), "E0874"),
        (lambda model: model.simulate(tangents=["x"]), "E0874"),
        (lambda model: model.simulate(tangents=["m"]).derivative("y", "m"), "E0874"),
        (lambda model: model.simulate(tangents=["m"]).derivative("x", "k"), "E0874"),
        (lambda model: model.simulate().derivative("x", "m"), "E0884"),
    ],
)
def test_what_has_no_derivatives_is_refused(call: Callable[[lagdsl.Model], object], error: str) -> None:
    with pytest.raises((lagdsl.CompilationFailed, lagdsl.CallRefused), match=error):
        call(lagdsl.compile(OSCILLATOR))


def test_quantities_may_be_one_text() -> None:
    motion = lagdsl.compile(OSCILLATOR).simulate(stop=1.0, tangents="m, x.start")
    assert motion.sensitivities is not None
    assert motion.sensitivities.names == ("m", "x.start")


def test_a_structural_parameter_is_refused() -> None:
    model = lagdsl.compile(
        """
model Chain
  structural parameter Integer n = 2;
  coordinate Length x[n](start = {1 m, 2 m});
  mass 1 kg at {x[1], x[2]};
end Chain;
"""
    )
    with pytest.raises(lagdsl.CallRefused, match="E0880"):
        model.simulate(tangents=["n"])


def test_two_impacts_at_one_instant_have_derivatives_on_one_side() -> None:
    model = lagdsl.compile(
        """
model Three
  coordinate Length a(start = -1 m, der(start = 1 m/s)), b, c(start = 1 m, der(start = -1 m/s));
  mass 1 kg at {a, 0};
  mass 1 kg at {b, 0};
  mass 1 kg at {c, 0};
  contact left: b - a >= 0.2 m with restitution = 1;
  contact right: c - b >= 0.2 m with restitution = 1;
end Three;
"""
    )
    sink = Sink()
    model.simulate(stop=1.5, tangents=["a.start"], sink=sink)
    assert [d.code for d in sink.diagnostics] == ["W0883"]


def test_the_row_behind_the_last_instant_has_its_derivatives() -> None:
    """x = t doubles at x = L, where the motion ends: behind it x = 2 L + (t - L)."""
    model = lagdsl.compile(
        """
model Ends
  parameter Real L = 0.7;
  state Real x(start = 0);
equation
  der(x) = 1/(1 s);
  when x > L then
    reinit(x, 2*x);
    terminate("there");
  end when;
end Ends;
"""
    )
    motion = model.simulate(stop=2.0, tangents=["L"])
    assert motion["x"][-2:] == pytest.approx([0.7, 1.4])
    assert motion.derivative("x", "L")[-2:] == pytest.approx([0.0, 1.0], abs=1e-12)


def test_clocks_that_tick_together_by_other_parameters_are_told() -> None:
    model = lagdsl.compile(
        """
model Clocks
  parameter Time a = 0.5 s, b = 0.5 s;
  state Real x(start = 0);
  discrete Real first(start = 0), second(start = 0);
equation
  der(x) = 1/(1 s);
  when sample(a, a) then
    first = x;
  end when;
  when sample(b, b) then
    second = x;
  end when;
end Clocks;
"""
    )
    sink = Sink()
    model.simulate(stop=0.8, tangents=["a"], sink=sink)
    (told,) = sink.diagnostics
    assert told.code == "W0883" and "t = 0.5 s" in told.message


def test_a_motion_is_the_same_to_the_bit_with_a_column_that_costs_no_step() -> None:
    """The column of a start value along a free fall is exact: it asks for no shorter step."""
    model = lagdsl.compile(BALL)
    plain, with_column = (model.simulate(stop=2.0, tangents=names) for names in ([], ["h.start"]))
    assert np.array_equal(plain["h"], with_column["h"])


def test_decaying_motions_keep_small_derivatives() -> None:
    """x = exp(-c t) of a state; d/dc = -t exp(-c t) to the relative tolerance, however small it becomes."""
    model = lagdsl.compile(
        """
model Decay
  parameter Real c(unit = "1/s") = 3;
  state Real x(start = 1);
equation
  der(x) = -c*x;
end Decay;
"""
    )
    motion = model.simulate(stop=2.0, interval=0.5, tolerance=1e-9, tangents=["c", "x.start"])
    for t, by_c, by_start in zip(
        motion.time, motion.derivative("x", "c"), motion.derivative("x", "x.start"), strict=True
    ):
        assert by_c == pytest.approx(-t * exp(-3.0 * t), abs=1e-9)
        assert by_start == pytest.approx(exp(-3.0 * t), abs=1e-9)
