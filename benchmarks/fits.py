"""Fits of a rotary pendulum with a motor: their cost, and how often intervals of 95 % hold the truth."""

import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import lagdsl

HERE = Path(__file__).parent
MODEL = HERE / "models" / "furuta_motor.lag"
TRUTH = {"J": 2.4e-3, "m": 0.11, "l": 0.14, "d": 1.5e-3, "c": 3e-4}
TIMES = np.linspace(0.0, 10.0, 2000)
VOLTAGE = 3.0 * np.sin(2.0 * TIMES) + 2.0 * np.sin(7.0 * TIMES + 0.3 * TIMES**2)
SIGMA = np.radians(0.5)
REPETITIONS = 1000


def measurement(model: lagdsl.Model) -> Callable[[np.random.Generator], dict[str, np.ndarray]]:
    """Draws of measured angles of the true pendulum; it begins to swing from 0.5 rad, the voltage is known."""
    motion = model.simulate(times=TIMES, parameters=TRUTH, inputs={"u": (TIMES, VOLTAGE)})

    def drawn(random: np.random.Generator) -> dict[str, np.ndarray]:
        measured = {name: motion[name] + random.normal(0.0, SIGMA, len(TIMES)) for name in ("phi", "theta")}
        return {"time": TIMES, "u": VOLTAGE, **measured}

    return drawn


def held_truth(repetitions: int, seed: int) -> tuple[dict[str, float], list[float]]:
    """Parts of the fits whose interval holds the truth, by name, and CPU seconds of each fit."""
    model = lagdsl.compile(MODEL)
    drawn, random = measurement(model), np.random.default_rng(seed)
    held, seconds = dict.fromkeys(TRUTH, 0), []
    for _ in range(repetitions):
        data = drawn(random)
        started = time.process_time()
        found = model.fit(data, list(TRUTH))
        seconds.append(time.process_time() - started)
        for name, (low, high) in found.intervals.items():
            held[name] += low <= TRUTH[name] <= high
    return {name: count / repetitions for name, count in held.items()}, seconds


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """Of REPETITIONS fits, each of a measurement with noise of its own."""
    say(f"fits: {REPETITIONS} of a rotary pendulum")
    held, seconds = held_truth(REPETITIONS, 11)
    return {"repetitions": REPETITIONS, "held": held, "seconds": statistics.median(seconds)}


def section(found: dict[str, Any]) -> list[str]:
    """Of README.md."""
    parts = ", ".join(f"{name} {100.0 * part:.1f}" for name, part in found["held"].items())
    return [
        "## Fits",
        "",
        "`model.fit` of five parameters of a rotary pendulum with a motor, `benchmarks/models/furuta_motor.lag`,",
        f"to 2000 rows of two noisy angles: {found['seconds']:.2f} CPU s, the median of {found['repetitions']} fits.",
        f"Intervals of 95 % hold the truth in {parts} % of them.",
    ]
