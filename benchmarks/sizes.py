"""Whole runs in the size of the model: derivation, start values, motion with projection and events, memory."""

import resource
import subprocess
import time
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import ours
from measure import children_cpu_seconds, in_fresh_process

import lagdsl


class Family(NamedTuple):
    """A model, the end of its motion [s], and its sizes, the last of which are ten times the largest that is
    in use; `parts` is what costs should be proportional to, `unit` its name."""

    title: str
    stop: float
    sizes: tuple[int, ...]
    parts: Callable[[int], int] = lambda n: n
    unit: str = "N"


FAMILIES: dict[str, Family] = {
    "iftomm_a02": Family("row of four-bars with shared uprights", 0.5, (5, 10, 20, 40, 80, 160, 320)),
    "masses": Family("masses in a row", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1280)),
    "net": Family("net of springs", 0.2, (5, 10, 20, 40, 80, 160)),
    "reissner": Family("beam with shear", 0.01, (16, 32, 64, 128, 256, 512, 1024, 2560)),
    "ladder": Family("ladder of coils and capacitors", 5e-3, (5, 10, 20, 40, 80, 160, 320, 640, 1600)),
    "oscillators": Family("masses on springs of their own", 1.0, (5, 50, 500, 1000, 2000, 4000)),
    "nbody": Family(
        "bodies that attract each other", 0.05, (5, 10, 20, 40, 80, 160), lambda n: n * (n - 1) // 2, "pairs"
    ),
    "balls": Family("balls that bounce", 1.0, (5, 10, 20, 40, 80, 160, 400, 800, 1600)),
    "resting": Family("balls at rest on a floor", 0.1, (5, 10, 20, 40, 80, 200, 400, 800, 1600)),
    "stack": Family("blocks at rest, one on another", 0.1, (5, 10, 20, 40, 80, 200, 400, 800, 1600, 4000)),
    "planar_chain": Family("open chain", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1250, 2500, 5000)),
    "four_bars": Family("chain of four-bars", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1280, 2560, 6400)),
    "grid": Family("N by N masses on springs", 0.1, (5, 10, 20, 40, 80, 120), lambda n: n * n, "N^2"),
}
# Models with events: so long nothing happens [s].
BEFORE = {"balls": 0.15}
PIECES = 1500
RUNS = 3
# CPU seconds for all families: sizes that would take longer are left out. Time that a family leaves is for the next.
MOST = 420.0
GROWS = 1.25
PATIENCE = 300.0  # s of a process


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A curve for every model of FAMILIES, each size in a process of its own."""
    curves, left = {}, MOST
    for done, name in enumerate(FAMILIES):
        seconds, curves[name] = children_cpu_seconds(partial(_curve, name, left / (len(FAMILIES) - done), say))
        left -= seconds
    return {"runs": RUNS, "curves": curves}


def _curve(name: str, seconds: float, say: Callable[[str], None]) -> list[dict[str, float]]:
    """As many sizes as are expected to end within so many seconds."""
    family = FAMILIES[name]
    points: list[dict[str, float]] = []
    spent, before = 0.0, 0
    for n in family.sizes:
        expected = spent * (family.parts(n) / before) ** GROWS if before else 0.0
        if expected > seconds:
            say(f"sizes: {name} {n} and more left out")
            break
        say(f"sizes: {name} {n}")
        try:
            code = f"import json, sizes\nprint(json.dumps(sizes.one({name!r}, {n})))"
            spent, found = children_cpu_seconds(partial(in_fresh_process, code, PATIENCE))
            points.append(dict(found))  # type: ignore[call-overload]
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            say(f"sizes: {name} {n} failed: {error}")
            break
        seconds, before = seconds - spent, family.parts(n)
    return points


def one(name: str, n: int) -> dict[str, float]:
    """CPU seconds of derivation, of start values and of the motion behind them; growth of the process's memory [MB].

    A model of the least size runs before: imports and what is read once do not count. The tape runs the functions, so
    that no compiler takes part.
    """
    stop = FAMILIES[name].stop
    _made(name, FAMILIES[name].sizes[0]).simulate(stop=stop, interval=stop / 100)
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
