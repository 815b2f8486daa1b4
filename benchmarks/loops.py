"""The C and C++ loops of native/: compiled once, run, their answers read."""

import hashlib
import json
import os
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np

from lagdsl.runtime.build import cache_folder

HERE = Path(__file__).parent
FOLDER = cache_folder() / "benchmarks"
# What Pinocchio's own package files ask for; its algorithms come compiled with the library.
_PINOCCHIO = (
    "-std=c++17",
    "-O2",
    "-DNDEBUG",
    "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
)


@dataclass
class Timing:
    """Least nanoseconds per call by label; results by state."""

    least: dict[str, float] = field(default_factory=dict)
    results: dict[int, np.ndarray] = field(default_factory=dict)

    def forward(self) -> np.ndarray:
        """qdd of all states, (states, n)."""
        return np.array([self.results[k] for k in sorted(self.results)])


def run(command: Sequence[str | Path]) -> Timing:
    """What a loop says about itself."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{Path(command[0]).name}: {done.stderr.strip()[-300:]}")
    timing = Timing()
    for line in done.stdout.splitlines():
        kind, label, first, *rest = line.split()
        if kind == "T":
            timing.least[label] = float(first)
        elif kind == "V":
            timing.results[int(first)] = np.array([float(word) for word in rest])
    return timing


@cache
def peers() -> dict[str, dict[str, str]]:
    """Folder and version of every peer that is installed; empty without an environment of peers."""
    try:
        return dict(json.loads(in_peers("where")))
    except (OSError, subprocess.CalledProcessError):
        return {}


def in_peers(*arguments: str | Path) -> str:
    """Standard output of in_peers.py. Raises OSError and CalledProcessError."""
    python = Path(os.environ.get("PEERS", ".peers")) / "bin" / "python"
    command = [str(python), str(HERE / "in_peers.py"), *map(str, arguments)]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout


@cache
def loop(name: str) -> Path:
    """The compiled loop of that name."""
    flags, libraries = _BUILD[name]()
    (source,) = (HERE / "native").glob(f"{name}.c*")
    command = ["g++" if source.suffix == ".cpp" else "cc", *flags, str(source), *libraries]
    content = "".join((*command, source.read_text(), (HERE / "native" / "bench.h").read_text()))
    FOLDER.mkdir(mode=0o700, exist_ok=True)
    target = FOLDER / f"{name}-{hashlib.sha256(content.encode()).hexdigest()[:16]}"
    if not target.exists():
        subprocess.run([*command, "-o", str(target)], check=True)
    return target


def _pinocchio() -> tuple[list[str], list[str]]:
    home = peers()["pinocchio"]["folder"]
    includes = [f"-I{home}/include", f"-I{home}/include/eigen3"]
    return [*_PINOCCHIO, *includes], [
        f"-L{home}/lib",
        "-lpinocchio_default",
        "-lboost_serialization",
        f"-Wl,-rpath,{home}/lib",
    ]


def _mujoco() -> tuple[list[str], list[str]]:
    home = Path(peers()["mujoco"]["folder"])
    (library,) = home.glob("libmujoco.so*")
    return ["-O2", f"-I{home}/include"], [str(library), f"-Wl,-rpath,{home}", "-lm"]


_BUILD: dict[str, Callable[[], tuple[list[str], list[str]]]] = {
    "pinocchio": _pinocchio,
    "mujoco": _mujoco,
    "casadi": lambda: (["-O2"], ["-ldl"]),
    "lagdsl": lambda: (["-O2", f"-I{HERE.parent}/lagdsl/runtime/c/include"], ["-ldl"]),
}
