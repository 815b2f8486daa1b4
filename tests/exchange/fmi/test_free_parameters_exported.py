"""Exported models solve for their free parameters in initialization mode, against closed forms."""

from __future__ import annotations

import math
from collections.abc import Callable

import fmpy
import numpy as np
import pytest
from fmpy.simulation import FMICallException
from fmpy.validation import validate_fmu

import lagdsl
from fmi.exported import Exported, export_quickly
from fmi.importing import Instance, exchanged, slave
from lagdsl.exchange.fmi.variables.variables import Version

G = 9.80665
# A clock that beats as it should, and a coupler that is as long as a pose of its four-bar asks for.
TEXT = """
model Found
  parameter Length l(fixed = false, start = 0.5 m, max = 3 m);
  parameter Time period = 2 s;
  parameter Length twice = 2*l;
  coordinate Angle theta(start = 1 deg);
  gravity = -g_n*world.y;
  mass 1 kg at {l*sin(theta), -l*cos(theta)};

  parameter Length coupler(fixed = false, start = 2 m);
  parameter Angle rocker = 90 deg;
  coordinate Angle a(start = 60 deg, fixed = true), b(start = 100 deg);
  point A = {1*cos(a), 1*sin(a)}*(1 m);
  point B = {3 + 2*cos(b), 2*sin(b)}*(1 m);
  mass 1 kg at A;
  mass 1 kg at B;
  constraint rod: norm(B - A) = coupler;

  output Length reach = twice + coupler;
initial equation
  der(der(theta)) = -(2*pi/period)^2*sin(theta);
  b = rocker;
  annotation(experiment(StopTime = 1, Tolerance = 1e-9));
end Found;
"""
VERSIONS = pytest.mark.parametrize("version", [2, 3])
KINDS = pytest.mark.parametrize("opened", [exchanged, slave])


@pytest.fixture(scope="module")
def fmu(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Version], Exported]:
    folder = tmp_path_factory.mktemp("found")
    known: dict[int, Exported] = {}

    def made(version: Version) -> Exported:
        if version not in known:
            path, inside = folder / f"found{version}.fmu", folder / str(version)
            export_quickly(lagdsl.compile(TEXT)._compilation, path, version=version)
            fmpy.extract(str(path), str(inside))
            known[version] = Exported(path, inside)
        return known[version]

    return made


def length(period: float) -> float:
    return G * (period / (2.0 * math.pi)) ** 2


def coupler(rocker: float) -> float:
    return math.hypot(3.0 + 2.0 * math.cos(rocker) - 0.5, 2.0 * math.sin(rocker) - math.sqrt(0.75))


def enter(one: Instance) -> None:
    if one.fmu.version == 2:
        one.raw.setupExperiment(startTime=0.0)
    one.raw.enterInitializationMode()


@VERSIONS
def test_described_as_calculated_parameters(fmu: Callable[[Version], Exported], version: Version) -> None:
    one = fmu(version)
    assert validate_fmu(str(one.path)) == []
    found = one.variables["l"]
    assert (found.causality, found.variability, found.initial) == ("calculatedParameter", "fixed", "approx")
    assert float(found.start) == pytest.approx(length(2.0), rel=1e-9)
    assert (one.variables["twice"].causality, one.variables["twice"].initial) == ("calculatedParameter", "calculated")
    asked = {item.variable.name: {each.name for each in item.dependencies} for item in one.description.initialUnknowns}
    assert "period" in asked["l"] and "rocker" in asked["coupler"]


@VERSIONS
@KINDS
def test_found_with_what_is_set(fmu: Callable[[Version], Exported], version: Version, opened: Callable) -> None:
    with opened(fmu(version)) as one:
        one.set({"period": 1.0, "l": 0.1})  # the guess can be set, too
        enter(one)
        assert one.get("l")[0] == pytest.approx(length(1.0), rel=1e-9)
        one.set({"period": 3.0, "rocker": math.radians(80.0)})
        wanted = length(3.0), 2.0 * length(3.0), coupler(math.radians(80.0)), math.radians(80.0)
        assert one.get("l", "twice", "coupler", "b") == pytest.approx(wanted, rel=1e-9)
        assert one.get("reach")[0] == pytest.approx(wanted[1] + wanted[2], rel=1e-9)
        one.raw.exitInitializationMode()
        acceleration = -((2.0 * math.pi / 3.0) ** 2) * math.sin(math.radians(1.0))
        assert one.get("der(theta,2)")[0] == pytest.approx(acceleration, rel=1e-9)
        with pytest.raises(FMICallException):
            one.set({"l": 1.0})
        state = one.serialized()
    with opened(fmu(version)) as other:
        other.initialize()
        assert other.get("l")[0] == pytest.approx(length(2.0), rel=1e-9)
        other.restore(state)
        assert other.get("l")[0] == pytest.approx(length(3.0), rel=1e-9)
        assert other.get("der(theta,2)")[0] == pytest.approx(acceleration, rel=1e-9)


def test_small_oscillation_of_the_period_that_was_asked_for(fmu: Callable[[Version], Exported]) -> None:
    with slave(fmu(2)) as one:
        one.initialize({"period": 0.5}, tolerance=1e-10)
        one.step(0.0, 0.5)
        theta = math.radians(1.0)
        late = 0.5 * theta**2 / 16.0  # the period of a swing of this size is longer by so much
        assert one.get("theta", "der(theta)") == pytest.approx([theta, theta * (4.0 * math.pi) ** 2 * late], abs=1e-8)


@VERSIONS
def test_derivatives_in_initialization_mode(fmu: Callable[[Version], Exported], version: Version) -> None:
    with exchanged(fmu(version)) as one:
        enter(one)
        unknown = ["l", "twice", "reach", "coupler"]
        by_period = one.directional(unknown, ["period"], np.ones(1))
        slope = 2.0 * length(2.0) / 2.0
        assert by_period == pytest.approx([slope, 2.0 * slope, 2.0 * slope, 0.0], rel=1e-8, abs=1e-9)
        by_rocker = one.directional(unknown, ["rocker"], np.ones(1))
        angle, h = math.radians(90.0), 1e-4
        slope = (coupler(angle + h) - coupler(angle - h)) / (2.0 * h)
        assert by_rocker == pytest.approx([0.0, 0.0, slope, slope], rel=1e-6, abs=1e-9)


def test_beyond_its_bounds_it_is_refused(fmu: Callable[[Version], Exported]) -> None:
    with slave(fmu(2)) as one, pytest.raises(FMICallException):
        one.initialize({"period": 4.0})
