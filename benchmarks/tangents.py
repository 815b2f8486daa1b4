"""Derivatives of motions by parameters and start values: their cost in runs without them, and CVODES beside it."""

import json
import statistics
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import peers

import lagdsl

HERE = Path(__file__).parent
PENDULUM = HERE.parent / "models" / "double_pendulum.lag"
STARTS = ("a.start", "b.start", "der(a).start", "der(b).start")
ROUNDS = 61  # a run of a millisecond is not repeated to better than some percent
# Gravity and friction are two more quantities of the double pendulum.
TEN = (
    ("gravity = -g_n*world.y;", "gravity = -g*world.y;"),
    (
        "coordinate Angle a",
        "parameter Acceleration g = 9.80665 m/s2;\n  parameter Damping c = 0;\n  coordinate Angle a",
    ),
    ("mass m1 at P1;", "mass m1 at P1;\n  dissipation 1/2*c*(1 m2)*der(a)^2;"),
)
CASADI = [10.0**-k for k in range(5, 13)]


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """CPU seconds of a run and of one with derivatives: medians of rounds in which both take turns."""
    rows = {}
    for engine in ("auto", "c"):
        say(f"tangents: engine {engine}")
        rows[engine] = {name: row(engine) for name, row in ROWS.items()}
    return {"rows": rows, "cvodes": _cvodes(say)}


def _double_pendulum(engine: str) -> dict[str, float]:
    model = lagdsl.compile(PENDULUM, engine=engine)
    return _compared(model, [*model.parameters, *STARTS], stop=10, solver="dop853")


def _ten(engine: str) -> dict[str, float]:
    text = PENDULUM.read_text()
    for old, new in TEN:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    model = lagdsl.compile(text, engine=engine)
    return _compared(model, [*model.parameters, *STARTS], stop=10, solver="dop853")


def _arm(engine: str) -> dict[str, float]:
    model = lagdsl.compile(HERE / "models" / "panda.lag", engine=engine)
    start = {name: 0.2 * (k + 1) for k, name in enumerate(model.coordinates)}
    return _compared(model, list(model.parameters), start=start, stop=2, interval=0.02, tolerance=1e-8)


def _stiff(engine: str) -> dict[str, float]:
    model = lagdsl.compile(HERE / "models" / "stiff_slider_crank.lag", engine=engine)
    return _compared(model, list(model.parameters)[:10], solver="radau")


def _elastic(engine: str) -> dict[str, float]:
    model = lagdsl.compile(HERE / "models" / "elastic_slider_crank.lag", engine=engine)
    return _compared(model, list(model.parameters)[:10], solver="radau")


ROWS: dict[str, Callable[[str], dict[str, float]]] = {
    "double pendulum": _double_pendulum,
    "with gravity and friction": _ten,
    "7-axis arm": _arm,
    "stiff slider-crank": _stiff,
    "slider-crank with elastic rod": _elastic,
}


def _compared(model: lagdsl.Model, names: Sequence[str], **terms: Any) -> dict[str, float]:
    def timed(tangents: Sequence[str]) -> tuple[float, int]:
        start = time.process_time()
        motion = model.simulate(tangents=tangents, **terms)
        return time.process_time() - start, motion.statistics.steps

    for _ in range(3):  # whatever is made in the background is there then
        timed(names)
        timed(())
    rounds = [(timed(()), timed(names)) for _ in range(ROUNDS)]
    run, with_them = (statistics.median(each[which][0] for each in rounds) for which in (0, 1))
    steps = {"steps": rounds[0][0][1], "steps with derivatives": rounds[0][1][1]}
    return {"columns": len(names), "run": run, "tangents": with_them, **steps}


def _cvodes(say: Callable[[str], None]) -> dict[str, float] | None:
    """The shortest run of CVODES whose derivatives at 10 s are no worse than ours at the tolerance of the text."""
    if "casadi" not in peers.where():
        return None
    say("tangents: CVODES by CasADi")
    model = lagdsl.compile(PENDULUM, engine="c")
    reference, own = (_derivatives(model, tolerance) for tolerance in (1e-13, 1e-10))
    error = float(np.abs(own - reference).max())
    found = json.loads(peers.run("tangents", "10", json.dumps(CASADI)))
    errors = [float(np.abs(np.array(row["derivatives"]) - reference).max()) for row in found]
    equal = [row for row, each in zip(found, errors, strict=True) if each <= error]
    best = min(equal or found[-1:], key=lambda row: float(row["tangents"]))
    return {"own error": error, "error": errors[found.index(best)], "run": best["run"], "tangents": best["tangents"]}


def _derivatives(model: lagdsl.Model, tolerance: float) -> np.ndarray:
    names = ["m1", "m2", "l1", "l2", *STARTS]
    motion = model.simulate(stop=10, tolerance=tolerance, tangents=names)
    of = ("a", "b", "der(a)", "der(b)")
    return np.array([[motion.derivative(each, name)[-1] for name in names] for each in of])


def section(found: dict[str, Any]) -> list[str]:
    """Of README.md."""
    lines = ["## Derivatives of motions", ""]
    lines += [
        "`simulate(tangents=...)` at the tolerance of the text against the same run without: CPU time, medians of"
    ]
    lines += [f"{ROUNDS} rounds in which both take turns.", ""]
    lines += [
        "| | columns | engine | a run [ms] | with derivatives [ms] | runs | steps |",
        "|---|---|---|---|---|---|---|",
    ]
    for name in ROWS:
        for engine, rows in found["rows"].items():
            if name not in rows:
                continue
            row = rows[name]
            own = f"{row['run'] * 1e3:.2f} | {row['tangents'] * 1e3:.2f} | {row['tangents'] / row['run']:.1f}"
            lines += [f"| {name} | {row['columns']} | {engine} | {own} | {row['steps with derivatives']} |"]
    peer = found["cvodes"]
    if peer is None:
        return lines
    lines += ["", "CVODES by CasADi, forward sensitivities of the double pendulum at equal error of the derivatives"]
    lines += [f"({peer['own error']:.0e} here, {peer['error']:.0e} there): {peer['tangents'] * 1e3:.0f} ms,"]
    return [*lines, f"{peer['tangents'] / peer['run']:.0f} of its own runs."]
