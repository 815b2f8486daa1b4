"""What says the same moves the same: every model of models/, with a stranger beside it, in other order, in a class."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from attack.awaited import STRANGERS
from attack.rows import FIRST
from properties.rewritten import Source, reordered, source, with_stranger, wrapped

import lagdsl
from lagdsl.api.trajectory import Trajectory

ROOT = Path(__file__).parents[2]
EXPLORE = bool(os.environ.get("LAGDSL_EXPLORE"))
NAMES = sorted(
    path.relative_to(ROOT / "models").with_suffix("").as_posix() for path in (ROOT / "models").rglob("*.lag")
)
CHOSEN = NAMES if EXPLORE else ["pendulum", "bouncing_ball", "clutch", "four_bar", "newtons_cradle"]
# Of a second; how far two motions of one model may be from each other, as a part of the range of a column: so much, or
# so many times what a motion is from itself at a tenth of the tolerance.
STOP, TOLERANCE, PART, FACTOR = 0.5, 1e-12, 1e-8, 10.0
SCALES = [1e-9, 1e-3, 1e3, 1e9]
Rewrite = Callable[[Source], str]


@cache
def original(name: str, tolerance: float) -> Trajectory:
    return moved(source(ROOT / "models" / f"{name}.lag").text, tolerance)


def moved(text: str, tolerance: float) -> Trajectory:
    model = lagdsl.compile(text, engine=FIRST)  # type: ignore[arg-type]
    return model.simulate(stop=STOP, interval=STOP / 20, tolerance=tolerance)


def assert_same(name: str, text: str, prefix: str = "") -> None:
    one, coarser, other = original(name, TOLERANCE), original(name, 10 * TOLERANCE), moved(text, TOLERANCE)
    happened = [(event.name, event.kind) for event in one.events if event.time < STOP * (1 - 1e-9)]
    again = [(event.name, event.kind) for event in other.events if event.time < STOP * (1 - 1e-9)]
    assert len(happened) == len(again)
    times = _clear(one, coarser, other)
    for column in one.columns:
        if column.kind not in ("coordinate", "rate", "state", "discrete"):
            continue
        named = f"der({prefix}{column.name[4:]}" if column.name.startswith("der(") else prefix + column.name
        values, near, found = (
            _at(m, n, times) for m, n in ((one, column.name), (coarser, column.name), (other, named))
        )
        span = max(1e-3, float(np.ptp(column.values)))
        limit = np.maximum(FACTOR * np.maximum.accumulate(np.abs(values - near)), PART * span)
        assert np.all(np.abs(values - found) <= limit), (column.name, float(np.max(np.abs(values - found) / limit)))


def _clear(*motions: Trajectory) -> np.ndarray:
    """Requested times that no event comes near."""
    times = np.linspace(0.0, STOP, 21)[1:-1]
    events = np.array([event.time for motion in motions for event in motion.events])
    near = np.min(np.abs(times[:, None] - events), axis=1) < 1e-6 if len(events) else np.zeros(len(times), dtype=bool)
    return times[~near]


def _at(motion: Trajectory, name: str, times: np.ndarray) -> np.ndarray:
    return motion[name][np.searchsorted(motion.time, times - 1e-9)]


@pytest.mark.parametrize("name", CHOSEN)
@pytest.mark.parametrize("rewrite", [reordered], ids=lambda f: f.__name__)
def test_other_order(name: str, rewrite: Rewrite) -> None:
    assert_same(name, rewrite(source(ROOT / "models" / f"{name}.lag")))


@pytest.mark.parametrize("name", CHOSEN)
def test_in_a_class(name: str) -> None:
    assert_same(name, wrapped(source(ROOT / "models" / f"{name}.lag")), prefix="inner.")


BESIDE = [
    (what, name, scale)
    for what in ("start", "rate", "mass")
    for name in (CHOSEN if EXPLORE else CHOSEN[:3])
    for scale in (SCALES if EXPLORE else [1e-9, 1e9])
    if (what, name, scale) not in STRANGERS or os.environ.get("LAGDSL_AWAITED")
]


@pytest.mark.parametrize(("what", "name", "scale"), BESIDE)
def test_beside_a_stranger(what: str, name: str, scale: float) -> None:
    values = {"start": 0.0, "rate": 1.0, "mass": 1.0} | {what: scale}
    assert_same(name, with_stranger(source(ROOT / "models" / f"{name}.lag"), **values))
