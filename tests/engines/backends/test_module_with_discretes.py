"""The NumPy module of a model with events: its functions say all that a simulation of its own needs."""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
import pytest
from compiled_programs import program_of
from scipy.integrate import solve_ivp

import lagdsl
from lagdsl.engines.backends.registry import BACKENDS

G = 9.80665
BALL = """
model Ball
  parameter Real e = 0.8;
  coordinate Length h(start = 1 m);
  discrete Integer n(start = 0);
  discrete Boolean far(start = false);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
equation
  when h <= 0 then
    reinit(der(h), -e*der(h));
    n = pre(n) + 1;
  end when;
  when n > 4 then
    terminate("bounced five times");
  end when;
  when sample(0.25 s, 0.5 s) then
    far = h > 0.5 m;
  end when;
end Ball;
"""
ON_THE_FLOOR = """
model OnTheFloor
  parameter Mass m = 2 kg;
  coordinate Length x, h;
  input Force f = 0;
  gravity = -g_n*world.y;
  mass m at {x, h};
  force {0, f} at {x, h};
  contact floor: h >= 0 with restitution = 0.5, v_stick = 0.1 m/s;
  output Force N = multiplier(floor);
end OnTheFloor;
"""


def _module(text: str) -> ModuleType:
    (written,) = BACKENDS["numpy"].emit(program_of(text)).files.values()
    module = ModuleType("generated")
    exec(compile(written, "generated", "exec", dont_inherit=True), module.__dict__)
    return module


def _solved(module: ModuleType, t: float, y: np.ndarray, w: np.ndarray) -> tuple[object, ...]:
    n = len(module.COORDINATES)
    q, qd, none = y[:n], y[n:], np.zeros(0)
    solution = module.forward_dynamics(t, q, qd, w=w), module.multipliers(t, q, qd, w=w)
    return (t, q, qd, none, none, w, np.array(module.DEFAULTS), *solution)


