"""Motions: the C runtime against CVODE and SciPy. Time for an error of GOAL at the end; where it is stiff, right-hand
sides for errors along the whole motion, dense output of all included."""

import json
import statistics
import subprocess
import time
from collections.abc import Callable
from itertools import pairwise
from math import exp, log

import contest
import numpy as np
import ours
import peers
from problems import GOAL, PROBLEMS, Problem

import lagdsl

TOLERANCES = [10.0 ** (-k / 2) for k in range(2, 25)]
REPEATS = 50
# Errors over which right-hand sides are compared: beyond, nobody asks, or peers come no nearer.
RANGE = (1e-10, 1e-2)


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A row for every problem."""
    return {"goal": GOAL, "problems": {name: _problem(name, problem, say) for name, problem in PROBLEMS.items()}}


def _problem(name: str, problem: Problem, say: Callable[[str], None]) -> dict[str, object]:
    say(f"motion: {name}, peers")
    theirs = json.loads(peers.run("motion", name)) if "casadi" in peers.where() else None
    say(f"motion: {name}, lagdsl")
    reference = None if theirs is None else np.array(theirs["reference"])
    made = ours.make(problem.model, problem.n)
    ways = ("radau", "auto") if problem.stiff else ("auto",)
    rows = [_run(problem, made, way, tolerance, reference) for way in ways for tolerance in TOLERANCES]
    row: dict[str, object] = {
        "title": problem.title,
        "stiff": problem.stiff,
        "rows": [r for r in rows if r["status"] == 0],
    }
    if reference is not None and theirs is not None:
        row |= {"peers": theirs["rows"], "apart": theirs["apart"]}
        if not problem.stiff:
            row["simulate"] = _simulate(problem, _loosest(rows, "auto"))
    return row


def _run(
    problem: Problem, made: ours.Made, way: str, tolerance: float, reference: np.ndarray | None
) -> dict[str, object]:
    """One motion in C."""
    repeats = 1 if problem.stiff else REPEATS
    command = [str(contest.built("run")), str(made.library), made.symbols[0], way, repr(tolerance)]
    command += [repr(problem.stop), str(repeats), str(len(problem.times)), *map(repr, problem.start)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    status, evaluations, jacobians, steps, seconds, *state = done.stdout.split()
    error = None
    if reference is not None:
        apart = np.abs(np.array(state, dtype=float).reshape(reference.shape) - reference)
        error = float(np.max(apart / np.maximum(1.0, np.abs(reference))))
    return {
        "way": way,
        "status": int(status),
        "tolerance": tolerance,
        "error": error,
        "evaluations": int(evaluations),
        "jacobians": int(jacobians),
        "steps": int(steps),
        "seconds": float(seconds),
    }


def _loosest(rows: list[dict[str, object]], way: str) -> float:
    """The largest tolerance with an error of at most GOAL there and at all smaller ones that were tried."""
    found = TOLERANCES[-1]
    for row in sorted((r for r in rows if r["way"] == way), key=lambda r: float(str(r["tolerance"]))):
        if float(str(row["error"])) > GOAL:
            break
        found = float(str(row["tolerance"]))
    return found


def _simulate(problem: Problem, tolerance: float) -> float:
    """Seconds of the whole of `model.simulate`, one row at the end."""
    structural = {} if problem.n is None else {"N": problem.n}
    model = lagdsl.compile(ours.MODELS / f"{problem.model}.lag", engine="c", structural=structural)
    names = list(model.coordinates)
    n = len(names)
    start = dict(zip([*names, *(f"der({name})" for name in names)], problem.start[: 2 * n], strict=True))
    times = []
    for _ in range(REPEATS):
        before = time.perf_counter()
        model.simulate(stop=problem.stop, interval=problem.stop, tolerance=tolerance, start=start)
        times.append(time.perf_counter() - before)
    return min(times)


def best(problem: dict, way: str) -> dict | None:
    """The quickest run of that way with an error of at most GOAL; ours are told in `rows`."""
    rows = [*problem["rows"], *problem.get("peers", [])]
    good = [
        r for r in rows if r["way"].startswith(way) and r["error"] is not None and r["error"] <= GOAL and r["seconds"]
    ]
    return min(good, key=lambda row: row["seconds"], default=None)


def time_ratio(problem: dict, peer: str) -> float | None:
    """Our time over theirs."""
    mine, theirs = best(problem, "auto"), best(problem, peer)
    return mine["seconds"] / theirs["seconds"] if mine and theirs else None


def frontier(rows: list[dict]) -> list[tuple[float, int]]:
    """The runs than which none has both a smaller error and fewer right-hand sides; by decreasing error."""
    found: list[tuple[float, int]] = []
    for row in sorted(rows, key=lambda row: (row["evaluations"], row["error"])):
        if not found or row["error"] < found[-1][0]:
            found.append((max(row["error"], 1e-16), row["evaluations"]))
    return found


def needed(front: list[tuple[float, int]], error: float) -> float | None:
    """Right-hand sides for that error, between the runs of the frontier; none beyond them."""
    for (before, few), (after, many) in pairwise(front):
        if after <= error <= before:
            part = 0.0 if before == after else log(before / error) / log(before / after)
            return exp(log(few) + part * log(many / few))
    return None


def count_ratios(problem: dict, way: str = "radau") -> list[tuple[float, float, float]]:
    """Error, our right-hand sides and those that the best CVODE needs for it, for errors within RANGE. Where none of
    our runs is so inexact, the cheapest counts."""
    theirs = frontier(problem.get("peers", []))
    mine = frontier([row for row in problem["rows"] if row["way"] == way and row["error"] is not None])
    found = []
    for decade in range(round(log(RANGE[1], 10)), round(log(RANGE[0], 10)) - 1, -1):
        a = needed(mine, min(10.0**decade, mine[0][0])) if mine else None
        b = needed(theirs, 10.0**decade)
        if a is not None and b is not None:
            found.append((10.0**decade, a, b))
    return found


def worst_count(problem: dict) -> float | None:
    """The largest of our counts over theirs at equal accuracy."""
    return max((a / b for _, a, b in count_ratios(problem)), default=None)


def median_count(problem: dict) -> float | None:
    return statistics.median([a / b for _, a, b in count_ratios(problem)] or [float("nan")])
