"""The seven-axis arm: every peer; the Jacobian; many states; the same arm typed as scalar energies."""

import time
from collections.abc import Callable

import dynamics
import numpy as np
import ours
import serial

from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

MANY = 20_000


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """Everything about the arm."""
    say("arm: forward dynamics, Jacobian, batch")
    contest = dynamics.measure("panda", 7, "forward jacobian batch", scalars="panda_scalars")
    say("arm: model.batch")
    return {"contest": contest, "batch": _batch()}


def _batch() -> list[dict[str, object]]:
    """`model.batch`: wall and CPU nanoseconds per state, CPU summed over threads."""
    made = ours.program("panda", None)
    engine, plain = CEngine(made), NumpyEngine(made)
    defaults = np.array(made.layout.defaults)
    own = defaults * np.random.default_rng(4).uniform(0.9, 1.1, (MANY, len(defaults)))
    rows = []
    for label, solve, threads, count, p in (
        ("C, 1 thread", engine.solve_batch, 1, MANY, defaults),
        (f"C, {cores()} threads", engine.solve_batch, cores(), MANY, defaults),
        ("C, 1 thread, parameters of its own for every state", engine.solve_batch, 1, MANY, own),
        ("NumPy, 1 thread", plain.solve_batch, 1, MANY // 5, defaults),
    ):
        values = serial.states(7, count, seed=3)
        empty = np.zeros(0)
        state = (0.0, values[:, :7], values[:, 7:], empty, empty, empty, p)
        wall, cpu = _least(lambda solve=solve, threads=threads, state=state: solve(threads, *state), count)
        rows.append({"label": label, "wall": wall, "cpu": cpu})
    return rows


def _least(work: Callable[[], object], count: int, runs: int = 15) -> tuple[float, float]:
    """Least wall and CPU nanoseconds of one of `count`."""
    work()
    walls: list[float] = []
    cpus: list[float] = []
    for _ in range(runs):
        wall, cpu = time.perf_counter(), time.process_time()
        work()
        walls.append(time.perf_counter() - wall)
        cpus.append(time.process_time() - cpu)
    return min(walls) / count * 1e9, min(cpus) / count * 1e9
