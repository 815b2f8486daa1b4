"""Free parameters, tables as inputs and failures: in one call of C, with the bits and the words of single runs."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.ensemble import Bench, Stop
from lagdsl.engines.runtime.signal_tables import SignalTable
from lagdsl.engines.runtime.structures import SignalKind
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.sweep.ensemble import Ensemble
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Options, Outcome, Runner, SweptModel

CLOCK = """
model Clock
  parameter Length l(fixed = false, start = 0.5 m, max = 2 m);
  parameter Time period = 2 s;
  coordinate Angle theta(start = 1 deg);
  gravity = -g_n*world.y;
  mass 1 kg at {l*sin(theta), -l*cos(theta)};
  output Length twice = 2*l;
initial equation
  der(der(theta)) = -(2*pi/period)^2*sin(theta);
end Clock;
"""
# Restitution is told to events and may not exceed one: what it is found to be decides.
BALL = """
model Ball
  parameter Real e(fixed = false, start = 0.5);
  parameter Real wanted = 0.5;
  coordinate Length h(start = 1 m);
  kinetic 1/2*(1 kg)*der(h)^2;
  force -(10 N) on h;
  contact c: h >= 0 m with restitution = e;
initial equation
  e = wanted;
end Ball;
"""
DRIVEN = """
model Driven
  input Force f; input Integer gear(start = 1); input Length road(smooth = 2); input Force bias(start = k*(1 m));
  parameter Real k(unit = "N/m") = 3;
  coordinate Length x, y;
  kinetic 1/2*(1 kg)*(der(x)^2 + (der(y) + der(road))^2);
  potential 1/2*k*x^2 + 1/2*k*y^2;
  force f*gear + bias on x;
