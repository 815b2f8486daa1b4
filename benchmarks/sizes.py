"""Whole runs in the size of the model: derivation, start values, motion with projection and events, memory."""

import resource
import subprocess
import time
from collections.abc import Callable

import ours
from measure import in_fresh_process

import lagdsl

# By model: what it is, the end of the motion [s], sizes.
FAMILIES: dict[str, tuple[str, float, tuple[int, ...]]] = {
    "four_bars": ("chain of four-bars", 0.5, (5, 10, 20, 40, 80, 160)),
    "iftomm_a02": ("row of four-bars with shared uprights", 0.5, (5, 10, 20, 40, 80)),
    "planar_chain": ("open chain", 0.5, (5, 10, 20, 40, 80, 160, 320)),
    "masses": ("masses in a row", 0.5, (5, 10, 20, 40, 80, 160, 320, 640)),
    "net": ("net of springs", 0.2, (5, 10, 20, 40)),
    "ladder": ("ladder of coils and capacitors", 5e-3, (5, 10, 20, 40, 80, 160, 320)),
    "balls": ("balls that bounce", 1.0, (5, 10, 20, 40, 80, 160)),
}
# Models with events: so long nothing happens [s].
BEFORE = {"balls": 0.15}
PIECES = 1500
RUNS = 3
PATIENCE = 60.0  # s of a process


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A curve for every model of FAMILIES, each size in a process of its own."""
    return {"runs": RUNS, "curves": {name: _curve(name, say) for name in FAMILIES}}


def _curve(name: str, say: Callable[[str], None]) -> list[dict[str, float]]:
    points: list[dict[str, float]] = []
    for n in FAMILIES[name][2]:
        say(f"sizes: {name} {n}")
        try:
            code = f"import json, sizes\nprint(json.dumps(sizes.one({name!r}, {n})))"
            points.append(dict(in_fresh_process(code, PATIENCE)))  # type: ignore[call-overload]
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            say(f"sizes: {name} {n} failed: {error}")
            break
    return points


def one(name: str, n: int) -> dict[str, float]:
    """CPU seconds of derivation, of start values and of the motion behind them; growth of the process's memory [MB].

    A model of the least size runs before: imports and what is read once do not count. The tape runs the functions, so
    that no compiler takes part.
    """
    stop = FAMILIES[name][1]
    _made(name, FAMILIES[name][2][0]).simulate(stop=stop, interval=stop / 100)
    before = _peak()
    start = time.process_time()
    model = _made(name, n)
    derived = time.process_time() - start
    first = _least(lambda: _anew(model).simulate(stop=1e-6 * stop, interval=1e-6 * stop))
    whole = _least(lambda: _anew(model).simulate(stop=stop, interval=stop / 100))
    motion = model.simulate(stop=stop, interval=stop / 100)
    found = {"n": n, "derive": derived, "start": first, "motion": max(whole - first, 0.0), "memory": _peak() - before}
    counts = {"steps": motion.statistics.steps, "evaluations": motion.statistics.evaluations}
    return {**found, **counts, **_events(name, model, len(motion.events), max(whole - first, 0.0))}


def _events(name: str, model: lagdsl.Model, events: int, motion: float) -> dict[str, float]:
    """Of a model with events: their number; CPU seconds of one, with its step, and of an evaluation in rk4."""
    if name not in BEFORE:
        return {}
    stop = BEFORE[name]
    still = _least(lambda: model.simulate(stop=stop / PIECES, interval=stop, solver="rk4", step=stop / PIECES))
    smooth = _least(lambda: model.simulate(stop=stop, interval=stop, solver="rk4", step=stop / PIECES))
    return {"events": events, "event": motion / events, "evaluation": (smooth - still) / (4 * PIECES)}


def _anew(model: lagdsl.Model) -> lagdsl.Model:
    """It searches for its start again."""
    model._engine.native.found.clear()
    return model


def _made(name: str, n: int) -> lagdsl.Model:
    return lagdsl.compile(ours.MODELS / f"{name}.lag", engine="tape", structural={"N": n})


def _least(work: Callable[[], object]) -> float:
    times = []
    for _ in range(RUNS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def _peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
