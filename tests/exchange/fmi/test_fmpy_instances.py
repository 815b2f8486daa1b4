"""An instance in the hands of a master: state that can be saved and restored, other starts, neighbors in other
threads."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest
from choice import chosen, repeats
from fmpy.simulation import FMICallException

from fmi.exported import EVERY, SAMPLE, VERSIONS, exported, in_versions
from fmi.importing import Slave, exchanged, slave
from fmi.motions import SAME, Floats, deviation, model, motion, signals, span
from fmi.texts import exported_text

BOTH = pytest.mark.parametrize("version", VERSIONS)
STEPS = 12
TICKS = """model Ticks
  parameter Time T = 0.1 s, T0 = 0;
  discrete Integer n(start = 0);
  state Real z;
equation
  der(z) = 1/(1 s);
  when sample(T0, T) then
    n = pre(n) + 1;
  end when;
end Ticks;
"""
DISCARD = 2  # fmi2Discard, fmi3Discard
BUZZ = """model Buzz
  coordinate Length x(start = 1 mm);
  gravity = 0;
  mass 1 kg at {x, 0};
  potential 1/2*(1e12 N/m)*x^2;
end Buzz;
"""


FEW = ("four_bar", "newtons_cradle", "furuta_swing_up", "clutch", "van_der_pol")


def begun(instance: Slave, name: str, tolerance: float = 1e-8) -> tuple[tuple[str, ...], Floats]:
    """Initialized; all signals, and times of steps that differ in length."""
    start, stop, _ = span(name)
    instance.initialize(start=start, stop=stop, tolerance=tolerance)
    lengths = 1.0 + 0.7 * np.sin(np.arange(2 * STEPS))
    times = start + (stop - start) * np.concatenate([[0.0], np.cumsum(lengths) / np.sum(lengths)])
    return signals(motion(name)), times


@in_versions(chosen(EVERY, SAMPLE[::4]))
def test_a_state_taken_back_goes_on_with_the_same_bits(name: str, version: int) -> None:
    """In the same instance, and in another one that was somewhere else."""
    with slave(exported(name, version)) as one, slave(exported(name, version)) as other:
        names, times = begun(one, name)
        begun(other, name)
        first, rest = times[: STEPS + 1], times[STEPS:]
        one.rows(names, first)
        state = one.raw.getFMUState()
        data = one.raw.serializeFMUState(state)
        expected = one.rows(names, rest)
        one.raw.setFMUState(state)
        np.testing.assert_array_equal(one.rows(names, rest), expected)
        one.raw.setFMUState(state)  # as often as one likes
        assert one.serialized() == data
        np.testing.assert_array_equal(one.rows(names, rest), expected)
        one.raw.freeFMUState(state)
        other.restore(data)
        assert other.serialized() == data
        np.testing.assert_array_equal(other.rows(names, rest), expected)


@repeats("tests/motion/sessions/test_saved.py")
@in_versions(chosen(FEW, FEW[1:2]))
def test_a_state_goes_on_in_another_process_with_the_same_bits(name: str, version: int, tmp_path: Path) -> None:
    fmu = exported(name, version)
    with slave(fmu) as one:
        names, times = begun(one, name)
        middle, step = float(times[STEPS]), float(times[-1] - times[STEPS]) / STEPS
        one.rows(names, times[: STEPS + 1])
        (tmp_path / "state").write_bytes(one.serialized())
        expected = one.rows(names, middle + step * np.arange(STEPS + 1))
    script = [sys.executable, "-m", "fmi.continued", fmu.folder, tmp_path / "state", middle.hex(), step.hex(), STEPS]
    arguments = [str(argument) for argument in (*script, *names)]
    tests = Path(__file__).parents[1]
    child = subprocess.run(
        arguments, cwd=tests, env={"PYTHONPATH": f"{tests}:{tests.parent}"}, capture_output=True, text=True, check=False
    )
    assert child.returncode == 0, child.stderr
    found = [[float.fromhex(word) for word in line.split()] for line in child.stdout.splitlines()]
    np.testing.assert_array_equal(np.array(found), expected)


@in_versions(chosen(SAMPLE, SAMPLE[::3]))
def test_reset_is_a_new_instance(name: str, version: int) -> None:
    with slave(exported(name, version)) as one:
        names, times = begun(one, name)
        fresh = one.rows(names, times)
        one.raw.terminate()
        one.raw.reset()
        begun(one, name)
        np.testing.assert_array_equal(one.rows(names, times), fresh)
        one.raw.reset()  # from the middle of things, too
        begun(one, name)
        np.testing.assert_array_equal(one.rows(names, times), fresh)


@in_versions(chosen(SAMPLE, SAMPLE[::3]))
def test_instances_in_threads_do_not_know_of_each_other(name: str, version: int) -> None:
    """fmpy loads libraries in one thread only: it changes the folder of the process meanwhile."""
    fmu = exported(name, version)
    with ExitStack() as opened, ThreadPoolExecutor(4) as pool:
        alone, *others = (opened.enter_context(slave(fmu)) for _ in range(5))
        expected = alone.rows(*begun(alone, name))
        for rows in pool.map(lambda one: one.rows(*begun(one, name)), others):
            np.testing.assert_array_equal(rows, expected)


@in_versions(["double_pendulum", "four_bar", "bouncing_ball_modelica", "newtons_cradle"])
def test_what_does_not_know_the_time_does_the_same_at_another(name: str, version: int) -> None:
    later = 3.0
    with slave(exported(name, version)) as one:
        names, times = begun(one, name)
        expected = one.rows(names, times)
        one.raw.reset()
        one.initialize(start=later, stop=later + times[-1], tolerance=1e-8)
        found = one.rows(names, times + later)
    scale = np.maximum(np.ptp(expected, axis=0), 1e-3 * np.max(np.abs(expected)))
    np.testing.assert_array_less(np.max(np.abs(found - expected), axis=0) / scale, SAME)


@BOTH
def test_clocks_tick_at_their_own_times_when_one_starts_later(version: int) -> None:
    """furuta_swing_up samples every 5 ms from zero: a start between two ticks waits for the next."""
    with exchanged(exported("furuta_swing_up", version)) as one:
        one.initialize(start=0.0123)
        assert one.update() == pytest.approx(0.015, abs=1e-12)


@in_versions(["double_pendulum", "four_bar", "clutch", "chain"])
def test_lengths_of_communication_steps_do_not_matter(name: str, version: int) -> None:
    """A thousand short ones or a dozen long ones: the integrator keeps its own steps."""
    reference = motion(name)
    names = signals(reference)
    start, stop, _ = span(name)
    with slave(exported(name, version)) as one:
        for count in (1000, 10):
            one.initialize(start=start, stop=stop, tolerance=1e-8)
            times = np.linspace(start, stop, count + 1)
            rows = one.rows(names, times)
            off = deviation(reference, times, dict(zip(names, rows.T, strict=True)))
            assert len(off.time) >= 10
            assert not off.first(SAME, 1e-4), (count, off.first(SAME, 1e-4))
            one.raw.reset()


@BOTH
def test_parameters_and_starts_that_are_set_are_those_of_a_run(version: int) -> None:
    """Dependent values follow: the constraint of the four-bar linkage holds for other lengths, too."""
    name = "four_bar"
    fmu = exported(name, version)
    parameter = next(p for p in model(name).parameters if fmu.variables[p].causality == "parameter")
    value = 1.05 * float(model(name).defaults[model(name).parameters.index(parameter)])
    start, stop, interval = span(name)
    reference = model(name).simulate(stop=stop, interval=interval, tolerance=1e-8, parameters={parameter: value})
    assert np.max(np.abs(reference[signals(reference)[0]] - motion(name)[signals(reference)[0]])) > 1e-3
    with slave(fmu) as one:
        one.initialize({parameter: value}, start=start, stop=stop, tolerance=1e-8)
        assert one.get(parameter)[0] == value
        times = reference.time
        rows = one.rows(signals(reference), times)
    off = deviation(reference, times, dict(zip(signals(reference), rows.T, strict=True)))
    assert not off.first(SAME, 1e-4), off.first(SAME, 1e-4)


@repeats("tests/motion/simulate/test_failures.py")
@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
def test_a_step_of_too_many_steps_is_given_up(version: int) -> None:
    """An oscillation of 160 kHz, for a second."""
    with slave(exported_text(BUZZ, version)) as one:
        one.initialize(tolerance=1e-6)
        one.step(0.0, 1e-6)
        with pytest.raises(FMICallException) as failed:
            one.step(1e-6, 1.0)
    assert failed.value.status == DISCARD


@pytest.mark.parametrize("version", chosen(VERSIONS, [3]))
@pytest.mark.parametrize("strange", [{"T": 0.0}, {"T": -1.0}, {"T": -1e-300, "T0": -1.0}])
def test_a_clock_without_a_period_is_refused(version: int, strange: dict[str, float]) -> None:
    """Nothing waits for ticks that never come."""
    with slave(exported_text(TICKS, version)) as one, pytest.raises(FMICallException):
        one.initialize(strange)
    with slave(exported_text(TICKS, version)) as one:
        one.initialize({"T": 0.25, "T0": -0.1})
        one.step(0.0, 1.0)
        assert one.get("n")[0] == 4  # at 0.15 s, 0.4 s, 0.65 s, 0.9 s
