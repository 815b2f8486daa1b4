"""Events under both engines: rows, failures, inputs that jump."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.motion.simulate.failure import SimulationFailed

G = 9.80665
FALLING = """
model Falling
  coordinate Length h(start = 1 m);
  input Force F = 0;
  {declarations}
  gravity = -g_n*world.y;
  mass 1 kg at {{0, h}};
  force F on h;
  {items}
equation
  {equations}
end Falling;
"""


def falling(engine: EngineName, declarations: str = "", items: str = "", equations: str = "") -> lagdsl.Model:
    return lagdsl.compile(FALLING.format(declarations=declarations, items=items, equations=equations), engine=engine)


FAILURES = {
    "E0810": ("", "", 'when h <= 0.5 m then assert(der(h) > 0, "falls"); end when;'),
    "E0832": (
        "",
        "",
        "when h <= 0.5 m then reinit(der(h), 1 m/s); end when; when h <= 0.5 m then reinit(der(h), 0); end when;",
    ),
    "E0833": ("", "", "when h <= 0 then reinit(der(h), -0.5*pre(der(h))); end when;"),
    "E0834": ("", "contact roof: h >= 2 m with restitution = 0.5;", ""),
}


@pytest.mark.parametrize("code", FAILURES)
def test_what_fails_fails_alike(code: str) -> None:
    told = []
    for engine in ("numpy", "c"):
        with pytest.raises(SimulationFailed) as failure:
            falling(engine, *FAILURES[code]).simulate(stop=5.0)
        diagnostic = failure.value.diagnostic
        assert diagnostic.code == code
        labels = [(label.span.start, label.span.end, label.text) for label in diagnostic.labels]
        told.append((failure.value.time, labels, len(failure.value.trajectory.events)))
    assert told[0][0] == pytest.approx(told[1][0], abs=1e-7)
    assert told[0][1:] == told[1][1:]


def test_impacts_accumulate() -> None:
    motion = falling("c", items="contact floor: h >= 0 with restitution = 0.5;").simulate(stop=3.0)
    assert motion.events[-1].kind == "closed"
    # impacts at t1 (1 + 2 (e + ... + e^k)), which accumulate at 3 t1
    first = math.sqrt(2.0 / G)
    times = [first * (1.0 + 2.0 * sum(0.5**i for i in range(1, k + 1))) for k in range(5)]
    assert [event.time for event in motion.events[:5]] == pytest.approx(times, abs=1e-9)


@pytest.mark.parametrize("interval", [0.1, 0.037])
def test_rows_are_where_they_are_under_numpy(interval: float) -> None:
    text = "when sample(0, 0.1 s) then n = pre(n) + 1; end when; when h <= 0.5 m then reinit(der(h), 0); end when;"
    declarations = "discrete Integer n(start = 0);"
    first, second = (
        falling(engine, declarations, equations=text).simulate(stop=0.6, interval=interval) for engine in ("numpy", "c")
    )
    np.testing.assert_allclose(first.time, second.time, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(first["n"], second["n"])
    np.testing.assert_allclose(first["der(h)"], second["der(h)"], rtol=0, atol=1e-9)


@pytest.mark.parametrize("engine", ["numpy", "c"])
def test_inputs_that_jump_at_a_tick_are_those_behind_it(engine: EngineName) -> None:
    text = "when sample(0.5 s, 1 s) then n = F/(1 N); end when;"
    table = ([0.0, 0.5, 0.5, 1.0], [1.0, 1.0, 7.0, 7.0])
    motion = falling(engine, "discrete Real n(start = 0);", equations=text).simulate(stop=1.0, inputs={"F": table})
    assert motion["n"][-1] == 7.0


def test_a_jump_of_positions_is_refused_at_its_event() -> None:
    text = """
    model Torn
      coordinate Real x(der(start = 1)), y;
      discrete Real n(start = 0);
      gravity = 0;
      kinetic 1/2*der(x)^2 + 1/2*der(y)^2;
      constraint c: y = n;
    equation
      when time >= 0.5 then n = x; end when;
      annotation(units = "none");
    end Torn;
    """
    with pytest.raises(SimulationFailed) as failure:
        lagdsl.compile(text, engine="c").simulate(stop=1.0)
    assert failure.value.diagnostic.code == "E0835"
    assert failure.value.time == pytest.approx(0.5, abs=1e-12)
    assert failure.value.trajectory.time[-1] == pytest.approx(0.5, abs=1e-12)


@pytest.mark.parametrize("engine", ["numpy", "c"])
def test_where_inputs_jump_relations_turn_before_clocks_tick(engine: EngineName) -> None:
    text = "when F > 4 N then n = 2; end when; when sample(0.5 s, 1 s) then m = 10*n; end when;"
    declarations = "discrete Real n(start = 1), m(start = 0);"
    table = ([0.0, 0.5, 0.5, 1.0], [1.0, 1.0, 7.0, 7.0])
    motion = falling(engine, declarations, equations=text).simulate(stop=1.0, inputs={"F": table})
    assert [event.kind for event in motion.events] == ["true", "tick"]
    assert (motion["n"][-1], motion["m"][-1]) == (2.0, 20.0)
