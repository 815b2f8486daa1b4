"""The peers: where they are, and what they generate as C, compiled with every set of flags that may be the best."""

import hashlib
import json
import os
import statistics
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import contest
import serial
from measure import children_cpu_seconds

HERE = Path(__file__).parent
NAMES = ("pinocchio", "mujoco", "casadi")
FLAGS: tuple[tuple[str, ...], ...] = (
    ("-O1",),
    ("-O2",),
    ("-O3",),
    ("-O2", "-march=native"),
    ("-O3", "-march=native"),
    ("-O3", "-march=native", "-ffast-math"),
)
FEW_FLAGS = (FLAGS[1], FLAGS[5])
NO_FLAGS = (("-O0",),)


@dataclass(frozen=True)
class Generated:
    """C of a peer as a library; CPU seconds of making the C (imports not counted) and of the C compiler."""

    flags: str
    library: Path
    python: float
    compiler: float


@cache
def where() -> dict[str, dict[str, str]]:
    """Folder and version of every peer that is installed; empty without an environment of peers."""
    try:
        return dict(json.loads(run("where")))
    except OSError:
        return {}


def missing() -> list[str]:
    return [name for name in NAMES if name not in where()]


def run(*arguments: str | Path) -> str:
    """Standard output of in_peers.py. Raises OSError where there is no environment of peers, RuntimeError."""
    python = Path(os.environ.get("PEERS", ".peers")) / "bin" / "python"
    command = [str(python), str(HERE / "in_peers.py"), *map(str, arguments)]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    environment["PYTHONDONTWRITEBYTECODE"] = "1"
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()[-500:]}")
    return done.stdout


def calls(arm: str, n: int, xml: Path) -> dict[str, dict[str, Any]]:
    """Microseconds of calls of their Python functions at one state, `times`, and what these give, `values`."""
    return dict(json.loads(run("calls", arm, str(n), xml)))


def casadi(arm: str, n: int, way: str, flags: tuple[tuple[str, ...], ...], runs: int = 0) -> list[Generated]:
    """Lagrange's equations of an arm by CasADi; `way` is one of in_peers.WAYS.

    A compiled library is kept, with the time it took; with `runs` the times are medians of so many runs made now.
    """
    text = contest.folder() / f"casadi_{way}_{arm}_{n}.c"
    seconds = [json.loads(run("casadi", arm, str(n), way, text))["seconds"] for _ in range(max(1, runs))]
    return [_compiled(text, each, statistics.median(seconds), runs) for each in flags]


def pinocchio_casadi(arm: str, n: int, flags: tuple[tuple[str, ...], ...]) -> list[Generated]:
    """Pinocchio's articulated-body algorithm on CasADi's expressions."""
    numbers = contest.folder() / f"pinocchio_{arm}_{n}.txt"
    numbers.write_text(serial.numbers(serial.ARMS[arm](n)))
    text = contest.folder() / f"pinocchio_{arm}_{n}.c"
    command = [contest.built("pinocchio_casadi"), numbers, text.parent, text.stem]
    seconds, _ = children_cpu_seconds(lambda: subprocess.run(command, check=True, capture_output=True))
    return [_compiled(text, each, seconds) for each in flags]


def _compiled(text: Path, flags: tuple[str, ...], python: float, runs: int = 0) -> Generated:
    """Compiled and linked apart: with -ffast-math, linking would switch denormal numbers off for everybody."""
    digest = hashlib.sha256("\0".join((text.read_text(), *flags)).encode()).hexdigest()[:16]
    library = contest.folder() / f"casadi-{digest}.so"
    told = library.with_suffix(".json")
    if runs or not told.exists():
        draft = library.with_suffix(".o")
        compile_it = ["cc", *flags, "-fPIC", "-c", str(text), "-o", str(draft)]
        link_it = ["cc", "-shared", str(draft), "-o", str(library), "-lm"]

        def work() -> None:
            for command in (compile_it, link_it):
                subprocess.run(command, check=True)

        seconds = statistics.median(children_cpu_seconds(work)[0] for _ in range(max(1, runs)))
        draft.unlink()
        told.write_text(json.dumps(seconds))
    return Generated(" ".join(flags), library, python, float(json.loads(told.read_text())))
