"""Sampled loops against characteristic polynomials, against matrices of the literature, and against simulations."""

from __future__ import annotations

import re

import control
import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl
from lagdsl import CompilationFailed
from lagdsl.foundation.diagnostics import CallRefused, Sink
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.analysis.modes import Modes

TICK = "when sample(0, {h}) then {law} end when;"
PLANT = """model Plant
  parameter Time h = 0.1 s;
  parameter Real k(unit = "N/m") = 4, d(unit = "N.s/m") = 1;
  coordinate Length x(start = {start} m);
  {signals}
  {more}
  kinetic 1/2*(1 kg)*der(x)^2;
  {force}
equation
  {clauses}
end Plant;
"""


def plant(clauses: str, more: str = "", start: str = "0") -> Model:
    assigned = [name for name in "uvi" if re.search(rf"\b{name} = ", clauses)]
    signals = " ".join(f"discrete Force {name}(start = 0);" for name in assigned)
    force = "force u on x;" if "u" in assigned else ""
    return lagdsl.compile(PLANT.format(clauses=clauses, signals=signals, force=force, more=more, start=start))


def multipliers(found: Modes) -> NDArray[np.complex128]:
    assert found.loop is not None, found.unjudged
    return np.sort_complex(found.loop.multipliers)


def roots(*coefficients: float) -> NDArray[np.complex128]:
    return np.sort_complex(np.roots(coefficients))


INTEGRATOR = """model Held
  parameter Real k(unit = "1/s") = 3;
  state Real y(start = 0);
  discrete Real u(start = 0), v(start = 0);
equation
  der(y) = u/(1 s);
  when sample(0, 0.25 s) then v = -k*y*(1 s); u = {source}; end when;
end Held;
"""


def test_a_held_integrator() -> None:
    """y' = u, u = -k y at ticks: y[k+1] = (1 - k h) y[k]."""
    model = lagdsl.compile(INTEGRATOR.format(source="v"))
    found = model.modes()
    np.testing.assert_allclose(multipliers(found), [1.0 - 3.0 * 0.25], rtol=1e-13)
    assert found.stability == "stable: largest multiplier 0.25 at 0.25 s"
    (threshold,) = model.vary("k", "1:1:20 1/s").thresholds
    assert threshold.value == pytest.approx(8.0, rel=1e-10)  # k h = 2: the multiplier -1


def test_one_tick_of_delay_by_pre_counts() -> None:
    """u[k] = v[k-1]: z^2 - z + k h = 0, which leaves the unit circle at k h = 1 instead of 2."""
    model = lagdsl.compile(INTEGRATOR.format(source="pre(v)"))
    np.testing.assert_allclose(multipliers(model.modes()), roots(1.0, -1.0, 0.75), rtol=1e-12)
    (threshold,) = model.vary("k", "1:1:20 1/s").thresholds
    assert threshold.value == pytest.approx(4.0, rel=1e-10)


LAW = "u = -k*x - d*der(x);"


def test_a_double_integrator_with_pd() -> None:
    """det = 1 - d h + k h^2/2, trace = 2 - d h - k h^2/2 (Åström and Wittenmark, section 3.2)."""
    model = plant(TICK.format(h="h", law=LAW))
    h, k, d = 0.1, 4.0, 1.0
    expected = roots(1.0, -(2.0 - d * h - k * h * h / 2.0), 1.0 - d * h + k * h * h / 2.0)
    found = model.modes()
    np.testing.assert_allclose(multipliers(found), expected, rtol=1e-12)
    assert found.stability == f"stable: largest multiplier {np.max(np.abs(expected)):.6g} at 0.1 s"


@pytest.mark.parametrize(("damping", "critical", "frequency"), [(1.0, 0.5, None), (3.0, 2.0 / 3.0, 0.75)])
def test_critical_sampling_time(damping: float, critical: float, frequency: float | None) -> None:
    """Jury: h = 2 d/k for a pair, h = 2/d for the multiplier -1, whichever is less."""
    found = plant(TICK.format(h="h", law=LAW)).vary("h", "0.05:0.1:0.95 s", p={"d": damping})
    (threshold,) = found.thresholds
    assert threshold.value == pytest.approx(critical, rel=1e-10)
    assert threshold.unstable_above
    assert frequency is None or threshold.frequency == pytest.approx(frequency)
    assert found.held == ()


