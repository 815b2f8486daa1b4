"""CPU time of calls and of whole processes: medians of several runs."""

import json
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar

T = TypeVar("T")
HERE = Path(__file__).parent


def cpu_seconds(work: Callable[[], object], runs: int = 5) -> float:
    """Median CPU time of `work` in this process, after one call that is not counted."""
    work()
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return statistics.median(times)


def children_cpu_seconds(work: Callable[[], T]) -> tuple[float, T]:
    """CPU time (user and system) of the processes that `work` starts and waits for, and what it returns."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = work()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, result


def process_cpu_seconds(command: Sequence[str], runs: int = 9) -> float:
    """Median CPU time (user and system) of a whole process, after one run that is not counted."""
    times = []
    for _ in range(runs + 1):
        seconds, _ = children_cpu_seconds(
            lambda: subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        )
        times.append(seconds)
    return statistics.median(times[1:])


def in_fresh_process(code: str, limit: float | None = None) -> object:
    """Last line, as JSON, that Python `code` prints beside this file. Raises TimeoutExpired after `limit` seconds."""
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=HERE, capture_output=True, text=True, check=False, timeout=limit
    )
    if done.returncode != 0:
        raise RuntimeError(f"{code}: {done.stderr.strip()[-500:]}")
    return json.loads(done.stdout.splitlines()[-1])


def first_call_cpu_seconds(module: str, call: str, runs: int = 5) -> float:
    """Median CPU time of the first call of `module.call` in a fresh process, imports not counted.

    Libraries remember results from call to call; the first call is what a user waits for.
    """
    code = f"import time, {module}\nstart = time.process_time()\n{module}.{call}\nprint(time.process_time() - start)"
    return statistics.median(float(str(in_fresh_process(code))) for _ in range(runs))
