"""FMPy with nothing given but the file, or a tolerance beside it, against `lag run`. The table of all models:

PYTHONPATH=tests python -m fmi.default_runs
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from fmpy import simulate_fmu
from fmpy.util import auto_interval
from models.corpus import MODELS, compiled
from shared_folder import make_shared_folder

import lagdsl
from fmi.exported import VERSIONS, exported
from fmi.motions import BESIDE, SAME_INSTANT, Floats, model, scales, signals

KINDS = ("ModelExchange", "CoSimulation")
TOLERANCES = (None, 1e-4)  # that of the experiment, and a coarse one
MOST_ROWS = 1000  # of FMPy, but for events; it has at least a tenth of that
SAME, AGREE = 1e-3, 5e-4  # of the range of a signal: to `lag run`, to the same importer at a finer tolerance


@dataclass(frozen=True)
class Judged:
    """Rows of FMPy away from events, as far as two of its tolerances agree."""

    until: float  # the end of that, as a part of the experiment
    error: float  # the largest up to there, in ranges of the signals
    worst: str
    whole: float  # the largest of all


def judged(name: str, version: int, kind: str, tolerance: float | None) -> Judged:
    truth = reference(name, kind)
    # A tenth of a coarse one may be as far away: CVODE at 1e-5 and at 1e-4 moves the pendulum alike.
    finer = compiled(name).flat.experiment.tolerance / 10 if tolerance is None else tolerance / 100
    expected = at_rows(truth, truth.time, {signal: truth[signal] for signal in signals(truth)})
    coarse, fine = (at_rows(truth, *run(name, version, kind, given)) for given in (tolerance, finer))
    away = away_from_events(truth) & ~np.isinf(coarse[:, 0]) & ~np.isinf(fine[:, 0])
    assert np.count_nonzero(away) >= MOST_ROWS / 10, "rows of FMPy are elsewhere"
    error, gap = (_distance(coarse, other, scales(truth)) for other in (expected, fine))
    off = np.flatnonzero(away & ~(np.max(gap, axis=1) <= AGREE))
    known = away & (np.arange(len(away)) < (off[0] if len(off) else len(away)))
    place = np.unravel_index(np.argmax(np.where(known[:, None], error, 0.0)), error.shape)
    until = float(np.count_nonzero(known) / np.count_nonzero(away))
    return Judged(until, float(error[place]), signals(truth)[place[1]], float(np.max(error[away])))


@cache
def reference(name: str, kind: str) -> lagdsl.Trajectory:
    """A motion with rows at the times of those of FMPy, without columns of protected variables."""
    flat = compiled(name).flat
    length = flat.experiment.stop_time - flat.experiment.start_time
    interval = auto_interval(length) if kind == "ModelExchange" else flat.experiment.interval or length / 500
    while kind == "CoSimulation" and length / interval > MOST_ROWS:
        interval *= 2
    found = model(name).simulate(interval=interval, tolerance=1e-10)
    hidden = {item.name for item in (*flat.outputs, *flat.events.discretes) if item.protected}
    return found.only([name for name in found.names if name not in hidden])


def run(name: str, version: int, kind: str, tolerance: float | None) -> tuple[Floats, dict[str, Floats]]:
    """Times of all rows, and the signals."""
    fmu = exported(name, version)
    names = signals(reference(name, kind))
    given = {} if tolerance is None else {"relative_tolerance": tolerance}
    wanted = sorted({fmu.entry(signal)[0].name for signal in names})
    rows = simulate_fmu(str(fmu.folder), validate=False, fmi_type=kind, output=wanted, **given)
    return rows["time"], fmu.columns(rows, names)


def at_rows(truth: lagdsl.Trajectory, time: Floats, columns: Mapping[str, Floats]) -> Floats:
    """(rows of `truth`, signals): the last row of a table at each of these times; infinite where it has none."""
    margin = SAME_INSTANT * (truth.time[-1] - truth.time[0])
    places = np.searchsorted(time, truth.time + margin) - 1
    values: Floats = np.stack([np.asarray(columns[name], dtype=float) for name in signals(truth)], axis=1)[places]
    values[np.abs(time[places] - truth.time) > margin] = np.inf
    return values


def away_from_events(truth: lagdsl.Trajectory) -> Floats:
    """Flags of rows. An event at which no signal jumps is as good as none: clocks may tick at every row."""
    values = np.stack([truth[signal] for signal in signals(truth)], axis=1).astype(float)
    length = truth.time[-1] - truth.time[0]
    jumps = np.max(_distance(values[1:], values[:-1], scales(truth)), axis=1) > AGREE
    events = truth.time[1:][jumps & (np.diff(truth.time) <= SAME_INSTANT * length)]
    flags: Floats = np.array([not np.any(np.abs(events - t) <= BESIDE * length) for t in truth.time])
    return flags


def _distance(found: Floats, expected: Floats, sizes: Floats) -> Floats:
    both_undefined = np.isnan(found) & np.isnan(expected)
    with np.errstate(invalid="ignore"):
        gap = np.abs(found - expected) / sizes
    return np.where(both_undefined, 0.0, np.where(np.isnan(gap), np.inf, gap))


def main() -> None:
    folder = make_shared_folder()
    for name in MODELS:
        for version in VERSIONS:
            for kind in KINDS:
                for tolerance in TOLERANCES:
                    try:
                        of = judged(name, version, kind, tolerance)
                        told = f"{of.error:.1e} ({of.worst}) up to {of.until:.3f}, {of.whole:.1e} in all"
                    except Exception as failure:  # the table goes on
                        told = f"FAILED: {failure}"
                    print(f"{name:40} {version} {kind:13} {tolerance or 'own':8} {told}", flush=True)
        reference.cache_clear()
    if folder is not None:
        folder.cleanup()


if __name__ == "__main__":
    main()
