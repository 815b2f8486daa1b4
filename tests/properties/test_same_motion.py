"""Texts that say the same give the same motion: every model of models/, with a stranger beside it, in other order, by
other names, in a class, twice in one model, in a file of its own; with the stop or a tick where something happens.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from attack.rows import FIRST
from choice import EXPLORE, spread
from properties.rewritten import (
    Source,
    around,
    in_files,
    lighter,
    mass_of,
    names_of,
    renamed,
    reordered,
    source,
    twice,
    with_stranger,
    wrapped,
)

import lagdsl
from lagdsl.interfaces.api.trajectory import Trajectory

ROOT = Path(__file__).parents[2]
NAMES = sorted(
    path.relative_to(ROOT / "models").with_suffix("").as_posix() for path in (ROOT / "models").rglob("*.lag")
)
CHOSEN = NAMES if EXPLORE else ["pendulum", "bouncing_ball", "clutch", "four_bar", "newtons_cradle"]
FEW = NAMES if EXPLORE else ["pendulum", "bouncing_ball", "four_bar"]
# Nothing feeds the gear of a servo drive within another model: it is a constant there, and a clause that waits for it
# is an error (E0372).
ALONE = {"servo_drive"}
# Of a second; how far two motions of one model may be from each other, as a part of the range of a column: so much, or
# so many times what a motion is from itself at a tenth of the tolerance.
STOP, TOLERANCE, PART, FACTOR = 0.5, 1e-12, 1e-8, 10.0
SCALES = [1e-9, 1e-3, 1e3, 1e9]
Rewrite = Callable[[Source], str]


@cache
def original(name: str, tolerance: float) -> Trajectory:
    return moved(source(ROOT / "models" / f"{name}.lag").text, tolerance)


def moved(text: str, tolerance: float) -> Trajectory:
    return one_motion(text, STOP, tolerance)


def one_motion(text: str, stop: float, tolerance: float = TOLERANCE) -> Trajectory:
    model = lagdsl.compile(text, engine=FIRST)  # type: ignore[arg-type]
    return model.simulate(stop=stop, interval=STOP / 20, tolerance=tolerance)


def assert_same(name: str, text: str, prefix: str = "") -> None:
    other = moved(text, TOLERANCE)
    assert _kinds(original(name, TOLERANCE), STOP) == _kinds(other, STOP)
    assert_columns(original(name, TOLERANCE), original(name, 10 * TOLERANCE), other, prefix)


def assert_columns(
    one: Trajectory,
    coarser: Trajectory,
    other: Trajectory,
    prefix: str = "",
    names: Mapping[str, str] = MappingProxyType({}),
    until: float = STOP,
) -> None:
    """`other` moves like `one`, whose error `coarser` shows; its names have a prefix, or are others."""
    times = _clear(one, coarser, other)
    times = times[times < until - 1e-6]
    for column in one.columns:
        if column.kind not in ("coordinate", "rate", "state", "discrete"):
            continue
        named = _renamed(column.name, prefix, names)
        values, near, found = (
            _at(m, n, times) for m, n in ((one, column.name), (coarser, column.name), (other, named))
        )
        span = max(1e-3, float(np.ptp(column.values)))
        limit = np.maximum(FACTOR * np.maximum.accumulate(np.abs(values - near)), PART * span)
        assert np.all(np.abs(values - found) <= limit), (column.name, float(np.max(np.abs(values - found) / limit)))


def _renamed(name: str, prefix: str, names: Mapping[str, str]) -> str:
    inner = name[4:-1] if name.startswith("der(") else name
    stem, bracket, index = inner.partition("[")
    inner = f"{prefix}{names.get(stem, stem)}{bracket}{index}"
    return f"der({inner})" if name.startswith("der(") else inner


def _kinds(motion: Trajectory, until: float, beside: str = "nothing") -> Counter[str]:
    """Events before a time, by kind, but for `beside`; names hold those of coordinates, which may be others."""
    return Counter(e.kind for e in motion.events if e.time < until * (1 - 1e-9) and not e.name.startswith(beside))


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


@pytest.mark.parametrize("name", [name for name in CHOSEN if name not in ALONE])
def test_in_a_class(name: str) -> None:
    assert_same(name, wrapped(source(ROOT / "models" / f"{name}.lag")), prefix="inner.")


@pytest.mark.parametrize("name", FEW)
def test_by_other_names(name: str) -> None:
    s = source(ROOT / "models" / f"{name}.lag")
    other = moved(renamed(s, "_other"), TOLERANCE)
    assert _kinds(original(name, TOLERANCE), STOP) == _kinds(other, STOP)
    assert_columns(
        original(name, TOLERANCE), original(name, 10 * TOLERANCE), other, names={n: f"{n}_other" for n in names_of(s)}
    )


@pytest.mark.parametrize("name", [name for name in FEW if name not in ALONE])
def test_in_another_file(name: str, tmp_path: Path) -> None:
    s = source(ROOT / "models" / f"{name}.lag")
    for file, text in in_files(s).items():
        (tmp_path / file).write_text(text)
    (tmp_path / "around.lag").write_text(f"import {s.model.name};\n{around(s)}")
    model = lagdsl.compile(tmp_path / "around.lag", engine=FIRST)  # type: ignore[arg-type]
    other = model.simulate(stop=STOP, interval=STOP / 20, tolerance=TOLERANCE)
    assert_columns(original(name, TOLERANCE), original(name, 10 * TOLERANCE), other, prefix="inner.")


@pytest.mark.parametrize("name", [name for name in FEW if name not in ALONE])
def test_twice_with_different_values(name: str) -> None:
    """Two instances in one model, of which one has another mass: each moves as it does alone."""
    s = source(ROOT / "models" / f"{name}.lag")
    mass = mass_of(s)
    both = moved(twice(s, mass), TOLERANCE)
    assert_columns(original(name, TOLERANCE), original(name, 10 * TOLERANCE), both, prefix="inner.")
    if mass is not None:
        one, coarser = (moved(lighter(s, mass), tolerance) for tolerance in (TOLERANCE, 10 * TOLERANCE))
        assert_columns(one, coarser, both, prefix="other.")


# Times of events, one a model: the first that is neither at the start nor a tick.
HAPPENING = NAMES if EXPLORE else ["bouncing_ball", "escapement", "valve_train"]


def _first(name: str) -> float | None:
    events = (e for e in original(name, TOLERANCE).events if 1e-3 < e.time < STOP * (1 - 1e-6) and e.kind != "tick")
    return next((event.time for event in events), None)


@pytest.mark.parametrize("name", HAPPENING)
def test_stop_where_something_happens(name: str) -> None:
    at = _first(name)
    if at is None:
        pytest.skip("nothing happens")
    one = original(name, TOLERANCE)
    for stop in (at, float(np.nextafter(at, 0)), float(np.nextafter(at, 1)), at * (1 + 1e-12), at * (1 - 1e-12)):
        other = one_motion(source(ROOT / "models" / f"{name}.lag").text, stop)
        assert _kinds(one, at - 1e-6) == _kinds(other, at - 1e-6)
        assert_columns(one, original(name, 10 * TOLERANCE), other, until=at)
        for column in (c for c in one.columns if c.kind == "coordinate"):
            there = column.values[np.searchsorted(one.time, at - 1e-12)]
            span = max(1e-3, float(np.ptp(column.values)))
            assert abs(other[column.name][-1] - there) <= 1e-7 * span, column.name


@pytest.mark.parametrize("name", HAPPENING)
def test_tick_where_something_happens(name: str) -> None:
    at = _first(name)
    if at is None:
        pytest.skip("nothing happens")
    tick = f"sample({at!r}, 1000)"
    s = source(ROOT / "models" / f"{name}.lag")
    clause = f"equation\n  when {tick} then ticks = pre(ticks) + 1; end when;\n"
    other = moved(s.text + around(s, "  discrete Integer ticks(start = 0);\n", clause), TOLERANCE)
    assert other["ticks"][-1] == 1
    assert _kinds(original(name, TOLERANCE), STOP) == _kinds(other, STOP, tick[:12])
    assert_columns(original(name, TOLERANCE), original(name, 10 * TOLERANCE), other, prefix="inner.")


BESIDE = [
    (what, name, scale)
    for what in ("start", "rate", "mass")
    for name in (CHOSEN if EXPLORE else CHOSEN[:3])
    for scale in (SCALES if EXPLORE else [1e-9, 1e9])
]
if not EXPLORE:  # the stranger sets no pace at a singular start
    BESIDE += [("start", "parallelogram", 1e-9), ("rate", "parallelogram", 1e9)]
    BESIDE += [("rate", "newtons_cradle", 1e9)]  # contacts without force, which stay closed


@pytest.mark.parametrize(("what", "name", "scale"), spread(BESIDE, 6))
def test_beside_a_stranger(what: str, name: str, scale: float) -> None:
    values = {"start": 0.0, "rate": 1.0, "mass": 1.0} | {what: scale}
    assert_same(name, with_stranger(source(ROOT / "models" / f"{name}.lag"), **values))
