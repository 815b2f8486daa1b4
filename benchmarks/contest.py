"""Contests: the libraries of native/ compiled once, all contestants of one question timed in turns in one process."""

import hashlib
import os
import statistics
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np
import peers

from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.exchange.fmi.package.sources import require_fmpy

NATIVE = Path(__file__).parent / "native"
RUNTIME = Path(__file__).parents[1] / "lagdsl" / "engines" / "runtime" / "c"
FOLDER = cache_folder() / "benchmarks"
ROUNDS, RUNS = 400, 5
_SHARED = ("-fPIC", "-shared")
# Flags that Pinocchio's own package files ask for.
_PINOCCHIO = (
    "-std=c++17",
    "-DNDEBUG",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
)


@dataclass(frozen=True)
class Contestant:
    """`label` is what times and results are told under; `library` of native/ enters with `arguments`."""

    label: str
    library: str
    arguments: tuple[str | Path, ...]


@dataclass
class Run:
    """One process: least nanoseconds of one evaluation, and results by state, by (label, kind)."""

    least: dict[tuple[str, str], float] = field(default_factory=dict)
    results: dict[tuple[str, str], np.ndarray] = field(default_factory=dict)


def folder() -> Path:
    """Folder of everything that is made."""
    FOLDER.mkdir(mode=0o700, parents=True, exist_ok=True)
    return FOLDER


def hold(states: Path, contestants: Sequence[Contestant], *, rounds: int = ROUNDS, runs: int = RUNS) -> list[Run]:
    """`runs` processes, one after the other."""
    command: list[str] = [str(built("contest")), str(states), str(rounds)]
    for each in contestants:
        command += ["--", each.label, str(built(each.library)), *map(str, each.arguments)]
    return [_run(command) for _ in range(runs)]


def results(states: Path, contestant: Contestant) -> dict[str, np.ndarray]:
    """Results of one of them, by kind, without times."""
    (run,) = hold(states, [contestant], rounds=0, runs=1)
    return {kind: values for (_, kind), values in run.results.items()}


def _run(command: list[str]) -> Run:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: status {done.returncode} {done.stderr.strip()[-300:]}")
    run, rows = Run(), dict[tuple[str, str], list[np.ndarray]]()
    for line in done.stdout.splitlines():
        what, label, kind, *rest = line.split()
        if what == "T":
            run.least[label, kind] = float(rest[0])
        elif what == "V":
            rows.setdefault((label, kind), []).append(np.array(rest[1:], dtype=float))
    run.results = {key: np.array(values) for key, values in rows.items()}
    return run


def median_times(runs: Sequence[Run]) -> dict[str, dict[str, float]]:
    """Median over the runs of the least nanoseconds, by kind and label."""
    found: dict[str, dict[str, float]] = {}
    for label, kind in runs[0].least:
        times = [run.least[label, kind] for run in runs]
        found.setdefault(kind, {})[label] = statistics.median(times)
    return found


def ratio(runs: Sequence[Run], kind: str, ours: str, theirs: Sequence[str], over: str | None = None) -> float | None:
    """Median over the runs of our time over the least of theirs in the same run; `over` is the kind of theirs."""
    shares = []
    for run in runs:
        times = [run.least[label, over or kind] for label in theirs if (label, over or kind) in run.least]
        if (ours, kind) in run.least and times:
            shares.append(run.least[ours, kind] / min(times))
    return statistics.median(shares) if shares else None


@cache
def built(name: str) -> Path:
    """The compiled library, or program, of that name."""
    flags, libraries = _BUILD[name]()
    (source,) = (
        path for path in NATIVE.iterdir() if path.stem == name.removesuffix("_native") and path.suffix in (".c", ".cpp")
    )
    command = ["g++" if source.suffix == ".cpp" else "cc", *flags, f"-I{NATIVE}", str(source), *libraries]
    headers = sorted([*NATIVE.glob("*.h*"), *(RUNTIME.glob("lag/**/*.h") if name in ("lagdsl", "run", "tape") else ())])
    options = [word for word in command if not word.startswith((f"-I{NATIVE}", f"-I{RUNTIME}", str(NATIVE)))]
    content = "\0".join((*options, source.read_text(), *(path.read_text() for path in headers)))
    target = folder() / f"{name}-{hashlib.sha256(content.encode()).hexdigest()[:16]}"
    if not target.exists():
        draft = target.with_suffix(f".{os.getpid()}")
        done = subprocess.run([*command, "-w", "-o", str(draft)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()[:500]}")
        draft.replace(target)
    return target


def _pinocchio() -> tuple[list[str], list[str]]:
    """The library of the package, as a user links it."""
    home = peers.where()["pinocchio"]["folder"]
    flags = [*_SHARED, *_PINOCCHIO, "-O2", "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION"]
    libraries = ["-lpinocchio_default", "-lboost_serialization"]
    return [*flags, *_pinocchio_headers()], [f"-L{home}/lib", *libraries, f"-Wl,-rpath,{home}/lib"]


def _pinocchio_native() -> tuple[list[str], list[str]]:
    """Its headers compiled for this machine."""
    flags = [*_SHARED, *_PINOCCHIO, "-O3", "-march=native", "-DPINOCCHIO_SKIP_TEMPLATE_INSTANTIATION"]
    return [*flags, *_pinocchio_headers()], []


def _pinocchio_casadi() -> tuple[list[str], list[str]]:
    home = peers.where()["casadi"]["folder"]
    flags = [*_PINOCCHIO, "-O1", "-DPINOCCHIO_SKIP_TEMPLATE_INSTANTIATION", f"-I{home}/include"]
    return [*flags, *_pinocchio_headers()], [f"-L{home}", "-lcasadi", f"-Wl,-rpath,{home}"]


def _pinocchio_headers() -> list[str]:
    home = peers.where()["pinocchio"]["folder"]
    return [f"-I{home}/include", f"-I{home}/include/eigen3"]


def _mujoco() -> tuple[list[str], list[str]]:
    home = Path(peers.where()["mujoco"]["folder"])
    (library,) = home.glob("libmujoco.so*")
    return [*_SHARED, "-O2", f"-I{home}/include"], [str(library), f"-Wl,-rpath,{home}", "-lm"]


_BUILD: dict[str, Callable[[], tuple[list[str], list[str]]]] = {
    "contest": lambda: (["-O2"], ["-ldl"]),
    "run": lambda: (["-O2", f"-I{RUNTIME}"], ["-ldl"]),
    "communicate": lambda: (["-O2", f"-I{require_fmpy() / 'c-code'}"], ["-ldl"]),
    "lagdsl": lambda: ([*_SHARED, "-O2", f"-I{RUNTIME}"], ["-ldl"]),
    "tape": lambda: ([*_SHARED, "-O2", "-ffp-contract=off", f"-I{RUNTIME}"], []),
    "casadi": lambda: ([*_SHARED, "-O2"], ["-ldl"]),
    "mujoco": _mujoco,
    "pinocchio": _pinocchio,
    "pinocchio_native": _pinocchio_native,
    "pinocchio_casadi": _pinocchio_casadi,
}
