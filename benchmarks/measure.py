"""CPU time of calls and of whole processes: medians of several runs."""

import resource
import statistics
import subprocess
import time
from collections.abc import Callable, Sequence


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
