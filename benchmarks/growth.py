"""Growth with the size of the model: both compilers and one evaluation; against CasADi and SymPy."""

import math
import statistics
import subprocess
from collections.abc import Callable

import contest
import numpy as np
import oracle
import ours
import peers
import planar
import serial
from measure import first_call_cpu_seconds

SIZES = {
    "planar_chain": (20, 50, 100, 200, 500),
    "spatial_chain": (20, 50, 100, 200, 500),
    "beam": (10, 20, 40, 80),
    "four_bars": (5, 10, 20, 40, 80),
}
RUNS = 3
PATIENCE = 60.0  # CPU s: a curve ends before what would take longer
SYMPY_SIZES, CASADI_SIZES = (2, 4, 6, 8), (5, 10, 20, 50)
AGREES = 1e-6


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A curve for every model of SIZES, and the Python time of the peers for the planar chain."""
    curves = {name: _curve(name, say) for name in SIZES}
    say("growth: SymPy")
    sympy = [{"n": n, "python": first_call_cpu_seconds("against_sympy", f"chain({n})", 1)} for n in SYMPY_SIZES]
    casadi = []
    if "casadi" in peers.where():
        say("growth: CasADi")
        for n in CASADI_SIZES:
            (made,) = peers.casadi("planar_chain", n, "plane", peers.NO_FLAGS, runs=1)
            casadi.append({"n": n, "python": made.python, "compiler": made.compiler})
    return {"curves": curves, "sympy": sympy, "casadi": casadi, "runs": RUNS}


def _curve(name: str, say: Callable[[str], None]) -> list[dict[str, object]]:
    points: list[dict[str, object]] = []
    spent = 0.0
    for i, n in enumerate(SIZES[name]):
        if i and spent * (n / SIZES[name][i - 1]) ** 2 > PATIENCE:
            break
        say(f"growth: {name} {n}")
        try:
            made = ours.in_processes(name, n, runs=RUNS)
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            say(f"growth: {name} {n} failed: {error}")
            break
        spent = made.python + made.compiler
        point: dict[str, object] = {"n": n, "python": made.python, "compiler": made.compiler, "size": made.size}
        points.append({**point, "flops": made.flops, **_evaluation(name, n, made)})
    return points


def _evaluation(name: str, n: int, made: ours.Made) -> dict[str, object]:
    """Nanoseconds of one forward dynamics, None where it is wrong, and the largest error."""
    values = planar.four_bar_states(n, serial.STATES) if name == "four_bars" else serial.states(made.n)
    states = contest.folder() / f"growth_{name}_{n}.txt"
    serial.write_states(states, values)
    entry = contest.Contestant("lagdsl", "lagdsl", (made.library, *made.symbols, "forward"))
    runs = contest.hold(states, [entry], runs=RUNS)
    found = runs[0].results["lagdsl", "forward"]
    few = slice(0, 3)  # extended precision is slow
    error = float(np.max(oracle.error(found[few], _reference(name, n, values[few]))))
    time = statistics.median(run.least["lagdsl", "forward"] for run in runs)
    return {"evaluation": time if error < AGREES else None, "error": error if math.isfinite(error) else None}


def _reference(name: str, n: int, values: np.ndarray) -> np.ndarray:
    match name:
        case "beam":
            return planar.beam(values)
        case "four_bars":
            return planar.four_bars(values)
        case _:
            return oracle.serial_arm(serial.ARMS[name](n), values)


def exponent(points: list[dict[str, object]], figure: str, least: int = 4) -> float | None:
    """Least-squares slope of log(figure) over log(n); None below `least` sizes."""
    pairs = [(float(str(p["n"])), float(str(p[figure]))) for p in points if p.get(figure) is not None]
    if len(pairs) < least:
        return None
    return statistics.linear_regression([math.log(n) for n, _ in pairs], [math.log(y) for _, y in pairs]).slope
