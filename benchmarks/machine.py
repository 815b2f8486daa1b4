"""Place and time of a measurement, and the load of the machine."""

import os
import platform
import subprocess
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

import numpy as np
import peers

import lagdsl


def describe() -> dict[str, object]:
    """Processor, versions, date, and the load average of the last minute."""
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "processor": _processor(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "system": f"{platform.system()} {platform.machine()}",
        "versions": {
            "lagdsl": f"{lagdsl.__version__} ({_commit()})",
            "Python": platform.python_version(),
            "NumPy": np.__version__,
            "SymPy": version("sympy"),
            "C compiler": _first_line(["cc", "--version"]),
            **{name: told["version"] for name, told in peers.where().items()},
        },
        "load": load(),
    }


def load() -> float:
    """Load average of the last minute; 0 where the system does not tell."""
    return round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else 0.0


def _processor() -> str:
    """Its name and the widest vectors it has."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    told = dict(line.split(":", 1) for line in reversed(lines) if ":" in line)
    told = {key.strip(): value.strip() for key, value in told.items()}
    flags = told.get("flags", "").split()
    vectors = next((name for name in ("avx512f", "avx2", "avx") if name in flags), "")
    return " ".join(filter(None, (told.get("model name", platform.processor()), vectors)))


def _commit() -> str:
    told = _first_line(["git", "-C", str(Path(__file__).parent), "rev-parse", "--short", "HEAD"])
    return told or "no commit"


def _first_line(command: list[str]) -> str:
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]
    except (OSError, subprocess.CalledProcessError, IndexError):
        return ""
