"""Rows on a singular position: accelerations and multipliers are the limits along the motion, or told to have none.

Four-bars whose uprights stay parallel are pendulums, and the forces in their bars follow by hand: with the angle a of
the uprights, the coupler moves without turning, by -sin(a) and cos(a) along x and y. Its moment about its own end gives
the vertical force, the moments of each upright about its pivot the horizontal one times sin(a).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import spread
from fmi.texts import export_text
from fmpy import simulate_fmu
from scipy.integrate import solve_ivp

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.motion.simulate.placed import placed

A02 = Path(__file__).parents[2] / "benchmarks" / "models" / "iftomm_a02.lag"
GRAVITY = 9.81
BESIDE = [sign * distance for distance in (1e-5, 1e-7, 1e-9, 1e-12, 0.0) for sign in (-1, 1)]


OUTPUTS = "output AngularAcceleration a = der(der(up[1])); output Real f = multiplier(along);"


def text_of(*, extra: str, outputs: str) -> str:
    """A02 with one bar, whose first upright has the mass of the other one and `extra` at its middle."""
    text = A02.read_text(encoding="utf-8").replace("Integer N = 2", "Integer N = 1")
    text = text.replace("parameter Mass m = 1 kg;", f"parameter Mass m = 1 kg, e = {extra};")
    text = text.replace("  for i in 1:N loop", "  mass e at upright[1].point({l/2, 0});\n  for i in 1:N loop", 1)
    text = text.replace("constraint l*cos", "constraint along: l*cos").replace(
        "constraint l*sin", "constraint up_: l*sin"
    )
    return text.replace("  annotation", f"  {outputs}\n  annotation")


def row(*, extra: str, outputs: str) -> lagdsl.Model:
    return lagdsl.compile(text_of(extra=extra, outputs=outputs), engine="tape")


def lies_flat(extra: float) -> tuple[float, float, float]:
    """Time [s] at which the uprights lie flat, their rate [rad/s] and acceleration [rad/s2] there."""
    inertia, moment = 2 / 3 + 1 + extra / 4, 1 + 1 + extra / 2
    found = solve_ivp(
        lambda _, y: [y[1], -moment * GRAVITY * np.cos(y[0]) / inertia],
        (0.0, 1.0),
        [np.pi / 2, -1.0],
        method="DOP853",
        rtol=1e-13,
        atol=1e-13,
        events=lambda _, y: y[0],
    )
    return float(found.t_events[0][0]), float(found.y_events[0][0][1]), -moment * GRAVITY / inertia


@pytest.fixture(scope="module")
def even() -> lagdsl.Model:
    return row(extra="0 kg", outputs=OUTPUTS)


@pytest.mark.parametrize("distance", BESIDE)
def test_a_row_has_the_acceleration_of_the_motion(even: lagdsl.Model, distance: float) -> None:
    """It was 17 rad/s2 in place of -11.8 within 1e-12 s of the crossing, and -12.2 at 1e-9 s."""
    time, rate, acceleration = lies_flat(0.0)
    across = even.simulate(stop=1.0, interval=time + distance)
    ending = even.simulate(stop=time + distance, interval=0.1)
    for motion, k in ((across, 1), (ending, -1)):
        assert motion["a"][k] == pytest.approx(acceleration, abs=1e-4)
        assert motion["der(up[1])"][k] == pytest.approx(rate + acceleration * distance, abs=1e-6)
        assert motion["der(up[2])"][k] == pytest.approx(motion["der(up[1])"][k], abs=1e-6)


def test_a_multiplier_has_its_limit(even: lagdsl.Model) -> None:
    """Half of the coupler's centripetal force: the uprights are alike, each takes its part of it.

    `along` counts closure residuals from the first upright to the second: its multiplier is the force in the bar.
    """
    time, rate, _ = lies_flat(0.0)
    force = even.simulate(stop=1.0, interval=time)["f"][1]
    assert force == pytest.approx(-(rate**2) / 2, rel=1e-5)


def test_a_multiplier_without_a_limit_is_nan_and_told() -> None:
    """With a mass on one upright the bar has to turn the other one while it lies along it: its force has a pole."""
    model = row(extra="1 kg", outputs=OUTPUTS)
    time, rate, acceleration = lies_flat(1.0)
    motion = model.simulate(stop=1.0, interval=time)
    assert np.isnan(motion["f"][1]) and np.isfinite(motion["f"][[0, 2]]).all()
    assert motion["a"][1] == pytest.approx(acceleration, abs=1e-4)
    assert any("`f` has no limit" in note for note in motion.statistics.notes)
    # Moments about the pivot of the light upright, which bears half of the coupler: a/3 = -g/2 - (a + g)/2 + f sin(up).
    early = model.simulate(stop=1.0, interval=time - 1e-4)["f"][1]
    late = model.simulate(stop=1.0, interval=time + 1e-4)["f"][1]
    pole = (acceleration / 3 + GRAVITY / 2 + (acceleration + GRAVITY) / 2) / rate
    assert early * -1e-4 == pytest.approx(pole, rel=1e-2) and late * 1e-4 == pytest.approx(pole, rel=1e-2)


@pytest.mark.parametrize("distance", spread([0.0, 1e-12, -1e-9, 1e-7], 2))
def test_a_communication_point_of_an_fmu_has_the_values_of_a_row(
    distance: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It had an acceleration of 17 rad/s2, and the multiplier of least norm."""
    time, rate, acceleration = lies_flat(0.0)
    path = tmp_path / "row.fmu"
    export_text(text_of(extra="0 kg", outputs=OUTPUTS), path)
    step = time + distance
    rows = simulate_fmu(str(path), fmi_type="CoSimulation", stop_time=2 * step, step_size=step, output_interval=step)
    capsys.readouterr()
    assert rows["a"][1] == pytest.approx(acceleration, abs=1e-4)
    assert rows["f"][1] == pytest.approx(-(rate**2) / 2, rel=1e-5)


def test_a_function_at_the_state_of_a_row_has_its_values(even: lagdsl.Model) -> None:
    """`lag_run_evaluate`, with which starts and faults are told."""
    time, _, acceleration = lies_flat(0.0)
    flat, engine = even._compilation.flat, engine_of(even._compilation.program, "tape")
    motion = even.simulate(stop=time, interval=time)
    x = np.array([motion[name][-1] for name in motion.names[1:] if name not in even.outputs])
    run = placed(flat, engine, even.defaults, np.zeros(0))
    run.begin(time, x)
    values = run.evaluate("output", time, x, len(flat.outputs))
    assert values[0] == pytest.approx(acceleration, abs=1e-4)
