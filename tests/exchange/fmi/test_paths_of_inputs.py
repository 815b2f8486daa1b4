"""Inputs that prescribe positions: an importer that lets one jump, or leaves its derivatives out, is told so; one that
gives a smooth path gets the motion of the closed form."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from math import cos, pi, sin

import fmpy
import numpy as np
import pytest
from choice import chosen
from fmpy import simulate_fmu

from fmi.exported import VERSIONS, Exported, place
from fmi.importing import exchanged, slave
from fmi.texts import export_text

STOP, OMEGA, W = 1.0, 3.0, 7.0
INPUTS = ("road", "der(road)", "der(road,2)")
# A mass on a spring on a base that moves, and beside it one that a speed drives.
TEXT = """model Driven
  input Length road(smooth = 2);
  input Velocity pull(smooth = 1);
  coordinate Length x, s;
  gravity = 0;
  mass 1 kg at {x + road, 0};
  potential 1/2*9 N/m*x^2;
  kinetic 1/2*1 kg*der(s)^2;
  constraint drive: der(s) = pull;
  annotation(experiment(StopTime = 1, Tolerance = 1e-10));
end Driven;
"""
RESTING = """model Resting
  input Length road(smooth = 2);
  coordinate Length y;
  gravity = {0, -10 m/s2};
  mass 1 kg at {0, y};
  contact c: y >= road with restitution = 0;
  annotation(experiment(StopTime = 1, Tolerance = 1e-10));
end Resting;
"""
Path = Callable[[float], tuple[float, float, float]]


@cache
def driven(version: int) -> Exported:
    return unpacked(TEXT, f"driven{version}", version)


@cache
def resting() -> Exported:
    return unpacked(RESTING, "resting", 2)


def unpacked(text: str, name: str, version: int) -> Exported:
    path = place() / f"{name}.fmu"
    export_text(text, path, version)
    folder = path.with_suffix("")
    fmpy.extract(str(path), str(folder))
    return Exported(path, folder)


def sine(t: float) -> tuple[float, float, float]:
    return 0.1 * sin(W * t), 0.1 * W * cos(W * t), -0.1 * W**2 * sin(W * t)


def step_of(duration: float, height: float) -> Path:
    """A cycloid from 0.3 s on (VDI 2143)."""

    def path(t: float) -> tuple[float, float, float]:
        p = min(max((t - 0.3) / duration, 0.0), 1.0)
        turn = 2 * pi * p
        return (
            height * (p - sin(turn) / (2 * pi)),
            height / duration * (1 - cos(turn)) if 0 < p < 1 else 0.0,
            height / duration**2 * 2 * pi * sin(turn),
        )

    return path


def jump(t: float) -> tuple[float, float, float]:
    return (0.01 if t >= 0.5 else 0.0), 0.0, 0.0


def underived(t: float) -> tuple[float, float, float]:
    return sine(t)[0], 0.0, 0.0


def jump_on_the_way(t: float) -> tuple[float, float, float]:
    value, rate, acceleration = sine(t)
    return value + (0.01 if t >= 0.5 else 0.0), rate, acceleration


def exact(t: float) -> float:
    """x'' + 9 x = -road'' at rest, with the momentum of road'(0)."""
    amplitude = 0.1 * W**2 / (OMEGA**2 - W**2)
    return amplitude * sin(W * t) - (0.1 * W + W * amplitude) / OMEGA * sin(OMEGA * t)


def stepped(version: int, path: Path, count: int) -> float:
    with slave(driven(version)) as one:
        one.initialize(dict(zip(INPUTS, path(0.0), strict=True)) | {"der(x)": -path(0.0)[1]}, stop=STOP)
        for t, end in pairwise(np.linspace(0.0, STOP, count + 1)):
            one.set(dict(zip(INPUTS, path(t), strict=True)))
            one.step(float(t), float(end - t))
        return float(one.get("x")[0])


@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_a_smooth_path_at_communication_points(version: int) -> None:
    """Between them the input is a parabola, off by h^3/6 of the third derivative."""
    off = [abs(stepped(version, sine, count) - exact(STOP)) for count in (50, 200)]
    assert off[0] < 3e-4
    assert off[1] < off[0] / 12


@pytest.mark.parametrize("path", [sine, step_of(0.2, 0.05), step_of(0.031, 0.01)])
@pytest.mark.parametrize("count", [5, 37, 1000])
def test_smooth_paths_are_taken_at_any_points(path: Path, count: int) -> None:
    if path is not sine and count == 5:
        pytest.skip("a path that is over between two points is a jump")
    stepped(2, path, count)


