"""A finished FMU is validated and run for some steps before anybody gets it; what crashes, crashes elsewhere."""

from __future__ import annotations

import hashlib
import json
import platform
import signal
import subprocess
import sys
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.building.compiler import failure

# By its path, and without its folder among those that are searched: it imports FMPy only, wherever it is run.
_SCRIPT = Path(__file__).with_name("self_run.py")
_LONGEST_NOTE = 2000
_MOST_PROBLEMS = 10
_PATIENCE = 300.0  # seconds


def try_out(fmu: Path, kinds: Sequence[str]) -> None:
    """Raises CompilationFailed: E0907 where the validator of fmpy has objections, E0908 where the start or the first
    steps of one of `kinds` fail. A file of the same bytes that came through here is not tried again."""
    passed = cache_folder() / f"{_name(fmu, kinds)}.tried"
    if passed.exists():
        return
    _try_out(fmu, kinds)
    passed.touch()


def _name(fmu: Path, kinds: Sequence[str]) -> str:
    """The file, who tries it, and where: the folder may be shared by machines."""
    here = (platform.system(), platform.release(), platform.version(), platform.machine(), platform.node())
    digest = hashlib.sha256(fmu.read_bytes())
    for part in (*kinds, version("fmpy"), sys.version, _SCRIPT.read_text(encoding="utf-8"), *here):
        digest.update(part.encode() + b"\0")
    return digest.hexdigest()[:40]


def _try_out(fmu: Path, kinds: Sequence[str]) -> None:
    command = [sys.executable, "-P", "-W", "ignore", str(_SCRIPT), str(fmu), *kinds]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=_PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        raise failure("E0908", reason=f"it was not done after {_PATIENCE:g} s") from None
    told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    problems = [str(problem) for each in told for problem in each.get("problems", ())]
    if problems:
        more = len(problems) - _MOST_PROBLEMS
        rest = (f"and {more} more",) if more > 0 else ()
        raise failure("E0907", notes=(*problems[:_MOST_PROBLEMS], *rest))
    if done.returncode != 0:
        came_through = [each["ran"] for each in told if "ran" in each]
        raise failure("E0908", reason=_reason(done, kinds, came_through), notes=_said(done))


def _reason(done: subprocess.CompletedProcess[str], kinds: Sequence[str], came_through: Sequence[str]) -> str:
    waiting = [kind for kind in kinds if kind not in came_through]
    where = {"me": "model exchange", "cs": "co-simulation"}.get(waiting[0], waiting[0]) if waiting else "the check"
    if done.returncode < 0:
        return f"{where} ended with {signal.Signals(-done.returncode).name}"
    lines = done.stderr.strip().splitlines()
    return f"{where}: {lines[-1]}" if lines else f"{where} ended with status {done.returncode}"


def _said(done: subprocess.CompletedProcess[str]) -> tuple[str, ...]:
    """Messages of the FMU itself."""
    lines = [line for line in done.stdout.splitlines() if not line.startswith("{")]
    return ("\n".join(lines)[:_LONGEST_NOTE],) if lines else ()
