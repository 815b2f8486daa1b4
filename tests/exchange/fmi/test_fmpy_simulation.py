"""Exported models through fmpy, against `lag run --engine c`: its validator, both kinds, CVODE for model exchange."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from enum import IntEnum
from functools import partial
from typing import Any

import fmpy.sundials
import numpy as np
import pytest
from attack.rows import in_bounded_time
from choice import chosen
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu

from fmi.exported import EVERY, SAMPLE, VERSIONS, Exported, exported, in_versions
from fmi.motions import PREDICTABLE, Floats, deviation, difference, motion, scales, signals, span

MODELS_IN_VERSIONS = in_versions(chosen(EVERY, SAMPLE[::3]))


def simulated(fmu: Exported, name: str, kind: str, tolerance: float) -> Any:
    start, stop, interval = span(name)
    names = {fmu.entry(signal)[0].name for signal in signals(motion(name))}
    return simulate_fmu(
        str(fmu.folder),
        validate=False,
        model_description=fmu.description,
        fmi_type=kind,
        start_time=start,
        stop_time=stop,
        output_interval=interval,
        relative_tolerance=tolerance,
        output=sorted(names),
    )


class Method(IntEnum):
    """Of CVODE (sundials/cvode.h): fmpy knows the second only."""

    ADAMS = 1
    BDF = 2


@contextmanager
def cvode(method: Method) -> Iterator[None]:
    """fmpy takes BDF, and allows 500 steps between two rows."""
    original = fmpy.sundials.CVodeSolver
    fmpy.sundials.CVodeSolver, fmpy.sundials.CV_BDF = partial(original, maxNumSteps=100_000), method
    try:
        yield
    finally:
        fmpy.sundials.CVodeSolver, fmpy.sundials.CV_BDF = original, Method.BDF


@MODELS_IN_VERSIONS
def test_fmpy_finds_nothing_wrong(name: str, version: int) -> None:
    assert validate_fmu(str(exported(name, version).path)) == []


@MODELS_IN_VERSIONS
def test_co_simulation_is_the_same_motion(name: str, version: int) -> None:
    fmu = exported(name, version)
    rows = simulated(fmu, name, "CoSimulation", 1e-8)
    assert not difference(name, motion(name), rows["time"], fmu.columns(rows, signals(motion(name))))


@MODELS_IN_VERSIONS
def test_model_exchange_under_cvode_is_the_same_motion(name: str, version: int) -> None:
    """At 1e-10, by one of CVODE's two methods. A motion that multiplies disturbances is compared as far as CVODE at a
    tenth of the tolerance agrees with itself to 1e-7; on the whole its error has to vanish with the tolerance."""
    reference = motion(name, 1e-10)
    bdf = difference(name, reference, *under_cvode(name, version, Method.BDF, 1e-10))
    if not bdf:
        return
    time, columns = under_cvode(name, version, Method.ADAMS, 1e-10)
    adams = difference(name, reference, time, columns)
    if not adams:
        return
    until = agreement(name, time, columns, *under_cvode(name, version, Method.ADAMS, 1e-11))
    assert not difference(name, reference, time, columns, until), (bdf, adams)
    assert not difference(name, reference, *under_cvode(name, version, Method.ADAMS, 1e-12)), (bdf, adams)


def under_cvode(name: str, version: int, method: Method, tolerance: float) -> tuple[Floats, dict[str, Floats]]:
    """Times of the rows of the experiment, and the signals."""
    fmu = exported(name, version)
    with cvode(method):
        rows = simulated(fmu, name, "ModelExchange", tolerance)
    start, _, interval = span(name)
    steps = (rows["time"] - start) / interval
    regular = np.abs(steps - np.round(steps)) < 1e-6  # not those that fmpy adds at events
    last = regular & np.append(np.diff(rows["time"]) > 0, True)  # of several rows at an instant the one after the event
    columns = fmu.columns(rows, signals(motion(name, 1e-10)))
    return rows["time"][last], {n: c[last] for n, c in columns.items()}


def agreement(
    name: str, time: Floats, columns: dict[str, Floats], other_time: Floats, other_columns: dict[str, Floats]
) -> float:
    """Up to where two tables say the same."""
    np.testing.assert_allclose(time, other_time, rtol=1e-9)
    sizes = scales(motion(name, 1e-10))
    gaps = [np.abs(columns[n] - other_columns[n]) / size for n, size in zip(columns, sizes, strict=True)]
    (off,) = np.nonzero(np.max(gaps, axis=0) > PREDICTABLE)
    return float(time[off[0] - 1]) if len(off) else np.inf


@pytest.mark.parametrize("version", chosen(VERSIONS, [2]))
@pytest.mark.parametrize("method", chosen(Method, [Method.BDF]))
def test_bounces_below_the_importers_errors_come_to_rest(method: Method, version: int) -> None:
    """The last bounces of a valve are lower than what a tolerance allows positions to be wrong. The seat stays where it
    is, and away from events errors are some tolerances."""
    reference = motion("valve_train", 1e-10)
    for tolerance in (1e-6, 1e-8):
        time, columns = under_cvode("valve_train", version, method, tolerance)
        off = deviation(reference, time, columns, ("cam", "valve", "der(cam)", "der(valve)"))
        assert np.max(off.error[~off.near]) < 1e3 * tolerance
        assert np.min(columns["valve"]) > -tolerance


@pytest.mark.parametrize("version", chosen(VERSIONS, [3]))
@pytest.mark.parametrize("method", chosen(Method, [Method.BDF]))
def test_bounces_on_a_moving_base_end(method: Method, version: int) -> None:
    """A ball on a table that falls faster than the ball. Behind an impact CVODE begins anew with steps that lead
    downward, below the table: a search along the path found changes there that were none, without end."""
    name = "ball_on_moving_table"
    reference = motion(name, 1e-10)
    for tolerance in (1e-6, 1e-8, 1e-10):
        time, columns = in_bounded_time(partial(under_cvode, name, version, method, tolerance), 20)
        off = deviation(reference, time, columns, ("h", "der(h)"))
        assert np.max(off.error[~off.near]) < 1e3 * tolerance