end Driven;
"""
INPUTS = {
    "f": ([0.0, 0.3, 0.3, 1.0], [1.0, 2.0, -1.0, 0.5]),
    "gear": ([0.0, 0.5, 1.0], [1, 2, 1]),
    "road": ([0.0, 0.2, 0.5, 0.7, 1.0], [0.0, 0.1, 0.1, 0.3, 0.2]),
}
# One way to fail each: of the start, of the motion, at an event; beyond a limit that is found.
FAILING = {
    "reach": """model Reach
        parameter Length l = 1 m;
        coordinate Angle a(start = 30 deg), b(start = 60 deg);
        mass 1 kg at {cos(a), sin(a)}*(1 m);
        mass 1 kg at {cos(b), sin(b)}*(1 m);
        constraint rod: norm({cos(a) - cos(b), sin(a) - sin(b)}*(1 m) + {3*(l - 1 m), 0 m}) = 0.1 m;
        end Reach;""",
    "number": """model Number
        parameter Length l = 1 m;
        coordinate Length x(start = 1 m); kinetic 1/2*(1 kg)*der(x)^2; force sqrt((3 m - l - x)/(1 m))*(1 N) on x;
        end Number;""",
    "start": """model Start
        parameter Length l = 1 m;
        coordinate Length x(start = sqrt(2 m - l)*sqrt(1 m)); kinetic 1/2*(1 kg)*der(x)^2; force -(1 N) on x;
        end Start;""",
    "assertion": """model Assertion
        parameter Length l = 1 m;
        coordinate Length x(start = l); kinetic 1/2*(1 kg)*der(x)^2; force -(10 N) on x;
        equation assert(x > 0.9 m, "too low"); end Assertion;""",
    "chatter": """model Chatter
        parameter Length l = 1 m;
        coordinate Length x(der(start = l/(2 s))); kinetic 1/2*(1 kg)*der(x)^2;
        force -(3 N)*sign(der(x)) on x; end Chatter;""",
}


def made(
    text: str, chosen: list[dict[str, float]], inputs: dict[str, object] | None = None
) -> list[tuple[Outcome, ...]]:
    """Outcomes of one call of C, with those that are made alone."""
    compilation = lagdsl.compile(text)._compilation
    flat, program = compilation.flat, compilation.program
    options = Options(stop=1.0, interval=0.1, tolerance=1e-7, solver="auto", engine="tape", inputs=inputs or {})
    tasks = [Task(index=k, swept=0, parameters=values, start={}) for k, values in enumerate(chosen)]
    several = Ensemble(flat, TapeEngine(program), options).run(tasks, Bench(), Stop())
    assert None not in several
    alone = Runner([SweptModel(flat=flat, program=program)], options)
    return [(outcome, alone(task)) for outcome, task in zip(several, tasks, strict=True) if outcome is not None]


def compare(one: Outcome, single: Outcome) -> None:
    assert (one.status, one.message, one.names, one.units) == (
        single.status,
        single.message,
        single.names,
        single.units,
    )
    assert np.array_equal(one.ended, single.ended, equal_nan=True)
    assert one.values.tobytes() == single.values.tobytes()


def test_free_parameters_within_bounds_and_beyond() -> None:
    periods = [0.5, 1.0, 2.0, 3.0]
    outcomes = made(CLOCK, [{"period": period} for period in periods])
    for period, (one, single) in zip(periods, outcomes, strict=True):
        compare(one, single)
        length = 9.80665 * (period / (2.0 * math.pi)) ** 2
        if length <= 2.0:
            assert one.values[-1, one.names.index("twice")] == pytest.approx(2.0 * length, rel=1e-9)
        else:
            assert one.message.startswith("E0838")
    assert outcomes[-1][0].status == "failed"


def test_limits_of_what_is_found() -> None:
    (kept, alone), (wrong, told) = made(BALL, [{"wanted": 0.8}, {"wanted": 1.5}])
    compare(kept, alone)
    compare(wrong, told)
    assert wrong.message.startswith("E0334") and np.isnan(wrong.ended)


def test_tables_as_inputs() -> None:
    outcomes = made(DRIVEN, [{"k": k} for k in (1.0, 3.0, 50.0)], INPUTS)
    for one, single in outcomes:
        assert one.status == "ok"
        compare(one, single)
    assert len({one.values.tobytes() for one, _ in outcomes}) == 3


@pytest.mark.parametrize("name", FAILING)
def test_failures_have_the_words_and_rows_of_single_runs(name: str) -> None:
    outcomes = made(FAILING[name], [{"l": length} for length in (1.0, 2.5, 0.95)])
    for one, single in outcomes:
        compare(one, single)
    assert any(one.status == "failed" for one, _ in outcomes)


def test_nobody_makes_them_again(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object) -> Outcome:
        raise AssertionError("made by itself")

    monkeypatch.setattr(Runner, "__call__", never)
    motions = lagdsl.compile(CLOCK, engine="tape").simulate_many(
        parameters={"period": [1.0, 3.0]}, stop=0.1, interval=0.05
    )
    assert list(motions.failures) == [1] and "E0838" in motions.failures[1]
    driven = lagdsl.compile(DRIVEN, engine="tape").simulate_many(
        parameters={"k": [1.0, 2.0]}, inputs=INPUTS, stop=1.0, interval=0.1
    )
    assert driven.failures == {}


def test_sweep_from_the_command_line(tmp_path: Path) -> None:
    (tmp_path / "clock.lag").write_text(CLOCK)
    out = tmp_path / "clock.csv"
    asked = ["--set", "period=1,2 s", "--stop", "0.1", "--interval", "0.1", "-o", str(out)]
    told = CliRunner().invoke(lag, ["sweep", str(tmp_path / "clock.lag"), *asked])
    assert told.exit_code == 0, told.output
    rows = np.genfromtxt(out, delimiter=",", names=True)
    for period in (1.0, 2.0):
        found = rows["twice"][rows["period"] == period]
        assert found == pytest.approx(2.0 * 9.80665 * (period / (2.0 * math.pi)) ** 2, rel=1e-9)


def _steps(times: list[float], values: list[float], t: float, find: Callable[[list[float], float], int]) -> float:
    return values[max(find(times, t) - 1, 0)]


def _lines(times: list[float], values: list[float], t: float, find: Callable[[list[float], float], int]) -> float:
    end = min(max(find(times, t), 1), len(times) - 1)
    t0, t1 = times[end - 1], times[end]
    part = (t - t0) / (t1 - t0) if t1 > t0 else 1.0
    return values[end - 1] + part * (values[end] - values[end - 1])


@pytest.mark.parametrize(("kind", "rule"), [(SignalKind.STEPS, _steps), (SignalKind.LINES, _lines)])
def test_values_of_tables(kind: SignalKind, rule: Callable[..., float]) -> None:
    times, values = [0.0, 0.25, 0.25, 0.25, 1.0, 1.7], [1.0, 2.0, -3.0, 4.0, 0.1, 0.7]
    table = SignalTable(kind, np.array(times), np.array(values))
    random = np.random.default_rng(3)
    for t in [*times, -1.0, 5.0, *random.uniform(-0.5, 2.0, 200).tolist()]:
        assert table(t, False) == rule(times, values, t, bisect_right)
        assert table(t, True) == rule(times, values, t, bisect_left)


def test_values_of_polynomials() -> None:
    random = np.random.default_rng(4)
    times, powers = np.array([0.0, 0.4, 1.0]), random.normal(size=(2, 4))
    table = SignalTable(SignalKind.POLYNOMIAL, times, powers)
    for t, piece in ((-0.1, 0), (0.2, 0), (0.4, 1), (0.9, 1), (1.0, 1), (1.2, 1)):
        assert table(t, False) == pytest.approx(np.polyval(powers[piece], t - times[piece]), rel=1e-14)
    assert table(0.4, True) == pytest.approx(np.polyval(powers[0], 0.4), rel=1e-14)
