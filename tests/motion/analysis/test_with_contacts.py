"""Small motions of models with contacts and discretes: closed contacts are constraints, discretes stand still."""

import math

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

# Two masses in a row on springs; the first is pressed against a stop by k (x + d).
PRESSED = """
model Pressed
  parameter Stiffness k = 50 N/m;
  parameter Length d = {preload};
  parameter Force hold = 3 N;
  coordinate Length x(start = {x}), y(start = 0.05 m);
  discrete Force u(start = 0);
  gravity = 0;
  mass 1 kg at {{x, y}};
  potential 1/2*k*(x + d)^2 + 1/2*k*(x - y)^2;
  contact stop: x >= 0 with restitution = 0;
  force u on y;
  output Force N = multiplier(stop);
equation
  when {{initial(), sample(0, 0.1 s)}} then
    u = hold;
  end when;
end Pressed;
"""


def pressed(preload: str = "0.2 m", x: str = "0") -> lagdsl.Model:
    return lagdsl.compile(PRESSED.format(preload=preload, x=x))


def test_a_closed_contact_is_a_constraint() -> None:
    found = pressed().modes().frequencies
    assert np.unique(found.round(12)) == pytest.approx([math.sqrt(50.0) / (2 * math.pi)])


def test_an_open_contact_is_not_there() -> None:
    """k [[2, -1], [-1, 1]]: the golden ratio and its inverse."""
    found = pressed(x="0.3 m").modes().frequencies
    golden = (1.0 + math.sqrt(5.0)) / 2.0
    expected = np.array([golden - 1.0, golden]) * math.sqrt(50.0) / (2 * math.pi)
    assert np.unique(found.round(12)) == pytest.approx(expected)


@pytest.mark.parametrize("ask", ["linearize", "modes"])
def test_inside_of_a_contact_there_is_no_small_motion(ask: str) -> None:
    with pytest.raises(CompilationFailed) as raised:
        getattr(pressed(), ask)(q={"x": -0.01})
    assert [found.code for found in raised.value.diagnostics] == ["E0834"]
    assert "`stop`" in str(raised.value)


def test_the_equilibrium_presses_on_the_stop() -> None:
    """From an open contact: without the stop x would come to rest beyond it."""
    model = pressed(x="0.1 m")
    found = model.trim()
    assert found.point.q == pytest.approx([0.0, 3.0 / 50.0], abs=1e-9)


def test_the_equilibrium_leaves_the_stop_that_would_pull() -> None:
    """u pulls y, which pulls x: k (2 x - y + d) = 0 and k (y - x) = u."""
    model = pressed(preload="0.01 m", x="0")
    found = model.trim()
    x = 3.0 / 50.0 - 0.01
    assert found.point.q == pytest.approx([x, x + 3.0 / 50.0], abs=1e-9)


def test_what_falls_has_no_equilibrium_and_the_open_contact_is_named() -> None:
    text = """
    model Ball
      coordinate Length h(start = 1 m);
      gravity = -g_n*world.y;
      mass 1 kg at {0, h};
      contact floor: h >= 0 with restitution = 0;
    end Ball;
    """
    with pytest.raises(CompilationFailed, match="open contacts: `floor`"):
        lagdsl.compile(text).trim()


def test_linearization_holds_a_sampled_force() -> None:
    text = """
    model Held
      coordinate Length x(start = 0.1 m);
      discrete Force u(start = 0);
      kinetic 1/2*(2 kg)*der(x)^2;
      force u on x;
      force if x > 0 then -(8 N/m)*x else 0 on x;
    equation
      when sample(0, 0.1 s) then
        u = -(5 N/m)*x;
      end when;
    end Held;
    """
    a = lagdsl.compile(text).linearize().A
    np.testing.assert_allclose(a, [[0.0, 1.0], [-4.0, 0.0]], atol=1e-12)


def test_where_an_event_of_the_start_fails_no_small_motion_begins() -> None:
    text = """
    model Short
      coordinate Length x;
      kinetic 1/2*(1 kg)*der(x)^2;
      potential 1/2*(4 N/m)*x^2;
    equation
      when initial() then
        assert(x > 1 m, "too short");
      end when;
    end Short;
    """
    model = lagdsl.compile(text)
    with pytest.raises(CompilationFailed, match=r"\[E0810\].* too short"):
        model.modes()
    assert model.modes(q={"x": 2.0}).point.q == [2.0]
    assert model.modes(q={"x": 2.0}, trim=True).point.q == pytest.approx([0.0], abs=1e-12)


@pytest.mark.parametrize("name", ["linearize", "modes"])
def test_it_begins_behind_the_events_of_the_start(name: str) -> None:
    """A mass that is set to 2 kg keeps its momentum: v = 1/2 m/s, and -v^3/m has the slope -3/8. A reset acts, too."""
    start = "coordinate Length x(der(start = 1 m/s)); force -(1 N.s3/m3)*der(x)^3 on x; "
    mass = "discrete Mass m(start = 1 kg); kinetic 1/2*m*der(x)^2; when initial() then m = 2 kg; end when;"
    rate = "kinetic 1/2*(1 kg)*der(x)^2; when initial() then reinit(der(x), 3 m/s); end when;"
    doubled, reset = (lagdsl.compile(f"model Begun\n{start}{text}\nend Begun;\n") for text in (mass, rate))
    assert getattr(doubled, name)().point.qd == pytest.approx([0.5])
    np.testing.assert_allclose(doubled.linearize().A, [[0, 1], [0, -0.375]], atol=1e-15)
    np.testing.assert_allclose(doubled.linearize(qd={"x": 2.0}).A, [[0, 1], [0, -1.5]], atol=1e-15)
    np.testing.assert_allclose(reset.linearize().A, [[0, 1], [0, -27]], atol=1e-14)
