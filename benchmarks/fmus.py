"""FMUs: what the export of the seven-axis arm takes, and what a communication step costs beyond the integrator."""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import contest
from fmpy import extract, read_model_description
from measure import children_cpu_seconds
from ours import MODELS

import lagdsl

PENDULUM = Path(__file__).parents[1] / "models" / "double_pendulum.lag"
RUNS = 5
STOP, REPEATS = 5.0, 20
FEW, MANY = 10, 100_000


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """CPU seconds of whole processes, Python and compilers; nanoseconds of a communication step."""
    text = (MODELS / "panda.lag").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        say("fmus: a communication step")
        step = _communication_step(folder)  # compiles what all models share, which is not counted
        say("fmus: the arm")
        new, again = zip(*(_exports(text, folder) for _ in range(RUNS)), strict=True)
    return {"step": step, "new": statistics.median(new), "again": statistics.median(again), "runs": RUNS}


def _exports(text: str, folder: Path) -> tuple[float, float]:
    """Of a model that nobody has seen, by its name, and of the same once more."""
    model = f"Panda{time.time_ns()}"
    file = folder / f"{model}.lag"
    file.write_text(text.replace("Panda", model), encoding="utf-8")
    command = [sys.executable, "-m", "lagdsl", "fmu", str(file), "-o", str(file.with_suffix(".fmu"))]

    def run() -> None:
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    return children_cpu_seconds(run)[0], children_cpu_seconds(run)[0]


def _communication_step(folder: Path) -> float:
    """The integrator makes its steps in both runs; what is left are communication steps."""
    file = folder / "DoublePendulum.fmu"
    lagdsl.compile(PENDULUM).export_fmu(file)
    description = read_model_description(str(file))
    (library,) = Path(extract(str(file), str(folder / "unpacked"))).glob("binaries/*/*")
    program = str(contest.built("communicate"))
    command = [program, str(library), description.guid, str(STOP), str(REPEATS), str(FEW), str(MANY)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    few, many = map(float, done.stdout.split())
    return 1e9 * (many - few) / (MANY - FEW)
