"""Clocks of FMI 3: their intervals, the instants at which they may be set, and the same motion whether importers set
them or not."""

from __future__ import annotations

from ctypes import byref, c_bool, c_double, c_int, c_uint32

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

import lagdsl
from fmi.described import of_text, table_of, tree
from fmi.importing import Slave, exchanged, slave
from fmi.texts import exported_text
from lagdsl.exchange.fmi.variables.ports import Ports

TEXT = """model Sampled
  parameter Time h = 0.1 s;
  coordinate Length x(start = 1 m);
  discrete Real held, slow;
  mass 1 kg at {x, 0};
  gravity = 0;
  force -(1 N/m)*x - held*(1 N) on x;
equation
  when sample(0.05 s, h) then
    held = x/(1 m);
  end when;
  when sample(-1 s, 0.4 s) then
    slow = pre(slow) + 1;
  end when;
  output Length y = x;
  annotation(experiment(StopTime = 1, Tolerance = 1e-9));
end Sampled;
"""
NAMES = ("clock.sample1", "clock.sample2")


def references(one: Slave) -> list[int]:
    return [one.fmu.variables[name].valueReference for name in NAMES]


def intervals(one: Slave) -> tuple[list[float], list[int], list[float]]:
    """Periods with their qualifiers, and shifts."""
    clocks = (c_uint32 * 2)(*references(one))
    periods, shifts, qualifiers = (c_double * 2)(), (c_double * 2)(), (c_int * 2)()
    one.raw.fmi3GetIntervalDecimal(one.raw.component, clocks, 2, periods, qualifiers)
    one.raw.fmi3GetShiftDecimal(one.raw.component, clocks, 2, shifts)
    return list(periods), list(qualifiers), list(shifts)


def activate(one: Slave, name: str) -> None:
    clock = c_uint32(one.fmu.variables[name].valueReference)
    one.raw.fmi3SetClock(one.raw.component, byref(clock), 1, byref(c_bool(True)))


def test_the_description_has_periods_that_no_parameter_changes() -> None:
    described = [
        dict(clock.attrib) for clock in tree(table_of(of_text(TEXT), 3, ports=Ports(clocks=True))).iter("Clock")
    ]
    assert [(c["intervalVariability"], c.get("intervalDecimal"), c.get("shiftDecimal")) for c in described] == [
        ("fixed", None, None),
        ("constant", "0.4", "0.2"),
    ]
    assert described[0]["description"] == "sample(0.05 s, h)"
    for version, ports in ((2, Ports(clocks=True)), (3, Ports())):
        assert not list(tree(table_of(of_text(TEXT), version, ports=ports)).iter("Clock"))


@pytest.mark.parametrize(("start", "h", "shifts"), [(0.0, 0.1, [0.05, 0.2]), (0.3, 0.25, [0.0, 0.3])])
def test_intervals_follow_the_parameters_and_the_start(start: float, h: float, shifts: list[float]) -> None:
    unchanged, changed = 1, 2
    with slave(exported_text(TEXT, 3, clocks=True), event_mode_used=True) as one:
        one.set({"h": h})
        one.raw.enterInitializationMode(startTime=start)
        periods, qualifiers, found = intervals(one)
        assert periods == [h, 0.4]
        assert found == pytest.approx(shifts, abs=1e-15)
        assert qualifiers == [changed, unchanged]
        one.raw.exitInitializationMode()
        periods, qualifiers, found = intervals(one)
        assert (periods, qualifiers) == ([h, 0.4], [unchanged, unchanged])
        assert found == pytest.approx(shifts, abs=1e-15)


def motion(set_clocks: bool) -> list[float]:
    """Of an importer that steps from tick to tick."""
    ticks = sorted([*(round(0.05 + 0.1 * k, 12) for k in range(10)), 0.2, 0.6, 1.0])
    rows = []
    with slave(exported_text(TEXT, 3, clocks=True), event_mode_used=True) as one:
        one.raw.enterInitializationMode(tolerance=1e-10, startTime=0.0)
        one.raw.exitInitializationMode()
        t = 0.0
        for tick in ticks:
            one.raw.updateDiscreteStates()
            one.raw.enterStepMode()
            one.raw.doStep(t, tick - t)
            one.raw.enterEventMode()
            if set_clocks:
                activate(one, NAMES[1] if tick in (0.2, 0.6, 1.0) else NAMES[0])
            one.raw.updateDiscreteStates()
            rows += one.get("x", "held", "slow").tolist()
            t = tick
    return rows


def test_the_same_motion_for_importers_with_and_without_clocks() -> None:
    assert motion(True) == motion(False)
    own = lagdsl.compile(TEXT, engine="tape").simulate(stop=1.0, interval=0.05, tolerance=1e-10)
    x, held, slow = motion(True)[-3:]
    assert x == pytest.approx(own["x"][-1], abs=1e-8)
    assert held == pytest.approx(own["held"][-1], abs=1e-8)
    assert slow == own["slow"][-1] == 3


def test_a_clock_is_set_where_it_ticks_and_nowhere_else(capsys: pytest.CaptureFixture[str]) -> None:
    with exchanged(exported_text(TEXT, 3, clocks=True)) as one:
        one.initialize()
        clock = c_uint32(one.fmu.variables[NAMES[0]].valueReference)
        with pytest.raises(FMICallException):
            one.raw.fmi3SetClock(one.raw.component, byref(clock), 1, byref(c_bool(True)))
        assert "the clock does not tick at 0 s, but at 0.05 s" in capsys.readouterr().out
    with exchanged(exported_text(TEXT, 3, clocks=True)) as one:
        one.initialize()
        assert one.update() == pytest.approx(0.05)
        one.move(0.05, np.array([1.0, 0.0]))
        with pytest.raises(FMICallException):  # continuous-time mode
            one.raw.fmi3SetClock(one.raw.component, byref(clock), 1, byref(c_bool(True)))
    with exchanged(exported_text(TEXT, 3, clocks=True)) as one:
        one.initialize()
        one.update()
        one.move(0.05, np.array([0.75, 0.0]))
        one.raw.enterEventMode()
        one.raw.fmi3SetClock(one.raw.component, byref(clock), 1, byref(c_bool(True)))
        assert one.update() == pytest.approx(0.15)
        assert one.get("held") == 0.75
    with slave(exported_text(TEXT, 3, clocks=True)) as two:
        two.initialize()
        wrong = c_uint32(two.fmu.variables["x"].valueReference)
        with pytest.raises(FMICallException):
            two.raw.fmi3GetClock(two.raw.component, byref(wrong), 1, byref(c_bool()))
        assert "x is a real number, not a clock" in capsys.readouterr().out
