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
    """The end [s] of a motion and the sizes of its model, the last of which are ten times the largest that is in use;
    `parts` is what costs should be proportional to, `unit` its name; the `model` where it has another name than the
    family, and the `tolerance` where it is not the default one."""

    title: str
    stop: float
    sizes: tuple[int, ...]
    parts: Callable[[int], int] = lambda n: n
    unit: str = "N"
    model: str = ""
    tolerance: float | None = None


FAMILIES: dict[str, Family] = {
    "iftomm_a02": Family("row of four-bars with shared uprights", 0.5, (5, 10, 20, 40, 80, 160, 320)),
    "masses": Family("masses in a row", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1280, 2560, 5120)),
    "net": Family("net of springs", 0.2, (5, 10, 20, 40, 80, 160, 320)),
    "reissner": Family("beam with shear", 0.01, (16, 32, 64, 128, 256, 512, 1024)),
    "reissner_at_1e-5": Family(
        "beam with shear, tolerance 1e-5",
        0.01,
        (16, 32, 64, 128, 256, 512, 1024, 2560),
        model="reissner",
        tolerance=1e-5,
    ),
    "ladder": Family("ladder of coils and capacitors", 5e-3, (5, 10, 20, 40, 80, 160, 320, 640, 1600, 3200)),
    "oscillators": Family("masses on springs of their own", 1.0, (5, 50, 500, 1000, 2000, 4000, 10000, 40000)),
    "nbody": Family(
        "bodies that attract each other", 0.05, (5, 10, 20, 40, 80, 160), lambda n: n * (n - 1) // 2, "pairs"
    ),
    "balls": Family("balls that bounce", 1.0, (5, 10, 20, 40, 80, 160, 400, 800, 1600, 3200)),
    "resting": Family("balls at rest on a floor", 0.1, (5, 10, 20, 40, 80, 200, 400, 800, 1600, 3200)),
    "stack": Family("blocks at rest, one on another", 0.1, (5, 10, 20, 40, 80, 200, 400, 800, 1600, 4000)),
    "planar_chain": Family("open chain", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1250, 2500, 5000, 10000, 20000)),
    "four_bars": Family("chain of four-bars", 0.5, (5, 10, 20, 40, 80, 160, 320, 640, 1280, 2560)),
    "grid": Family("N by N masses on springs", 0.1, (5, 10, 20, 40, 80, 126), lambda n: n * n, "N^2"),
}
# Models with events: so long nothing happens [s].
BEFORE = {"balls": 0.15}
PIECES = 1500
RUNS = 3
# CPU seconds for all families: sizes that would take longer are left out. Time that a family leaves is for the next.
MOST = 1400.0
GROWS = 1.25
PATIENCE = 500.0  # s of a process


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
    family = FAMILIES[name]
    run = partial(_run, family)
    run(_made(name, family.sizes[0]), family.stop)
    before = _peak()
    start = time.process_time()
    model = _made(name, n)
    derived = time.process_time() - start
    first = _least(lambda: run(_anew(model), 1e-6 * family.stop))
    whole = _least(lambda: run(_anew(model), family.stop))
    motion = run(model, family.stop)
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


def _run(family: Family, model: lagdsl.Model, stop: float) -> lagdsl.Trajectory:
    """With a hundred rows, where the motion is not a part of that of the family."""
    return model.simulate(stop=stop, interval=min(family.stop / 100, stop), tolerance=family.tolerance)


def _anew(model: lagdsl.Model) -> lagdsl.Model:
    """It searches for its start again."""
    model._engine.native.found.clear()
    return model


def _made(name: str, n: int) -> lagdsl.Model:
    model = FAMILIES[name].model or name
    return lagdsl.compile(ours.MODELS / f"{model}.lag", engine="tape", structural={"N": n})


def _least(work: Callable[[], object]) -> float:
    times = []
    for _ in range(RUNS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def _peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