MOTOR = """model Motor "PI on the speed, one tick of delay"
  parameter Inertia J = 2e-3 kg.m2;
  parameter Real b(unit = "N.m.s/rad") = 5e-3, kp(unit = "N.m.s/rad") = 0.03, ki(unit = "N.m/rad") = 0.4;
  parameter AngularVelocity w = 12 rad/s;
  parameter Time h = 10 ms;
  coordinate Angle phi;
  discrete Torque u(start = 0), v(start = 0), i(start = 0);
  kinetic 1/2*J*der(phi)^2;
  dissipation 1/2*b*der(phi)^2;
  torque u on phi;
equation
  when sample(0, h) then
    i = pre(i) + ki*h*(w - der(phi));
    v = kp*(w - der(phi)) + i;
    u = pre(v);
  end when;
end Motor;
"""


def test_pi_on_a_motor_with_one_tick_of_delay() -> None:
    """z (z - a)(z - 1) + g (kp (z - 1) + ki h z) = 0, a = exp(-b h/J), g = (1 - a)/b; and the angle that runs."""
    a = np.exp(-5e-3 * 0.01 / 2e-3)
    g = (1.0 - a) / 5e-3
    expected = roots(1.0, -(1.0 + a), a + g * (0.03 + 0.4 * 0.01), -g * 0.03)
    model = lagdsl.compile(MOTOR)
    found = model.modes(trim=True)
    assert found.point.qd[0] == pytest.approx(12.0, rel=1e-12)
    assert found.loop is not None
    assert found.loop.running == ("phi",)
    np.testing.assert_allclose(np.sort_complex(found.loop.multipliers[:-1]), expected, rtol=1e-9)
    assert found.loop.multipliers[-1] == 1.0
    assert found.stability.startswith("stable but for drift: 1 of 4 multipliers is one, the largest other one is")
    assert model.modes().stability.startswith("no statement on the sampled loop: `der(phi)`")


DUAL = """
  when sample({first}, 0.1 s) then u = 6*v - (6 N.s/m)*der(x); end when;
  when sample(0, 0.3 s) then v = -(1.5 N/m)*x; end when;
"""


@pytest.mark.parametrize("first", ["0", "0.04 s"])
def test_two_rates_over_their_common_period(first: str) -> None:
    """The steps of both loops multiplied by hand: deviations x, der(x), u, v."""
    found = plant(DUAL.format(first=first)).modes()
    offset = 0.04 if first != "0" else 0.0

    def flow(time: float) -> NDArray[np.float64]:
        return np.array([[1, time, time**2 / 2, 0], [0, 1, time, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=float)

    inner = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, -6, 0, 6], [0, 0, 0, 1]], dtype=float)
    outer = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [-1.5, 0, 0, 0]], dtype=float)
    period = flow(0.1 - offset) @ inner @ flow(0.1) @ inner @ flow(0.1) @ inner @ flow(offset) @ outer
    expected = np.sort_complex([z for z in np.linalg.eigvals(period) if abs(z) > 1e-9])
    told = multipliers(found)
    np.testing.assert_allclose(told[np.abs(told) > 1e-9], expected, rtol=1e-9)
    assert found.stability.endswith("over the common period 0.3 s")


ROD = """model Rod "an upright rod on a cart that is driven by samples"
  parameter Length l = 0.4 m;
  coordinate Length x;
  coordinate Angle a(start = {start} rad);
  discrete {kind} u(start = 0), old(start = 0);
  input Force push = 0 N;
  gravity = -g_n*world.y;
  mass 1 kg at {{x, 0}};
  mass 0.3 kg at {{x + l*sin(a), l*cos(a)}};
  force push on x;
  {drive}
  output Angle lean = a;
equation
  when sample(0, 20 ms) then
    u = {law};
    old = pre(u);
  end when;
end Rod;
"""
FORCE = ROD.replace("{kind}", "Force").replace("{drive}", "force u on x;")
DRIVEN = ROD.replace("{kind}", "Velocity").replace("{drive}", "constraint drive: der(x) = u;")


