"""Blocks that sample, switch and count, against their definitions evaluated by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lagdsl

MODEL = """
model Signals
  import Lag.Blocks.*;
  coordinate Length h(der(start = 1 m/s)) "runs like time";
  gravity = 0;
  mass 1 kg at {{h, 0, 0}};
  Real x = h/(1 m);
  {block}
end Signals;
"""


def run(block: str, stop: float = 2.0, interval: float = 0.01) -> lagdsl.Trajectory:
    return lagdsl.compile(MODEL.format(block=block)).simulate(stop=stop, interval=interval, tolerance=1e-11)


def held(values: dict[float, float], t: np.ndarray, start: float = 0.0) -> np.ndarray:
    """What is constant between instants, at times that are none of them."""
    ends = np.array(list(values))
    found = np.concatenate([[start], list(values.values())])
    return found[np.searchsorted(ends, t)]


def compared(motion: lagdsl.Trajectory, name: str, values: dict[float, float], start: float = 0.0) -> None:
    far = np.all(np.abs(motion.time[:, None] - np.array(list(values))) > 1e-6, axis=1)
    assert np.count_nonzero(far) > 100
    np.testing.assert_allclose(motion[name][far], held(values, motion.time[far], start), rtol=0, atol=1e-8)


def test_zero_order_hold_and_unit_delay() -> None:
    motion = run("ZeroOrderHold z(u = x^2, period = 0.3 s, first = 0.1 s); UnitDelay d(u = x^2, period = 0.3 s);")
    compared(motion, "z.y", {0.1 + 0.3 * k: (0.1 + 0.3 * k) ** 2 for k in range(7)})
    compared(motion, "d.y", {0.3 * k: (0.3 * (k - 1)) ** 2 if k else 0.0 for k in range(7)})


def test_sampler_rounds_and_is_limited() -> None:
    motion = run("Sampler s(u = sin(7*x), period = 0.07 s, step = 0.25, low = -0.6, high = 0.8);")
    rounded = {0.07 * k: 0.25 * math.floor(math.sin(0.49 * k) / 0.25 + 0.5) for k in range(29)}
    compared(motion, "s.y", {t: min(max(value, -0.6), 0.8) for t, value in rounded.items()})


def test_hysteresis_relay_counter_and_triggered_sampler() -> None:
    motion = run(
        "Hysteresis h2(u = sin(6*x), low = -0.5, high = 0.8); Relay r(u = sin(6*x), low = -0.5, high = 0.8, on = 3);"
        "Counter n(u = h2.y); TriggeredSampler s(u = x, trigger = h2.y);"
    )
    up = [(math.asin(0.8) + 2 * math.pi * k) / 6 for k in range(2)]
    down = [(math.pi + math.asin(0.5) + 2 * math.pi * k) / 6 for k in range(2)]
    switched = dict(sorted([*((t, 1.0) for t in up), *((t, 0.0) for t in down)]))
    compared(motion, "h2.y", switched)
    compared(motion, "r.y", {t: 6.0 * on - 3.0 for t, on in switched.items()}, start=-3.0)
    compared(motion, "n.y", {t: k + 1.0 for k, t in enumerate(up)})
    compared(motion, "s.y", dict(zip(up, up, strict=True)))


def test_relay_begins_where_its_input_is() -> None:
    assert run("Relay r(u = 1 - x, low = 0.2, high = 0.4);", stop=0.1)["r.y"].tolist()[-1] == 1.0


def test_relay_with_hysteresis_makes_a_triangle() -> None:
    """A rate of -1 or 1 that is switched at 0.1 and -0.1 has the period 0.4 s."""
    text = """
    model Thermostat
      state Real z(start = 0);
      Lag.Blocks.Relay heating(u = -z, low = -0.1, high = 0.1, on = 1, off = -1);
      output Real y = z;
    equation
      der(z) = heating.y*(1 /s);
    end Thermostat;
    """
    motion = lagdsl.compile(text).simulate(stop=3.0)
    switches = [event.time for event in motion.events if event.kind == "true"]
    np.testing.assert_allclose(switches, 0.1 + 0.2 * np.arange(len(switches)), atol=1e-8)
    assert len(switches) == 15


def test_pulse_has_exact_edges() -> None:
    motion = run("Pulse p(period = 0.5 s, start = 0.1 s, width = 0.2, height = 2, offset = 1);")
    edges = dict(sorted([*((0.1 + 0.5 * k, 3.0) for k in range(4)), *((0.2 + 0.5 * k, 1.0) for k in range(4))]))
    compared(motion, "p.y", edges, start=1.0)
    ticks = [event.time for event in motion.events if event.kind == "tick"]
    assert ticks == pytest.approx(list(edges), abs=1e-15)


def pid(errors: list[float], period: float, ti: float, td: float, limit: float) -> list[float]:
    """Section 8.5 of Astrom and Wittenmark (1997), with kp = 2, N = 10."""
    kp, n, tt = 2.0, 10.0, math.sqrt(ti * td) if td else ti
    integral = derivative = last = demand = y = 0.0
    found = []
    for error in errors:
        integral += kp * period / ti * error + (period / tt * (y - demand) if tt < math.inf else 0.0)
        derivative = (td * derivative + kp * n * td * (error - last)) / (td + n * period)
        demand, last = kp * error + integral + derivative, error
        y = min(max(demand, -limit), limit)
        found.append(y)
    return found


@pytest.mark.parametrize(
    ("words", "ti", "td", "limit"),
    [
        ("", math.inf, 0.0, math.inf),
        (", Ti = 0.4 s", 0.4, 0.0, math.inf),
        (", Ti = 0.4 s, Td = 0.2 s", 0.4, 0.2, math.inf),
        (", Ti = 0.4 s, Td = 0.2 s, high = 3", 0.4, 0.2, 3.0),
        (", Td = 0.2 s", math.inf, 0.2, math.inf),
    ],
)
def test_discrete_pid(words: str, ti: float, td: float, limit: float) -> None:
    motion = run(f"DiscretePID c(u = cos(3*x), period = 0.05 s, kp = 2{words});")
    times = [0.05 * k for k in range(41)]
    expected = pid([math.cos(3 * t) for t in times], 0.05, ti, td, limit)
    compared(motion, "c.y", dict(zip(times, expected, strict=True)))
