"""An engine against the independent formulation of `oracle`: one motion, or the event on which both hinge."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Literal

import numpy as np
from compiled_programs import program_of
from fuzz.agreement import FACTOR, INSTANT, HangError, Report, Run, limited, run
from numpy.typing import NDArray
from stepping.events import Happening, UnsettledError
from stepping.friction_instant import JammedError
from stepping.friction_modes import AmbiguousError
from stepping.friction_motion import friction_motion
from stepping.motion import Motion, motion

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

Floats = NDArray[np.float64]
Kind = Literal["impact", "closed", "opened", "tick"]

Scales = Mapping[str, float]
# Sizes of coordinates by their names; of those that have none here it is 1.
ONE: Scales = MappingProxyType({})

TOLERANCE = 1e-10
# Kinds of events that both tell by one name. An oracle that knows of corners only may locate other relations.
TOLD = ("impact", "closed", "opened", "tick", "slips", "sticks", "reverses")
# Nearer to each other than this events crowd.
CROWDED = 1e-5
# States may differ by so many times what the engine differs from itself, or by this part of the range.
PART = 1e-7
# Seconds of the processor for the oracle: 340 bounces of a plank that comes to rest take it half of them.
PATIENCE = 60


def compare(text: str, engine: EngineName, stop: float, known: Sequence[float] = (), scales: Scales = ONE) -> Report:
    """`known` are instants at which the integration of the oracle begins anew."""
    model = lagdsl.compile(text, engine=engine)
    try:
        found, finer = run(model, TOLERANCE), run(model, 0.1 * TOLERANCE)
    except HangError:
        return Report("hang", engine)
    if found.code == "E0834":  # two mechanisms drawn into each other
        return Report("same", "refused")
    if found.code not in (None, "E0833", "E0804"):
        return Report("differs", f"ends with {found.code}")
    times = found.motion.time[:: max(1, len(found.motion.time) // 40)]
    try:
        with limited(PATIENCE):
            oracle = motion(program_of(text), stop, np.unique(times), known, min([1.0, *scales.values()]))
    except HangError:
        return Report("hang", "oracle")
    except UnsettledError as unsettled:
        # A force that reverses at every crossing: there is no motion beyond it, and both say so at one instant.
        alike = found.code in ("E0804", "E0833") and abs(unsettled.time - found.end) < INSTANT
        return (
            Report("same", "refused") if alike else Report("differs", f"{found.code} at {found.end:.9g}: {unsettled}")
        )
    if found.code == "E0804":
        return Report("differs", f"ends with E0804 at {found.end:.9g}")
    if found.code is None:
        return _judged(found, finer, oracle, scales)
    # Resets whose times are a geometric series: the model says nothing beyond its sum, and the run ends there.
    if not _accumulate(oracle.instants, found.end):
        return Report("differs", f"ends with E0833 at {found.end:.9g}")
    return _judged(found, finer, _until(oracle, found.end - CROWDED), scales)


def compare_friction(text: str, engine: EngineName, stop: float) -> Report:
    """With the oracle that tries all modes of contacts and dry friction."""
    model = lagdsl.compile(text, engine=engine)
    try:
        found, finer = run(model, TOLERANCE), run(model, 0.1 * TOLERANCE)
    except HangError:
        return Report("hang", engine)
    times = found.motion.time[:: max(1, len(found.motion.time) // 40)]
    try:
        with limited(PATIENCE):
            oracle = friction_motion(program_of(text), stop, np.unique(times).tolist())
    except HangError:
        return Report("hang", "oracle")
    except AmbiguousError as several:
        return Report("grazing", str(several))
    except JammedError as jammed:
        alike = found.code is not None and abs(found.end - jammed.time) < 1e-3 * stop
        return Report("same", "refused") if alike else Report("differs", f"{found.code} at {found.end:.9g}: {jammed}")
    if found.code is not None:
        return Report("differs", f"ends with {found.code} at {found.end:.9g}")
    return _judged(found, finer, oracle, ONE)


def _accumulate(instants: Sequence[float], end: float) -> bool:
    """True if the last six times before the end become denser, and the end lies before the sum of their series."""
    times = np.array([t for t in instants if t <= end])[-6:]
    gaps = np.diff(times)
    if len(gaps) < 5 or not np.all(np.diff(gaps) < 0):
        return False
    ratio = gaps[-1] / gaps[-2]
    return bool(end - times[-1] < gaps[-1] * ratio / (1 - ratio))


def _until(oracle: Motion, end: float) -> Motion:
    count = int(np.searchsorted(oracle.times, end))
    told = [each for each in oracle.told if each.time < end]
    return replace(oracle, times=oracle.times[:count], states=oracle.states[:count], told=told)


def _judged(found: Run, finer: Run, oracle: Motion, scales: Scales) -> Report:
    parting, why = _parting(found, _of_interest(oracle.told))
    own, hinge = _parting(finer, _told(found))
    times, wrong, value = _wrong(found, finer, oracle, scales)
    first = min(parting, float(times[wrong[0]]) if len(wrong) else np.inf)
    if first == np.inf:
        return Report("same")
    if own <= first + INSTANT:
        return Report("grazing", f"t = {own:.6g}: {hinge}")
    return Report("differs", why if parting <= first else f"t = {first:.6g}: {value}")


def _told(run: Run) -> list[tuple[float, str, str]]:
    return _of_interest([Happening(event.time, event.name, event.kind) for event in run.motion.events])


def _of_interest(told: Sequence[Happening]) -> list[tuple[float, str, str]]:
    """Names that both tell behind the start. A contact that strikes, closes or opens says of the friction under it that
    it begins or ends."""
    own = [each for each in told if each.kind in TOLD and each.time > 0]
    of_contacts = [(each.time, each.name) for each in own if each.kind in ("impact", "closed", "opened")]

    def follows(each: Happening) -> bool:
        contact = each.name.removesuffix(".friction")
        return contact != each.name and any(
            name == contact and abs(time - each.time) < CROWDED for time, name in of_contacts
        )

    return [(each.time, each.name, each.kind) for each in own if not follows(each)]


def _parting(run: Run, others: list[tuple[float, str, str]]) -> tuple[float, str]:
    """When events begin to be others."""
    mine = _told(run)
    left, right = _instants(mine), _instants(others)
    for (t, events), (s, named) in zip(left, right, strict=False):
        if events != named or abs(t - s) > 1e-5:
            return min(t, s), f"{events} at {t:.9g} and {named} at {s:.9g}"
    if len(left) != len(right):
        t, events = (left if len(left) > len(right) else right)[min(len(left), len(right))]
        return t, f"{events} at {t:.9g} in one only"
    return np.inf, ""


def _instants(events: list[tuple[float, str, str]]) -> list[tuple[float, list[tuple[str, str]]]]:
    """Events by instant; bounces that crowd before a contact rests, and their end that is told, are one."""
    found: list[tuple[float, list[tuple[str, str]]]] = []
    last = -np.inf
    for time, name, kind in events:
        if time - last > CROWDED:
            found.append((time, []))
        last = time
        found[-1][1].append((name, kind))
    return [(t, _named(names)) for t, names in found]


def _named(names: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """If several contacts strike at once, the order of their blows tells what each of them is called; the rates
    after it tell whether that was right."""
    contacts = sorted({name for name, kind in names if kind != "tick"})
    if len(names) < 2:
        return names
    return sorted([*((name, kind) for name, kind in names if kind == "tick"), *((name, "struck") for name in contacts)])


def _wrong(found: Run, finer: Run, oracle: Motion, scales: Scales) -> tuple[Floats, NDArray[np.intp], str]:
    """Rows of the oracle that no event comes near, and which of them differ."""
    names = [c.name for c in found.motion.columns if c.kind in ("coordinate", "rate", "state")]
    happened = np.array([*(each.time for each in found.motion.events), *oracle.instants, np.inf])
    keep = [k for k, t in enumerate(oracle.times) if np.min(np.abs(happened - t)) > 1e-6]
    times = np.array([oracle.times[k] for k in keep])
    if not len(times):
        return times, np.zeros(0, dtype=np.intp), ""
    exact = np.array([oracle.states[k].x for k in keep])
    rows, other = (_columns(each, names, times) for each in (found, finer))
    order = _order(found, names)
    own = np.array([scales.get(name.removeprefix("der(").removesuffix(")"), 1.0) for name in names])
    span = np.maximum(np.max(np.abs(exact), axis=0)[order], 1e-6 * own)
    departure = np.maximum.accumulate(np.abs(rows - other), axis=0)
    limit = np.maximum(FACTOR * departure, PART * span)
    beyond = np.abs(rows - exact[:, order]) > limit
    wrong = np.flatnonzero(np.any(beyond, axis=1))
    if not len(wrong):
        return times, wrong, ""
    row, column = int(wrong[0]), int(np.argmax(beyond[wrong[0]]))
    return times, wrong, f"{names[column]} is {rows[row, column]:.12g}, exact {exact[row, order[column]]:.12g}"


def _columns(run: Run, names: Sequence[str], times: Floats) -> Floats:
    at = np.searchsorted(run.motion.time, times).clip(max=len(run.motion.time) - 1)
    return np.column_stack([run.motion[name][at] for name in names])


def _order(run: Run, names: Sequence[str]) -> list[int]:
    """Place of each column in (q, qd, z)."""
    kinds = {c.name: c.kind for c in run.motion.columns}
    q = [name for name in names if kinds[name] == "coordinate"]
    z = [name for name in names if kinds[name] == "state"]
    place = {name: i for i, name in enumerate((*q, *(f"der({name})" for name in q), *z))}
    return [place[name] for name in names]
