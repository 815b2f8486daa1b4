"""Inputs that change: jumps, straight lines, polynomials; against `lag run` with the same signals."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from fmpy import simulate_fmu

from fmi.exported import VERSIONS, exported
from fmi.importing import slave
from fmi.motions import SAME, SAME_NEAR_EVENTS, deviation, model, signals

BOTH = pytest.mark.parametrize("version", VERSIONS)
NAME, STOP, INTERVAL = "cart_double_pendulum", 2.0, 0.01
JUMPS = ([0.0, 0.5, 0.5, 1.25, 1.25, STOP], [0.0, 0.0, 6.0, 6.0, -4.0, -4.0])
LINES = ([0.0, 0.5, 1.2, STOP], [1.0, 6.0, -8.0, 3.0])


def table(signal: tuple[list[float], list[float]]) -> Any:
    return np.array(list(zip(*signal, strict=True)), dtype=[("time", float), ("u", float)])


def assert_driven(version: int, kind: str, signal: tuple[list[float], list[float]], **options: Any) -> None:
    fmu = exported(NAME, version)
    reference = model(NAME).simulate(stop=STOP, interval=INTERVAL, tolerance=1e-9, inputs={"u": signal})
    still = model(NAME).simulate(stop=STOP, interval=INTERVAL, tolerance=1e-9)
    assert abs(reference["x"][-1] - still["x"][-1]) > 0.1
    rows = simulate_fmu(
        str(fmu.folder),
        validate=False,
        model_description=fmu.description,
        fmi_type=kind,
        stop_time=STOP,
        output_interval=INTERVAL,
        relative_tolerance=1e-10 if kind == "ModelExchange" else 1e-9,
        input=table(signal),
        output=list(signals(reference)),
        **options,
    )
    off = deviation(reference, rows["time"], {name: rows[name] for name in signals(reference)})
    assert len(off.time) > STOP / INTERVAL
    assert not off.first(SAME, SAME_NEAR_EVENTS), off.first(SAME, SAME_NEAR_EVENTS)


@BOTH
@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
def test_an_input_that_jumps(version: int, kind: str) -> None:
    assert_driven(version, kind, JUMPS)


def test_an_input_that_jumps_in_event_mode_of_co_simulation() -> None:
    assert_driven(3, "CoSimulation", JUMPS, use_event_mode=True, early_return_allowed=True)


def test_an_input_on_straight_lines() -> None:
    """Value and slope at each communication point, which need not be where the lines meet."""
    reference = model(NAME).simulate(stop=STOP, interval=INTERVAL, tolerance=1e-9, inputs={"u": LINES})
    times, values = np.array(LINES)
    names, rows = signals(reference), []
    with slave(exported(NAME, 2)) as one:
        one.initialize({"u": values[0]}, stop=STOP, tolerance=1e-9)
        u = [one.fmu.variables["u"].valueReference]
        at = np.union1d(np.linspace(0.0, STOP, 101), times)
        for t, end in pairwise(at):
            piece = np.searchsorted(times, t, side="right") - 1
            slope = (values[piece + 1] - values[piece]) / (times[piece + 1] - times[piece])
            one.set({"u": values[piece] + slope * (t - times[piece])})
            one.raw.setRealInputDerivatives(u, [1], [slope])
            one.step(t, end - t)
            rows.append(one.get(*names))
    off = deviation(reference, at[1:], dict(zip(names, np.array(rows).T, strict=True)))
    assert len(off.time) >= 100
    assert not off.first(SAME, SAME_NEAR_EVENTS), off.first(SAME, SAME_NEAR_EVENTS)


def test_a_polynomial_in_steps_of_any_length() -> None:
    """u = 2 - 3 t + 4 t^2 + t^3, told anew at each communication point, in steps of 50 ms and in two of a second."""
    reference = model(NAME).simulate(
        stop=STOP, interval=0.05, tolerance=1e-10, inputs={"u": lambda t: 2 - 3 * t + 4 * t**2 + t**3}
    )
    names = signals(reference)
    with slave(exported(NAME, 2)) as one:
        reference_of_u = [one.fmu.variables["u"].valueReference] * 3
        for count in (40, 2):
            one.raw.reset()
            one.initialize({"u": 2.0}, stop=STOP, tolerance=1e-10)
            h, rows = STOP / count, []
            for t in h * np.arange(count):
                one.set({"u": 2 - 3 * t + 4 * t**2 + t**3})
                one.raw.setRealInputDerivatives(reference_of_u, [1, 2, 3], [-3 + 8 * t + 3 * t**2, 8 + 6 * t, 6.0])
                one.step(t, h)
                rows.append(one.get(*names))
            columns = dict(zip(names, np.array(rows).T, strict=True))
            off = deviation(reference, h * np.arange(1, count + 1), columns)
            assert len(off.time) == count
            assert not off.first(SAME, SAME_NEAR_EVENTS), off.first(SAME, SAME_NEAR_EVENTS)
