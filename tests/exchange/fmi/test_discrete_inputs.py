"""Integer, Boolean and enumerated inputs: the motion in `lag run`, in model exchange and in co-simulation, against a
closed form; the modes in which they may change."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException

from fmi.exported import VERSIONS, Exported, exported
from fmi.importing import exchanged, slave
from fmi.motions import model

BOTH = pytest.mark.parametrize("version", VERSIONS)
NAME, STOP, INTERVAL = "servo_drive", 2.0, 0.01
J, D, GAIN, STEP = 0.5, 0.25, 2.0, 1.5
IDLE, TORQUE, SPEED = 1, 2, 3
Floats = np.ndarray


@dataclass(frozen=True)
class Piece:
    """Inputs from a time on."""

    t: float
    u: float
    gear: int
    brake: bool
    mode: int

    @property
    def torque(self) -> float:
        if self.brake or self.mode == IDLE:
            return 0.0
        return STEP ** (self.gear - 1) * self.u if self.mode == TORQUE else 3 * GAIN

    @property
    def drag(self) -> float:
        return 20 * D if self.brake else D + GAIN if self.mode == SPEED else D


PIECES = (
    Piece(0.0, 1.0, 1, False, TORQUE),
    Piece(0.333, 1.0, 3, False, TORQUE),  # the rows are no multiples of the interval
    Piece(0.777, -2.0, 3, True, TORQUE),
    Piece(1.011, -2.0, 2, False, SPEED),
    Piece(1.5, 2.0, 3, False, SPEED),
    Piece(1.7, 2.0, 3, False, TORQUE),
)


def closed_form(t: Floats) -> tuple[Floats, Floats]:
    """Angle and speed: in each piece J w' = torque - drag w."""
    phi, w = np.zeros_like(t), np.zeros_like(t)
    angle, speed = 0.0, 0.0
    ends = [*(piece.t for piece in PIECES[1:]), STOP + 1e-9]
    for piece, end in zip(PIECES, ends, strict=True):
        steady, rate = piece.torque / piece.drag, piece.drag / J
        inside = (t >= piece.t) & (t < end)
        for where, since in ((inside, t[inside] - piece.t), (None, end - piece.t)):
            fading = np.exp(-rate * since)
            now = steady + (speed - steady) * fading
            turned = angle + steady * since + (speed - steady) * (1 - fading) / rate
            if where is not None:
                phi[where], w[where] = turned, now
        angle, speed = float(turned), float(now)
    return phi, w


def columns() -> dict[str, tuple[list[float], list[float]]]:
    """Steps of real numbers are two rows of one time; those that are counted hold by themselves."""
    times = [PIECES[0].t, *(t for piece in PIECES[1:] for t in (piece.t, piece.t)), STOP]

    def doubled(values: list[float]) -> list[float]:
        return [value for value in values for _ in range(2)]

    names = ("u", "gear", "brake", "mode")
    return {name: (times, doubled([float(getattr(piece, name)) for piece in PIECES])) for name in names}


def table() -> Floats:
    given = columns()
    types = {"u": float, "gear": int, "brake": bool, "mode": int}
    rows = list(zip(given["u"][0], *(values for _, values in given.values()), strict=True))
    return np.array(rows, dtype=[("time", float), *((name, types[name]) for name in given)])


@cache
def events() -> tuple[tuple[float, str], ...]:
    motion = model(NAME).simulate(stop=STOP, interval=INTERVAL, tolerance=1e-10, inputs=columns())
    return tuple((event.time, event.name) for event in motion.events if "sample" not in event.name)


def test_lag_run() -> None:
    motion = model(NAME).simulate(stop=STOP, interval=INTERVAL, tolerance=1e-10, inputs=columns())
    phi, w = closed_form(motion.time)
    np.testing.assert_allclose(motion["phi"], phi, atol=1e-9)
    np.testing.assert_allclose(motion["der(phi)"], w, atol=1e-9)
    assert motion["shifts"][-1] == 2
    assert motion["pulses"][-1] == 40
    assert motion["does"][-1] == TORQUE
    assert (1.5, "gear == gears") in events()