@pytest.mark.parametrize(
    ("text", "law"),
    [
        (FORCE, "(9 N/rad)*a + (1 N.s/rad)*der(a) + (0.5 N.s/m)*der(x) + 0.1*pre(old)"),
        (FORCE, "(0.2 kg)*der(der(x)) + (5 N/rad)*a"),  # an accelerometer
        (DRIVEN, "(2 m/s)*a + 0.3*pre(u)"),  # each tick is a blow
    ],
)
def test_growth_of_a_simulation(text: str, law: str) -> None:
    """Deviations of a nanoradian after 0.4 s, from the state just before the first tick."""
    size = 1e-6
    motion = lagdsl.compile(text.format(law=law, start=size)).simulate(stop=0.4, interval=0.02, tolerance=1e-13)
    loop = lagdsl.compile(text.format(law=law, start="0")).linearize(every=0.02)
    system = loop.to_control()
    states = [state.name for state in loop.states]
    start = np.array([size if name == "a" else 0.0 for name in states])
    found = control.initial_response(system, T=np.arange(21) * 0.02, X0=start).outputs
    simulated = np.array([motion["lean"][int(np.searchsorted(motion.time, t - 1e-9))] for t in np.arange(21) * 0.02])
    np.testing.assert_allclose(simulated, found, rtol=1e-6)
    assert np.ptp(found) > 0.3 * size


def test_a_rate_that_samples_prescribe_closes_a_loop() -> None:
    """Between ticks no force depends on u: it acts by the row of the constraint."""
    model = lagdsl.compile(DRIVEN.format(law="(2 m/s)*a + 0.3*pre(u)", start="0"))
    found = model.modes()
    assert found.held == ("u",)
    np.testing.assert_allclose(multipliers(found), np.sort_complex(model.linearize(every=0.02).poles), rtol=1e-12)


def test_what_other_events_set_is_told_as_held() -> None:
    sink = Sink()
    clauses = TICK.format(h="h", law="u = -k*x - d*der(x);") + "when x > 1 m then v = 1 N; end when;"
    model = plant(clauses, "force v on x;", "0")
    assert model.modes(sink=sink).stability.startswith("stable")
    assert [each.message.split(": ")[1] for each in sink.diagnostics] == ["`v`"]


def test_inputs_are_held_between_instants() -> None:
    """Without clocks: the discretization of python-control."""
    text = FORCE.format(law="0", start="0").split("equation")[0] + "end Rod;"
    declared = "discrete Force u(start = 0), old(start = 0);"
    model = lagdsl.compile(text.replace("force u on x;", "").replace(declared, ""))
    ours = model.linearize(every="20 ms").to_control()
    theirs = control.c2d(model.linearize().to_control(), 0.02, method="zoh")
    for one, other in ((ours.A, theirs.A), (ours.B, theirs.B), (ours.C, theirs.C), (ours.D, theirs.D)):
        np.testing.assert_allclose(one, other, atol=1e-13)
    assert ours.dt == 0.02


def test_resets_at_ticks() -> None:
    """The determinant of a flow without damping is one; a tick that halves the rate halves it."""
    found = plant("when sample(0, h) then reinit(der(x), 0.5*der(x)); end when;", "potential 1/2*k*x^2;").modes()
    assert np.prod(multipliers(found)) == pytest.approx(0.5, rel=1e-12)


def test_a_truth_that_turns_at_each_tick_doubles_the_period() -> None:
    """Every second tick sets u: the loop of the period 2 h."""
    clauses = "when sample(0, h) then on = not pre(on); if on then u = -k*x - d*der(x); end if; end when;"
    found = plant(clauses, "discrete Boolean on(start = false);").modes()
    assert found.loop is not None
    assert found.loop.period == pytest.approx(0.2)
    expected = plant(TICK.format(h="2*h", law=LAW)).modes()
    told = multipliers(found)
    np.testing.assert_allclose(told[np.abs(told) > 1e-12], multipliers(expected), rtol=1e-12)


LIMITED = "v = floor((0.5 m - x)/(1 mm))*(4e-3 N); u = limit(v - d*der(x), -1.5 N, 1.5 N);"


