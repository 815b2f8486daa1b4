"""Random models with events and with friction: derivatives of motions equal differences of whole runs, or a name says
why there are none."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import pytest
from choice import ALL, EXPLORE
from fuzz.agreement import Floats
from fuzz.event_models import STOP, event_model
from fuzz.friction_models import friction_model

import lagdsl
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed

COUNT = 1000 if EXPLORE else 200
# In `make check`: a force that time switches, another event near an instant, a damper that lets go, sticking.
FEW = {event_model: (34, 50, 79), friction_model: (13,)}
TOLERANCE = 1e-12
NEAR = 1e-7  # of the largest derivative
# Steps of the differences, the longest one first along which the events of the motion stay in their order.
STEPS = (1e-3, 1e-4, 1e-5)
PLACES = (-2.0, -1.0, 1.0, 2.0)
# Of random motions this part may be so sensitive that differences keep no seven digits.
MOST_ROUGH = 0.05
GRAVITY = 9.81


@dataclass(frozen=True)
class Moved:
    """A random model, and the values at which its quantities stand."""

    model: lagdsl.Model
    values: dict[str, float]

    def motion(self, name: str, by: float, tangents: Sequence[str] = ()) -> Trajectory:
        quantity = name.removesuffix(".start")
        value = {quantity: self.values[name] + by}
        moved = {"parameters": value} if quantity == name else {"start": value}
        return self.model.simulate(tolerance=TOLERANCE, interval=0.1, tangents=tangents, **moved)  # type: ignore[arg-type]


def moved_model(text: str) -> Moved:
    """With gravity as a parameter; by this, and by the positions and rates at the start that no constraint ties."""
    text = re.sub(r"\b9\.81\b", "gravity_here", text)
    text = text.replace("\n", f"\n  parameter Real gravity_here = {GRAVITY};\n", 1)
    model = lagdsl.compile(text)
    tied = {
        name for constraint in re.findall(r"constraint (.*?);", text) for name in re.findall(r"[a-z]\d+", constraint)
    }
    names = [
        name for each in re.findall(r"coordinate Real ([^;]*);", text) for name in re.findall(r"\b[axyhb]\d+", each)
    ]
    first = model.simulate(stop=1e-6)
    starts = [each for name in dict.fromkeys(names) if name not in tied for each in (name, f"der({name})")]
    return Moved(model, {"gravity_here": GRAVITY, **{f"{name}.start": first[name][0] for name in starts}})


def events_of(motion: Trajectory) -> list[tuple[str, str]]:
    return [(event.kind, event.name) for event in motion.events]


def clear_times(motions: Sequence[Trajectory], near: float) -> Floats:
    """Times of the grid that no event of any of the motions comes near."""
    end = min(motion.time[-1] for motion in motions)
    events = np.array([event.time for motion in motions for event in motion.events if event.kind != "tick"])
    grid = np.linspace(0.0, STOP, 21)
    grid = grid[grid <= end + 1e-12]
    return grid[np.min(np.abs(grid[:, None] - events), axis=1) > near] if len(events) else grid


def at(motion: Trajectory, values: Floats, times: Floats) -> Floats:
    return values[np.searchsorted(motion.time, times + 1e-9) - 1]


def differences(moved: Moved, name: str, motion: Trajectory, step: float) -> tuple[float, float] | None:
    """The distances of the derivative from the difference of fourth order, and of that from the one of second order, as
    parts of the largest derivative. None: the motions have other events."""
    try:
        beside = [moved.motion(name, place * step) for place in PLACES]
    except SimulationFailed:
        return None
    times = clear_times([motion, *beside], 3.0 * step)
    if any(events_of(each) != events_of(motion) for each in beside) or not len(times):
        return None
    error, rough, largest = 0.0, 0.0, 1e-3
    for column in motion.columns:
        if column.kind in ("coordinate", "rate", "state"):
            a, b, c, d = (at(each, each[column.name], times) for each in beside)
            fourth = (8.0 * (c - b) - (d - a)) / (12.0 * step)
            derivative = at(motion, motion.derivative(column.name, name), times)
            error = max(error, float(np.abs(derivative - fourth).max()))
            rough = max(rough, float(np.abs(fourth - 0.5 * (c - b) / step).max()))
            largest = max(largest, float(np.abs(fourth).max()))
    return error / largest, rough / largest


def verdict(moved: Moved, name: str) -> str:
    """The name of the refusal; `same`; `rough`: differences do not tell; else how far the derivative is off."""
    try:
        motion = moved.motion(name, 0.0, tangents=[name])
    except SimulationFailed as failure:
        return failure.diagnostic.code
    found = [each for each in (differences(moved, name, motion, step) for step in STEPS) if each is not None]
    if not found:
        return "rough"
    error, rough = min(found)
    return "same" if error <= NEAR else "rough" if rough > NEAR else f"{error:.1e}"


@pytest.mark.parametrize("random_model", FEW, ids=lambda each: each.__name__)
def test_derivatives_of_random_motions(random_model: Callable[[int], str], capsys: pytest.CaptureFixture[str]) -> None:
    told: dict[str, str] = {}
    for seed in range(1, COUNT + 1) if ALL else FEW[random_model]:
        try:
            moved = moved_model(random_model(seed))
        except SimulationFailed as failure:  # of random starts some are beyond a contact
            told[f"{seed}"] = failure.diagnostic.code
            continue
        told |= {f"{seed} {name}": verdict(moved, name) for name in list(moved.values)[:4]}
    counts = Counter(told.values())
    with capsys.disabled():
        print(f"\n{random_model.__name__}: {dict(counts)}")
    known = {"same", "rough", "E0881", "E0882", "E0834"}
    assert {at: word for at, word in told.items() if word not in known} == {}
    assert counts["rough"] <= MOST_ROUGH * len(told)
    assert counts["same"] >= 0.7 * len(told)