@BOTH
@pytest.mark.parametrize(
    ("kind", "options"),
    [
        ("ModelExchange", {}),
        ("CoSimulation", {}),
        ("CoSimulation", {"use_event_mode": True, "early_return_allowed": True}),
    ],
)
def test_an_fmu_fed_by_fmpy(
    version: int, kind: str, options: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    if options and version == 2:
        pytest.skip("FMI 2 has no event mode in co-simulation")
    fmu = exported(NAME, version)
    rows = simulate_fmu(
        str(fmu.folder),
        validate=False,
        model_description=fmu.description,
        fmi_type=kind,
        stop_time=STOP,
        output_interval=INTERVAL,
        relative_tolerance=1e-10,
        input=table(),
        output=["phi", "der(phi)", "pulses", "does", "fast", "shifts"],
        **options,
    )
    capsys.readouterr()
    phi, w = closed_form(rows["time"])
    tolerance = 1e-7 if kind == "ModelExchange" else 1e-9
    np.testing.assert_allclose(rows["phi"], phi, atol=tolerance)
    np.testing.assert_allclose(rows["der(phi)"], w, atol=tolerance)
    assert rows["shifts"][-1] == 2
    assert rows["pulses"][-1] == 40
    assert rows["does"][-1] == TORQUE
    assert bool(rows["fast"][-1]) == (w[-1] > 2.5)


@BOTH
def test_conditions_on_them_are_no_event_indicators(version: int) -> None:
    """One is left: the speed against its limit."""
    with exchanged(exported(NAME, version)) as one:
        one.initialize()
        one.update()
        assert len(one.indicators) == 1


@BOTH
def test_values_that_they_have_are_accepted_at_any_time(version: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Others wait for event mode, and a warning says so, once."""
    with exchanged(exported(NAME, version)) as one:
        one.initialize({"gear": 2, "brake": False})
        one.update()
        for _ in range(3):
            one.move(0.01, np.array([0.0, 0.5, 0.0]))
            one.set({"gear": 2, "brake": False, "mode": TORQUE})
        assert capsys.readouterr().out == ""
        before = one.derivatives
        one.set({"gear": 3})
        one.set({"gear": 3, "brake": True})
        assert capsys.readouterr().out.count("gear keeps its value: it changes in event mode only") == 1
        np.testing.assert_array_equal(one.derivatives, before)
        assert one.get("gear") == 2
        one.raw.enterEventMode()
        one.set({"gear": 3})
        one.update()
        assert one.derivatives[1] == pytest.approx((STEP**2 - D * 0.5) / J, rel=1e-14)
        assert one.get("shifts") == 1


def refused(fmu: Exported, values: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> str:
    with slave(fmu) as one:
        with pytest.raises(FMICallException):
            one.set(values)
        one.initialize()  # it is as it was
        one.step(0.0, 0.1)
        assert one.get("gear") == 2
    return capsys.readouterr().out


@BOTH
def test_values_out_of_range_are_errors(version: int, capsys: pytest.CaptureFixture[str]) -> None:
    fmu = exported(NAME, version)
    assert "gear is from 1 to 3, not 4" in refused(fmu, {"gear": 4}, capsys)
    assert "mode is from 1 to 3, not 0" in refused(fmu, {"mode": 0}, capsys)


def test_one_call_sets_all_or_nothing() -> None:
    fmu = exported(NAME, 2)
    with slave(fmu) as one:
        with pytest.raises(FMICallException):
            one.raw.setInteger([fmu.variables[name].valueReference for name in ("gear", "mode")], [3, 0])
        assert one.get("gear") == 2


def test_step_mode_with_event_mode_takes_continuous_inputs_only(capsys: pytest.CaptureFixture[str]) -> None:
    with slave(exported(NAME, 3), event_mode_used=True) as one:
        one.initialize()
        one.raw.updateDiscreteStates()
        one.raw.enterStepMode()
        one.set({"u": 2.0, "gear": 2, "brake": False})
        with pytest.raises(FMICallException):
            one.set({"brake": True})
    assert "brake cannot change now: it is set at events" in capsys.readouterr().out
