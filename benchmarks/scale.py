"""Growth with the size of the model: compilers, evaluation; many states at once."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import loops
import numpy as np
import ours
import serial
from growth import exponent

from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.cores import cores
from lagdsl.runtime.numpy_engine import NumpyEngine

# The next size is not tried where it would take about so long.
PATIENCE = 30.0  # CPU s
FIGURE = Path(__file__).with_name("growth.png")
SIZES = {
    "planar_chain": (20, 50, 100, 200, 500),
    "spatial_chain": (20, 50, 100, 200, 500),
    "beam": (10, 20, 40, 80),
    "four_bars": (5, 10, 20, 40, 80),
}
LIMITS = {"planar_chain": "at most 1.25", "spatial_chain": "at most 1.25", "beam": "at most 1.5", "four_bars": ""}


@dataclass(frozen=True)
class Point:
    """One size: CPU seconds of both compilers, characters of C, nanoseconds of one forward dynamics."""

    n: int
    python: float
    compiler: float
    size: int
    evaluation: float


def curves(progress: Callable[[str], None]) -> dict[str, list[Point]]:
    """A curve for every model of SIZES, as far as patience goes."""
    found: dict[str, list[Point]] = {}
    for name, sizes in SIZES.items():
        found[name] = []
        for n in sizes:
            last = found[name][-1:]
            if last and (last[0].python + last[0].compiler) * (n / last[0].n) ** 2 > PATIENCE:
                break
            progress(f"growth of {name}: {n}")
            found[name].append(_point(name, n))
    return found


def _point(name: str, n: int) -> Point:
    (made,) = ours.make(name, n, "cc")
    states = loops.FOLDER / "growth.txt"
    loops.FOLDER.mkdir(mode=0o700, exist_ok=True)
    width = len(made.program.layout.coordinates)
    serial.write_states(states, serial.states(width))
    timing = loops.run([loops.loop("lagdsl"), made.library, made.symbol, states])
    return Point(n, made.python, made.compiler, made.size, timing.least["forward"])


def tables(found: dict[str, list[Point]]) -> list[str]:
    """A table for every curve, exponents below."""
    lines = ["## Growth", "", "CPU seconds of Python (text to C) and of the C compiler; one forward dynamics in C."]
    lines += [
        f"A curve ends where the next size would take more than about {PATIENCE:.0f} s.",
        "",
        "![growth](growth.png)",
    ]
    for name, points in found.items():
        lines += [
            "",
            f"### {name}",
            "",
            "| N | Python [s] | cc [s] | C [kB] | forward dynamics [us] |",
            "|---|---|---|---|---|",
        ]
        lines += [
            f"| {p.n} | {p.python:.2f} | {p.compiler:.2f} | {p.size / 1000:.0f} | {p.evaluation / 1000:.3g} |"
            for p in points
        ]
        limit = f" ({LIMITS[name]})" if LIMITS[name] else ""
        sizes = [float(p.n) for p in points]
        slopes = [_slope(sizes, [f(p) for p in points]) for f in _FIGURES]
        lines.append(f"| exponent | {slopes[0]}{limit} | {slopes[1]} | {slopes[2]} | {slopes[3]} |")
    return lines


_FIGURES: tuple[Callable[[Point], float], ...] = (
    lambda p: p.python,
    lambda p: p.compiler,
    lambda p: p.size,
    lambda p: p.evaluation,
)


def _slope(sizes: list[float], values: list[float]) -> str:
    return f"{exponent(sizes, values):.2f}" if len(sizes) > 1 else ""


def draw(found: dict[str, list[Point]], peers: dict[str, list[tuple[int, float]]]) -> None:
    """The curves, and the peers' times of one forward dynamics by label."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), constrained_layout=True)
    titles = ("Python, text to C [CPU s]", "C compiler [CPU s]", "forward dynamics [us]")
    scales = (1.0, 1.0, 1e-3)
    for axis, title, value, scale in zip(axes, titles, (_FIGURES[0], _FIGURES[1], _FIGURES[3]), scales, strict=True):
        for name, points in found.items():
            axis.loglog([p.n for p in points], [value(p) * scale for p in points], "o-", label=name)
        axis.set_title(title)
        axis.set_xlabel("N")
        axis.grid(True, which="both", alpha=0.3)
    for label, pairs in peers.items():
        axes[2].loglog([n for n, _ in pairs], [time / 1000 for _, time in pairs], "--", label=label)
    axes[2].legend(fontsize=7)
    figure.savefig(FIGURE, dpi=110, metadata={"Software": None})
    plt.close(figure)


def batch() -> list[str]:
    """`model.batch` on the seven-axis arm: nanoseconds per state."""
    (made,) = ours.make("panda", None, "cc")
    states = loops.FOLDER / "batch.txt"
    serial.write_states(states, serial.states(7))
    single = loops.run([loops.loop("lagdsl"), made.library, made.symbol, states]).least["forward"]
    engine, plain = CEngine(made.program), NumpyEngine(made.program)
    defaults = np.array(made.program.layout.defaults)
    parameters = defaults * np.random.default_rng(4).uniform(0.9, 1.1, (20_000, len(defaults)))
    rows = [("one state in a C loop", single, single)]
    for label, solve, threads, count, p in (
        ("C, 1 thread", engine.solve_batch, 1, 20_000, defaults),
        (f"C, {cores()} threads", engine.solve_batch, cores(), 20_000, defaults),
        ("C, 1 thread, parameters of its own for every state", engine.solve_batch, 1, 20_000, parameters),
        ("NumPy, 1 thread", plain.solve_batch, 1, 4096, defaults),
    ):
        values = serial.states(7, count, seed=3)
        empty = np.zeros(0)
        state = (0.0, values[:, :7], values[:, 7:], empty, empty, empty, p)
        rows.append((label, *_least(lambda solve=solve, threads=threads, state=state: solve(threads, *state), count)))
    lines = ["## Many states: the seven-axis arm", "", "20 000 states (NumPy: 4096); CPU time summed over threads.", ""]
    lines += ["| | wall [ns per state] | CPU [ns per state] | CPU, of a single one |", "|---|---|---|---|"]
    return [*lines, *(f"| {label} | {wall:.0f} | {cpu:.0f} | {cpu / single:.2f} |" for label, wall, cpu in rows)]


def _least(work: Callable[[], object], count: int, runs: int = 7) -> tuple[float, float]:
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