def _settle(module: ModuleType, t: float, y: np.ndarray, w: np.ndarray) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Passes until nothing changes, as docs/explanation/hybrid_model.md describes them."""
    pulses = [k for k, kind in enumerate(module.KINDS) if kind in ("clock", "instant")]
    for _ in range(20):
        after, reset, value, _, _, stop, _ = module.evaluate("event", *_solved(module, t, y, w))
        after = after.copy()
        after[pulses] = 0.0
        if np.array_equal(after, w) and not reset.any():
            return y, w, [module.STOPS[k] for k in np.flatnonzero(stop)]
        y, w = y.copy(), after
        for k in np.flatnonzero(reset):
            y[module.RESET_PLACES[k]] = value[k]
        if stop.any():
            return y, w, [module.STOPS[k] for k in np.flatnonzero(stop)]
    raise AssertionError("no fixed point")


def test_the_module_is_enough_to_simulate_with() -> None:
    module = _module(BALL)
    assert module.KINDS[:2] == ("variable", "variable")
    assert module.RESETS == ("der(h)",)
    relations = [k for k, kind in enumerate(module.KINDS) if kind == "relation"]
    assert len(module.STRICT) == len(relations) == 1
    p = np.array(module.DEFAULTS)
    (first,), (period,) = module.evaluate("clock", 0.0, p)
    assert (first, period) == (0.25, 0.5)
    t, y, (w,) = 0.0, np.array([1.0, 0.0]), module.evaluate("discrete_start", 0.0, p)
    bounces, seen, messages = [], [], []
    while not messages and t < 10.0:
        tick = first + period * math.floor((t - first) / period + 1.0 + 1e-9)

        def crossing(t: float, y: np.ndarray, w: np.ndarray = w) -> float:
            return float(module.evaluate("indicator", *_solved(module, t, y, w))[0][0])

        crossing.terminal, crossing.direction = True, 1.0  # type: ignore[attr-defined]
        run = solve_ivp(
            lambda t, y, w=w: np.concatenate([y[1:], module.forward_dynamics(t, y[:1], y[1:], w=w)]),
            (t, tick),
            y,
            method="DOP853",
            rtol=1e-12,
            atol=1e-13,
            events=crossing,
        )
        t, y = float(run.t[-1]), run.y[:, -1]
        w = w.copy()
        if run.status == 1:
            bounces.append(t)
            w[relations] = 1.0
        else:
            w[module.KINDS.index("clock")] = 1.0
            seen.append(y[0] > 0.5)
        y, w, messages = _settle(module, t, y, w)
        w = w.copy()
        w[relations] = 0.0  # it flies up again
        _, w, more = _settle(module, t, y, w)
        messages += more
        assert w[0] == len(bounces)
        assert not seen or bool(w[1]) == seen[-1]
    fall = math.sqrt(2.0 / G)
    np.testing.assert_allclose(bounces, fall * (1.0 + 2.0 * np.cumsum([0.0, 0.8, 0.64, 0.512, 0.4096])), atol=1e-10)
    assert messages == ["bounced five times"]
    assert True in seen and False in seen


def test_closed_contacts_carry_and_open_ones_do_not() -> None:
    module = _module(ON_THE_FLOOR)
    assert module.KINDS == ("contact", "impacts")
    assert module.CONTACT_ROWS == (0,)
    w = np.array([[1.0, 0.0], [0.0, 3.0]])
    f = np.array([[0.0], [5.0]])
    qdd = module.forward_dynamics(0.0, [0.0, 0.0], [1.0, 0.0], u=f[:, None], w=w)
    np.testing.assert_allclose(qdd, [[[0.0, 0.0], [0.0, -G]], [[0.0, 0.0], [0.0, 2.5 - G]]], atol=1e-14)
    lam = module.multipliers(0.0, [0.0, 0.0], [1.0, 0.0], u=f[:, None], w=w)
    np.testing.assert_allclose(lam[..., 0], [[2.0 * G, 0.0], [2.0 * G - 5.0, 0.0]], atol=1e-13)
    np.testing.assert_allclose(module.output(0.0, [0.0, 0.0], [1.0, 0.0], w=w)[:, 0], [2.0 * G, 0.0], atol=1e-13)
    p, none = np.array(module.DEFAULTS), np.zeros(0)
    gap, speed, jacobian, restitution, capture_speed, rest = module.evaluate(
        "contact", 0.0, [0.0, 0.3], [1.0, -2.0], none, [0.0], w[1], p
    )
    assert (gap[0], speed[0], restitution[0], capture_speed[0], rest[0]) == (0.3, -2.0, 0.5, 0.1, -1.0)
    np.testing.assert_array_equal(jacobian, [[0.0, 1.0]])


@pytest.mark.parametrize("text", [BALL, ON_THE_FLOOR])
def test_the_module_computes_what_the_model_does_for_any_discretes(text: str) -> None:
    module, model = _module(text), lagdsl.compile(text, engine="numpy")
    draw = np.random.default_rng(5)
    n = len(module.COORDINATES)
    q, qd = draw.normal(size=(2, 6, n))
    w = draw.integers(0, 2, size=(6, len(module.DISCRETES))).astype(float)
    for name in ("forward_dynamics", "multipliers", "output", "state_jacobian"):
        np.testing.assert_array_equal(getattr(module, name)(0.3, q, qd, w=w), getattr(model, name)(0.3, q, qd, w=w))
        np.testing.assert_array_equal(getattr(module, name)(0.3, q, qd), getattr(model, name)(0.3, q, qd))
    with pytest.raises(ValueError, match="w must have"):
        module.forward_dynamics(0.3, q, qd, w=w[:, 1:])


def test_modules_without_events_say_nothing_of_them() -> None:
    module = _module("model Free coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; end Free;")
    assert not hasattr(module, "KINDS")
    assert "event" not in module.FUNCTIONS
