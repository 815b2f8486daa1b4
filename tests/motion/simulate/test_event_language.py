"""The constructs of events, each with a small model whose outcome is known."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

G = 9.80665
RUNNER = """
{types}
model Runner
  coordinate Length x(der(start = 1 m/s)) "runs like time";
  kinetic 1/2*(1 kg)*der(x)^2;
  {items}
equation
  {equations}
end Runner;
"""


def runner(items: str = "", equations: str = "", types: str = "") -> lagdsl.Model:
    return lagdsl.compile(RUNNER.format(items=items, equations=equations, types=types))


def final(model: lagdsl.Model, name: str, stop: float = 2.0) -> float:
    return float(model.simulate(stop=stop, interval=stop / 10)[name][-1])


def codes(items: str = "", equations: str = "", types: str = "") -> list[str]:
    with pytest.raises(CompilationFailed) as failure:
        runner(items, equations, types)
    return [each.code for each in failure.value.diagnostics if each.code.startswith("E")]


# ---- relations -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("words", "located"), [("{}", 1), ("noEvent({})", 0), ("smooth(0, {})", 0)])
def test_relations_are_located_unless_they_are_said_not_to_be(words: str, located: int) -> None:
    force = words.format("if x > 0.5 m then -(x - 0.5 m)*(4 N/m) else 0")
    motion = runner(f"force {force} on x;").simulate(stop=1.0)
    assert len(motion.events) == located
    assert motion["x"][-1] == pytest.approx(0.5 + math.sin(2 * 0.5) / 2, abs=1e-7)


def test_a_truth_by_another_name_and_its_edges() -> None:
    items = (
        "Boolean far = x > 0.5 m and not x > 1.5 m; discrete Integer up(start = 0), both(start = 0), was(start = 7);"
    )
    model = runner(
        items,
        "when edge(far) then up = pre(up) + 1; was = if pre(far) then 1 else 0; end when;"
        "when change(far) then both = pre(both) + 1; end when;",
    )
    motion = model.simulate(stop=2.0)
    assert (motion["up"][-1], motion["both"][-1], motion["was"][-1]) == (1.0, 2.0, 0.0)


def test_each_condition_in_braces_acts_by_itself() -> None:
    written = "when {x > 0.5 m, x > 1 m} then n = pre(n) + 1; end when;"
    counted = "when {x > 0.5*i*(1 m) for i in 1:2} then n = pre(n) + 1; end when;"
    named = "when up then n = pre(n) + 1; end when;"
    items = "discrete Integer n(start = 0); Boolean up[2] = {x > 0.5 m, x > 1 m};"
    assert [final(runner(items, text), "n") for text in (written, counted, named)] == [2.0, 2.0, 2.0]


def test_if_around_equations() -> None:
    model = runner(
        "state Real z(start = 0); Force f; force f on x;",
        """if x > 0.5 m then
             der(z) = 2 /s; f = 0;
           elseif x > 0.25 m then
             if noEvent(der(x) > 0) then f = 0; else f = 1 N; end if;
             der(z) = 1 /s;
           else
             f = 0; der(z) = 0;
           end if;""",
    )
    assert final(model, "z", 1.0) == pytest.approx(0.25 + 1.0, abs=1e-9)


def test_every_branch_says_what_all_of_them_say() -> None:
    assert codes("Force f; force f on x;", "if x > 0.5 m then f = 1 N; end if;") == ["E0386"]


# ---- variables -------------------------------------------------------------------------------------------------------


def test_discrete_values_of_an_enumeration() -> None:
    model = runner(
        "discrete Mode mode; discrete Mode other(start = Mode.pull); force if mode == Mode.push then 1 N else 0 on x;",
        "when x > 0.5 m then mode = Mode.push; other = pre(mode); end when;",
        "type Mode = enumeration(idle, push, pull);",
    )
    motion = model.simulate(stop=1.0)
    assert (motion["mode"][0], motion["mode"][-1]) == (1.0, 2.0)  # without a start the first
    assert (motion["other"][0], motion["other"][-1]) == (3.0, 1.0)
    assert motion["x"][-1] == pytest.approx(1.0 + 0.5**2 / 2, abs=1e-9)


def test_inputs_that_are_truths_and_whole_numbers() -> None:
    model = runner(
        "input Boolean on = false; input Integer gear = 2; discrete Integer n(start = 0);"
        "force if on then 1 N else 0 on x; output Boolean third = gear == 3;",
        "when on then n = pre(n) + 1; end when;",
    )
    given = {"on": ([0, 0.5, 0.5, 1, 1, 2], [0, 0, 1, 1, 0, 0]), "gear": ([0, 1.5, 1.5, 2], [2, 2, 3, 3])}
    motion = model.simulate(stop=2.0, interval=0.25, inputs=given)
    assert motion["n"][-1] == 1.0
    assert motion["der(x)"][-1] == pytest.approx(1.5, abs=1e-9)
    assert motion["third"][[0, -1]].tolist() == [0.0, 1.0]


def test_signals_through_connectors() -> None:
    text = """
    connector Signal
      Boolean on;
      Integer n;
    end Signal;
    model Source
      Signal s;
      input Length x;
    equation
      s.on = x > 0.5 m;
      s.n = if x > 0.25 m then 4 else 3;
    end Source;
    model Sink
      Signal s;
      discrete Integer hit(start = 0);
    equation
      when s.on then
        hit = s.n;
      end when;
    end Sink;
    model Line
      coordinate Length x(der(start = 1 m/s));
      kinetic 1/2*(1 kg)*der(x)^2;
      Source a(x = x);
      Sink b, c;
      connect(a.s, b.s);
      connect(b.s, c.s);
    end Line;
    """
    motion = lagdsl.compile(text).simulate(stop=1.0)
    assert (motion["b.hit"][-1], motion["c.hit"][-1]) == (4.0, 4.0)
    second = text.replace("Sink b, c;", "Sink b; Source c(x = x);")
    with pytest.raises(CompilationFailed, match=r"E0319.*`a.s.on` is defined twice"):
        lagdsl.compile(second)


# ---- clauses ---------------------------------------------------------------------------------------------------------


def test_reinit_by_the_name_of_a_rate() -> None:
    text = """
    model Ball
      coordinate Length h(start = 1 m);
      Velocity v = der(h);
      gravity = -g_n*world.y;
      mass 1 kg at {0, h};
    equation
      when h <= 0 then
        reinit(v, -0.5*pre(v));
      end when;
    end Ball;
    """
    motion = lagdsl.compile(text).simulate(stop=0.6)
    first = math.sqrt(2 / G)
    times = [event.time for event in motion.events if event.kind == "reinit"]
    assert times == pytest.approx([first], abs=1e-9)
    assert motion["der(h)"][-1] == pytest.approx(0.5 * G * first - G * (0.6 - first), abs=1e-9)


@pytest.mark.parametrize(
    ("equations", "expected"),
    [
        ("when x > 1 m then if x > 2 m then n = 1; end if; if x > 3 m then n = 2; end if; end when;", ["E0307"]),
        ("when x > 1 m then n = 1; end when; when x > 2 m then n = 2; end when;", ["E0307"]),
        ("when x > 1 m then when x > 2 m then n = 1; end when; end when;", ["E0378"]),
        ("when x > 1 m then m = 1; n = 2; end when;", ["E0201"]),
        ("when x > 1 m then k = 1; n = 2; end when;", ["E0373"]),
        ("when x > 1 m then reinit(x, 0); n = 2; end when;", ["E0374"]),
        ("when x > 1 m then reinit(k, 0); n = 2; end when;", ["E0374"]),
        ("when sample(0, T) then n = 2; end when;", ["E0334"]),
    ],
)
def test_mistakes_in_clauses(equations: str, expected: list[str]) -> None:
    items = "discrete Integer n(start = 0); Real k; parameter Time T = 0;"
    found = codes(items if "k = 1" in equations else items.replace("Real k", "Real k = 1"), equations)
    assert found == expected


def test_assignments_that_exclude_each_other() -> None:
    text = "when x > 1 m then if x > 2 m then n = 1; elseif T > 1 then n = 2; else n = 3; end if; end when;"
    model = runner("discrete Integer n(start = 0); parameter Real T = 0;", text)
    assert final(model, "n") == 3.0


# ---- what is switched ------------------------------------------------------------------------------------------------


def test_a_constraint_that_an_event_switches_on() -> None:
    """It grips at x = 0.5 m: the rate is gone by an impulse, and the multiplier balances the force."""
    model = runner(
        "discrete Boolean held(start = false); constraint c: (if held then der(x) else 0) = 0; force 2 N on x;"
        "output Force N = multiplier(c);",
        "when x >= 0.5 m then held = true; end when;",
    )
    motion = model.simulate(stop=2.0)
    assert motion["x"][-1] == pytest.approx(0.5, abs=1e-9)
    assert motion["N"][-1] == pytest.approx(-2.0)
    assert motion["N"][0] == 0.0


def test_static_friction_lets_go_where_its_multiplier_is_too_large() -> None:
    text = """
    model Block
      coordinate Length x;
      discrete Boolean stuck(start = true);
      kinetic 1/2*(1 kg)*der(x)^2;
      constraint grip: (if stuck then der(x) else 0) = 0;
      force (1 N/s)*time on x;
      force if stuck then 0 else -1.5 N on x;
    equation
      when abs(multiplier(grip)) > 2 N then
        stuck = false;
      end when;
    end Block;
    """
    motion = lagdsl.compile(text).simulate(stop=3.0)
    assert motion.events[0].time == pytest.approx(2.0, abs=1e-9)
    assert motion["x"][-1] == pytest.approx(0.5 / 2 + 1 / 6, abs=1e-8)


# ---- contacts --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("contact", "expected"),
    [
        ("contact c: x >= 0 with restitution = 80;", "E0334"),
        ("contact c: x >= 0 with restitution = e;", "E0334"),
        ("contact c: x >= 0 with restitution = 0, v_stick = -1 m/s;", "E0334"),
        ("contact c: x >= 0 with compliance = -1 N/m;", "E0334"),
        ("contact c: d >= 0 with restitution = 0;", "E0382"),
        ("contact c: d - (1 m/s)*time >= 0 with restitution = 0;", "E0382"),
        ("contact c: der(x) >= 0 with restitution = 0;", "E0389"),
        ("contact c: x >= 0;", "E0383"),
    ],
)
def test_mistakes_in_contacts(contact: str, expected: str) -> None:
    parameters = "parameter Real e = -0.3; parameter Length d = 1 m; output Real unused = e + d/(1 m);"
    assert codes(f"{parameters} {contact}") == [expected]


def test_limits_hold_for_every_set_of_parameters() -> None:
    model = runner("parameter Real e = 0.5; contact c: x >= -1 m with restitution = e;")
    assert model.simulate(stop=0.1, parameters={"e": 0.0})
    with pytest.raises(CompilationFailed, match=r"E0334.*the restitution must be 0 to 1, found 1.5"):
        model.simulate(stop=0.1, parameters={"e": 1.5})


def test_a_power_of_the_penetration_begins_and_ends_at_zero() -> None:
    """Hertz: m v^2/2 = 2/5 k d^(5/2) at the deepest point; the flight back is as fast."""
    text = """
    model Ball
      coordinate Length h(start = 0, der(start = -1 m/s));
      kinetic 1/2*(1 kg)*der(h)^2;
      contact floor: h >= 0 with compliance = k/sqrt(1 m), exponent = 3/2;
      parameter Stiffness k = 1e5;
      output Force N = multiplier(floor);
    end Ball;
    """
    motion = lagdsl.compile(text).simulate(stop=0.1, interval=1e-5, tolerance=1e-10)
    assert np.min(motion["h"]) == pytest.approx(-((1.25 / 1e5) ** 0.4), rel=1e-5)
    assert motion["der(h)"][-1] == pytest.approx(1.0, abs=1e-7)
    assert np.min(motion["N"]) >= 0.0


@pytest.mark.parametrize("inside", ["contact c: h >= 0 with restitution = 0;", "discrete Integer n(start = 0);"])
def test_a_component_under_a_parameter_holds_no_events(inside: str) -> None:
    clause = "equation when h <= 0.5 m then n = pre(n) + 1; end when;" if "n(" in inside else ""
    types = f"model Part input Length h; {inside} {clause} end Part;"
    assert codes("parameter Boolean there = true; Part part(h = x) if there;", types=types) == ["E0330"]
