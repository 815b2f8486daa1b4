"""Every model of models/ by `auto`, on the tape and in C, compiling counted, with a cold and a warm cache."""

import os
import shutil
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

from measure import children_cpu_seconds

from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file, read
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate

MODELS = Path(__file__).parents[1] / "models"
# Runs shorter than this are made several times, and the least counts [s].
SHORT, REPEATS = 0.3, 5
# Ratios of shorter times are those of the clock and of Python's own work [s].
LEAST = 0.02
# Nobody waits longer for a compiler [s].
LONGEST = 60.0
# The target of the ratio.
MOST = 1.3


def measure(say: Callable[[str], None], names: tuple[str, ...] = ()) -> dict[str, object]:
    """A row for every model, or for those of `names`: CPU seconds, those of the
    compiler included, from the program to the end of its experiment."""
    rows = []
    known = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))
    for number, name in enumerate(known):
        if names and name not in names:
            continue
        if number % 20 == 0:
            say(f"auto: {number} of {len(known)} models")
        compilation = _compiled(MODELS / f"{name}.lag")
        if compilation is not None:
            rows.append({"model": name, **_times(compilation)})
    return {"rows": rows, "least": LEAST}


def worst(rows: list[dict[str, float]], cache: str, least: float) -> float | None:
    """The largest ratio of `auto` to the better of the other two."""
    return max((ratio(row, cache, least) for row in rows), default=None)


def ratio(row: dict[str, float], cache: str, least: float) -> float:
    """Of the times of one row, `cache` cold or warm."""
    best = min(row["tape"], row[f"c {cache}"])
    return max(row[f"auto {cache}"], least) / max(best, least)


def _compiled(path: Path) -> Compilation | None:
    sink = Sink()
    source = read(path, sink)
    flat = None if source is None else flatten_file(source, sink)
    return None if flat is None else compile_flat(flat, sink)


def _times(compilation: Compilation) -> dict[str, float]:
    with TemporaryDirectory() as cache, patch.dict(os.environ, {"XDG_CACHE_HOME": cache}):
        times = _least_in_turns(compilation, Path(cache))
        times["c cold"] = _once(compilation, "c")
        times["c warm"] = _least(compilation, "c")
        _fill_cache(compilation)
        times["auto warm"] = _least(compilation, "auto")
    return times


def _fill_cache(compilation: Compilation) -> None:
    """With the library that `auto` makes where the work pays for it."""
    engine, limit = AutoEngine(compilation.program), time.monotonic() + LONGEST
    engine.worked(1e6)
    while engine.hasten() is None and time.monotonic() < limit:
        time.sleep(0.005)


def _least_in_turns(compilation: Compilation, cache: Path) -> dict[str, float]:
    """On the tape and, the folder `cache` emptied before each run, by `auto`: in turns, for others may be at work."""
    times: dict[str, list[float]] = {"tape": [], "auto cold": []}
    while not _enough(times["tape"]):
        times["tape"].append(_once(compilation, "tape"))
        shutil.rmtree(cache / "lagdsl", ignore_errors=True)
        times["auto cold"].append(_once(compilation, "auto"))
    return {name: min(own) for name, own in times.items()}


def _least(compilation: Compilation, engine: EngineName) -> float:
    times: list[float] = []
    while not _enough(times):
        times.append(_once(compilation, engine))
    return min(times)


def _enough(times: list[float]) -> bool:
    """REPEATS short runs, or one long one."""
    return len(times) >= (REPEATS if not times or times[0] < SHORT else 1)


def _once(compilation: Compilation, name: EngineName) -> float:
    """A motion that ends early is a motion."""
    started = time.process_time()

    def run() -> None:
        with suppress(SimulationFailed, CompilationFailed):
            simulate(engine_of(compilation.program, name), compilation.flat, sink=Sink())

    compiler, _ = children_cpu_seconds(run)
    return compiler + time.process_time() - started
