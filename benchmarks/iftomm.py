"""The IFToMM library's benchmarks A01 to A05: CPU time, error and kept energy beside what was published."""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import ours

import lagdsl

# CPU seconds of an implementation in OpenSim 3.2 on an Intel Core i5-4570 at 3.2 GHz, as its pages give them: L.
# Tagliapietra, M. Vivian, E. Ceseracciu, M. Reggiani, Multibody system benchmarks in OpenSim (2015).
PUBLISHED = {"A01": 0.637, "A02, N = 2": 0.455, "A03": 0.384, "A04": 0.258, "A05": 0.233}
ANDREWS = Path(__file__).parents[1] / "models" / "andrews_squeezer.lag"
# Title, model, N, end of the motion [s].
PROBLEMS: tuple[tuple[str, str, int | None, float], ...] = (
    ("A01", "iftomm_a01", None, 10.0),
    ("A02, N = 2", "iftomm_a02", 2, 10.0),
    ("A02, N = 2", "iftomm_a02", 2, 20.0),
    ("A02, N = 40", "iftomm_a02", 40, 10.0),
    ("A02, N = 40", "iftomm_a02", 40, 20.0),
    ("A03", "", None, 0.05),
    ("A04", "iftomm_a04", None, 10.0),
    ("A05", "iftomm_a05", None, 10.0),
)
# Sizes of the energy [J]: the weight of all bars, by the length of one.
SIZES = {"A01": 9.81, "A02, N = 2": 5 * 9.81, "A02, N = 40": 81 * 9.81, "A04": 5 * 9.81}
ROWS = 400
TOLERANCE, FINE = 1e-8, 1e-11
RUNS = 3


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A row for every problem."""
    rows = []
    for title, name, n, stop in PROBLEMS:
        say(f"iftomm: {title}, {stop:g} s")
        rows.append(_row(title, name, n, stop))
    return {"tolerance": TOLERANCE, "rows": rows}


def _row(title: str, name: str, n: int | None, stop: float) -> dict[str, object]:
    file = ours.MODELS / f"{name}.lag" if name else ANDREWS
    model = lagdsl.compile(file, engine="tape", structural={} if n is None else {"N": n})
    model.simulate(stop=0.01 * stop, interval=0.01 * stop)
    times = []
    for _ in range(RUNS if n != 40 else 1):
        start = time.process_time()
        motion = model.simulate(stop=stop, interval=stop / ROWS, tolerance=TOLERANCE)
        times.append(time.process_time() - start)
    return {
        "title": title,
        "stop": stop,
        "seconds": min(times),
        "error": _error(model, motion, n, stop),
        "energy": None if title in ("A03", "A05") else float(np.ptp(motion.energy)) / SIZES[title],
        "steps": motion.statistics.steps,
        "published": PUBLISHED.get(title) if stop != 20.0 else None,
    }


def _error(model: lagdsl.Model, motion: lagdsl.Trajectory, n: int | None, stop: float) -> float:
    """The largest error of a coordinate. A02: of an upright, by the pendulum that a row of parallel bars is."""
    if n is not None:
        return float(np.max(np.abs(motion["up[1]"] - _upright(n, motion.time))))
    exact = model.simulate(stop=stop, interval=stop / ROWS, tolerance=FINE)
    return max(float(np.max(np.abs(motion[name] - exact[name]))) for name in model.coordinates)


def _upright(n: int, times: np.ndarray) -> np.ndarray:
    from scipy.integrate import solve_ivp

    factor = -9.81 * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)
    found = solve_ivp(
        lambda _, y: [y[1], factor * np.cos(y[0])],
        (0.0, times[-1]),
        [np.pi / 2, -1.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
        t_eval=times,
    )
    return np.asarray(found.y[0])
