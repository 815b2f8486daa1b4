"""CPU time of calls and of whole processes: medians of several runs."""

import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path


def cpu_seconds(work: Callable[[], object], runs: int = 5) -> float:
    """Median CPU time of `work` in this process, after one call that is not counted."""
    work()
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return statistics.median(times)


def process_cpu_seconds(command: Sequence[str], runs: int = 9) -> float:
    """Median CPU time (user and system) of a whole process, after one run that is not counted."""
    times = []
    for _ in range(runs + 1):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return statistics.median(times[1:])


def first_call_cpu_seconds(module: str, function: str, runs: int = 5) -> float:
    """Median CPU time of the first call of `module.function` in a fresh process, imports not counted.

    SymPy remembers results from call to call; the first call is what a user waits for.
    """
    code = (
        f"import time, {module}\nstart = time.process_time()\n{module}.{function}()\nprint(time.process_time() - start)"
    )
    here = Path(__file__).parent
    outputs = [
        subprocess.run([sys.executable, "-c", code], cwd=here, check=True, capture_output=True, text=True).stdout
        for _ in range(runs)
    ]
    return statistics.median(float(output) for output in outputs)