def test_quantizers_and_limits_are_named() -> None:
    model = plant(TICK.format(h="h", law=LIMITED))
    found = model.modes(trim=True)
    assert found.point.q[0] == pytest.approx(0.5, rel=1e-9)
    np.testing.assert_allclose(multipliers(found), multipliers(plant(TICK.format(h="h", law=LAW)).modes()), rtol=1e-9)
    named = "without `floor((0.5 m - x)/(1 mm))`, `limit(v - d*der(x), -1.5 N, 1.5 N)`"
    assert found.stability.endswith(named)
    assert model.linearize(every=0.1, trim=True).without == tuple(each.name for each in found.loop.ignored)  # type: ignore[union-attr]


def test_a_relay_has_no_verdict_but_the_plant_has_modes() -> None:
    model = plant("when sample(0, h) then u = if x > 0 then -(1 N) else 1 N; end when;")
    found = model.modes()
    assert found.loop is None
    assert "`u` is set with two sides of `x > 0`" in found.stability
    with pytest.raises(CompilationFailed, match="E0865"):
        model.linearize(every=0.1)


@pytest.mark.parametrize(
    ("clauses", "every", "code"),
    [
        (TICK.format(h="h", law=LAW), 0.15, "E0863"),
        (TICK.format(h="0.1 s", law="v = x*(1 N/m);") + TICK.format(h="0.100000123 s", law="u = -v;"), 0.1, "E0862"),
    ],
)
def test_periods_that_do_not_fit(clauses: str, every: float, code: str) -> None:
    with pytest.raises(CompilationFailed, match=code):
        plant(clauses).linearize(every=every)


def test_a_loop_that_cannot_rest() -> None:
    with pytest.raises(CompilationFailed, match="E0864"):
        plant(TICK.format(h="h", law="i = pre(i) + 1 N; u = i;")).modes(trim=True)


@pytest.mark.parametrize(
    ("clauses", "more", "reason"),
    [
        ("when sample(0, h) then impact(x + 1 m, 0.5); end when;", "", "lets bodies collide"),
        (
            "when sample(0, h) then reinit(der(x), 0.5*der(x)); end when;",
            "coordinate Length y; mass 1 kg at {y, 0}; constraint rod: x + y = 0;",
            "constraints move rates",
        ),
    ],
)
def test_ticks_without_a_linearization(clauses: str, more: str, reason: str) -> None:
    model = plant(clauses, more)
    with pytest.raises(CompilationFailed, match=f"E0866.*{reason}"):
        model.linearize(every=0.1)
    assert reason in model.modes().stability


def test_a_reference_that_moves_has_no_fixed_point() -> None:
    model = plant(TICK.format(h="h", law="u = k*(0.1 m*sin((1 rad/s)*time) - x) - d*der(x);"))
    assert model.modes().stability.startswith("no statement on the sampled loop: `time` changes")
    sink = Sink()
    model.linearize(every=0.1, sink=sink)
    assert [each.code for each in sink.diagnostics] == ["W0854"]


def test_an_input_is_read_at_the_tick() -> None:
    """u[k] = r[k] - k x[k]: the output behind the tick has r at once, the next state has it held."""
    model = plant(TICK.format(h="h", law="u = r - k*x;"), "input Force r = 0 N; output Force told = u;")
    found = model.linearize(every=0.1)
    np.testing.assert_allclose(found.B, [[0.005], [0.1]], rtol=1e-13)
    np.testing.assert_allclose(found.C, [[-4.0, 0.0]], rtol=1e-13)
    np.testing.assert_allclose(found.D, [[1.0]], rtol=1e-13)
    assert model.bode(every=0.1).transfer.static_gain == pytest.approx(0.0, abs=1e-12)


def test_what_is_set_anew_is_no_state() -> None:
    model = plant(TICK.format(h="h", law=LAW))
    found = model.linearize(every=0.1)
    assert [each.name for each in found.states] == ["x", "der(x)"]
    assert [each.name for each in found.left_out] == ["u"]
    np.testing.assert_allclose(np.sort_complex(found.poles), multipliers(model.modes()), rtol=1e-12)


@pytest.mark.parametrize("every", [-0.1, 0.0, float("nan"), "2 mm", "soon"])
@pytest.mark.parametrize("clauses", ["", "when sample(0, h) then u = -k*x; end when;"])
def test_a_period_is_a_positive_time(clauses: str, every: float | str) -> None:
    """A negative one would lead back in time."""
    model = plant(clauses)
    for call in (model.linearize, model.bode):
        with pytest.raises(CallRefused, match="`every` must be a positive time"):
            call(every=every)
