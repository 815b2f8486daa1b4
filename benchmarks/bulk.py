"""Whole commands that take long by their number of runs or of instants: a sweep of the double pendulum, a drive."""

import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import lagdsl

HERE = Path(__file__).parent
MODELS = HERE.parent / "models"
RUNS = 10_000
SWEEP = ("--random", str(RUNS), "--set", "m1=normal(1, 0.05) kg", "--set", "l1=uniform(0.45, 0.55) m")
TERMS = ("--stop", "10", "--interval", "0.1", "--tolerance", "1e-6")


def ensembles(say: Callable[[str], None]) -> dict[str, object]:
    """Wall and CPU seconds of `lag sweep` of RUNS motions of 10 s with 101 rows, to a file."""
    with TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "lagdsl", "sweep", str(MODELS / "double_pendulum.lag"), *SWEEP, *TERMS]
        walls = []
        for number in range(3):
            say(f"ensembles: {RUNS} runs, {number + 1} of 3")
            started = time.perf_counter()
            subprocess.run([*command, "-o", f"{folder}/{number}.nc"], check=True, capture_output=True)
            walls.append(time.perf_counter() - started)
    return {"runs": RUNS, "wall": statistics.median(walls), "walls": walls}


def drive(say: Callable[[str], None]) -> dict[str, object]:
    """Wall seconds of `model.simulate` of the drive as a user has it, and of the whole command."""
    say("drive")
    path = HERE / "models" / "drive.lag"
    model = lagdsl.compile(path)
    walls, commands = [], []
    for _ in range(5):
        started = time.perf_counter()
        motion = model.simulate()
        walls.append(time.perf_counter() - started)
        started = time.perf_counter()
        subprocess.run([sys.executable, "-m", "lagdsl", "run", str(path)], check=True, capture_output=True)
        commands.append(time.perf_counter() - started)
    steps = motion.statistics.steps
    return {"wall": statistics.median(walls), "command": statistics.median(commands), "steps": steps}