@pytest.mark.parametrize("version", chosen(VERSIONS, [3]))
@pytest.mark.parametrize("path", [jump, underived, jump_on_the_way])
def test_a_jump_ends_the_step(version: int, path: Path) -> None:
    with pytest.raises(fmpy.fmi1.FMICallException):
        stepped(version, path, 1000)


def rows(path: Path, times: np.ndarray) -> np.ndarray:
    table = [(t, *path(t)) for t in times]
    return np.array(table, dtype=[("time", float), *((name, float) for name in INPUTS)])


def simulated(version: int, kind: str, table: np.ndarray) -> float:
    found = simulate_fmu(
        str(driven(version).path),
        fmi_type=kind,
        stop_time=STOP,
        output_interval=0.002,
        relative_tolerance=1e-9,
        input=table,
        start_values={name: table[name][0] for name in INPUTS} | {"der(x)": -table["der(road)"][0]},
        output=["x"],
    )
    return float(found["x"][-1])


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_a_table_of_values_and_derivatives(version: int, kind: str) -> None:
    """Straight lines between rows, of each for itself: an error of second order in their distance, and no jump."""
    for path in (sine, step_of(0.2, 0.05)):
        coarse, fine = (simulated(version, kind, rows(path, np.linspace(0.0, STOP, count))) for count in (101, 401))
        assert abs(coarse - fine) < 2e-3, path


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("version", chosen(VERSIONS, [3]))
def test_a_table_that_jumps(version: int, kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    """FMPy prints what it hears. Its library keeps a logger that is given beyond the life of it, and calls it."""
    times = np.array([0.0, 0.5, 0.5, STOP])
    table = rows(jump, times)
    table["road"][1] = 0.0
    with pytest.raises(fmpy.fmi1.FMICallException):
        simulated(version, kind, table)
    assert "the input road moves by more than its derivatives say" in capsys.readouterr().out


def test_a_table_without_derivatives() -> None:
    """In model exchange only jumps are judged."""
    table = rows(underived, np.linspace(0.0, STOP, 201))
    with pytest.raises(fmpy.fmi1.FMICallException):
        simulated(2, "CoSimulation", table)


@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_a_base_that_starts_to_move_is_a_blow(version: int) -> None:
    """The mass stays where it is: x' = -road'."""

    def ramp(t: float) -> tuple[float, float, float]:
        return max(0.0, t - 0.5), float(t >= 0.5), 0.0

    assert stepped(version, ramp, 10) == pytest.approx(-sin(1.5) / OMEGA, abs=1e-9)
    table = rows(ramp, np.array([0.0, 0.5, 0.5, STOP]))
    table["der(road)"][1] = 0.0
    for kind in ("ModelExchange", "CoSimulation"):
        assert simulated(version, kind, table) == pytest.approx(-sin(1.5) / OMEGA, abs=1e-8), kind


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_a_base_under_a_contact(speed: float) -> None:
    """It throws the mass up with its own speed, or leaves it to fall."""
    with slave(resting()) as one:
        one.initialize({}, stop=STOP)
        one.step(0.0, 0.5)
        one.set({"der(road)": speed})
        one.step(0.5, 0.1)
        exact = [0.1, 1.0] if speed > 0 else [-0.05, -1.0]
        assert one.get("y", "der(y)") == pytest.approx(exact, abs=1e-9)


def test_a_contact_on_a_smooth_path_stays_closed() -> None:
    """Accelerations of 4.9 m/s2 at most: less than gravity, so that the mass never leaves the base."""
    with slave(resting()) as one:
        one.initialize(dict(zip(INPUTS, sine(0.0), strict=True)) | {"der(y)": sine(0.0)[1]}, stop=STOP)
        for t, end in pairwise(np.linspace(0.0, STOP, 101)):
            one.set(dict(zip(INPUTS, sine(float(t)), strict=True)))
            one.step(float(t), float(end - t))
            assert one.get("c.closed", "c.impacts") == pytest.approx([1, 0])
        assert one.get("y") == pytest.approx([sine(STOP)[0]], abs=1e-4)


def test_a_speed_may_jump() -> None:
    """A blow: s goes at the new speed."""
    with slave(driven(3)) as one:
        one.initialize({"pull": 1.0}, stop=STOP)
        one.step(0.0, 0.5)
        one.set({"pull": 3.0})
        one.step(0.5, 0.5)
        assert one.get("s", "der(s)") == pytest.approx([2.0, 3.0], abs=1e-9)


def test_an_importer_that_lets_an_input_jump_in_event_mode() -> None:
    with exchanged(driven(3)) as one:
        one.initialize({}, stop=STOP)
        one.update()
        x = one.states
        one.move(0.25, x)
        one.raw.completedIntegratorStep()
        one.raw.enterEventMode()
        one.set({"road": 0.01})
        with pytest.raises(fmpy.fmi1.FMICallException):
            one.update()
