"""Calls from Python: the seven-axis arm at one state, beside functions of the peers; many states; short runs."""

import statistics
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import contest
import numpy as np
import ours
import peers
import serial

import lagdsl

MODELS = Path(__file__).parents[1] / "models"
ROUNDS = 5
BLOCKS, CALLS = 200, 100
RUNS = ("double_pendulum", "robots/panda", "stewart_platform", "robot_arm")
STATES = (500, 2000, 20_000)
# Functions by what they compute, with our title.
KINDS = {
    "forward": "forward dynamics",
    "mass": "mass matrix",
    "inverse": "inverse dynamics",
    "jacobian": "Jacobian of the last frame",
    "energy": "energy",
}


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """CPU microseconds of a call: we and the peers in turns, each the median of least times."""
    arm = serial.panda(7)
    q, qd, qdd = states(7)
    rounds: list[dict[str, float]] = []
    errors: dict[str, float] = {}
    for k in range(ROUNDS):
        say(f"calls: round {k + 1} of {ROUNDS}")
        times, values = _ours(q, qd, qdd)
        told = peers.calls("panda", 7, _xml(arm)) if peers.where() else {"times": {}, "values": {}}
        errors |= {name: _error(values[name.rpartition(" ")[2]], np.array(v)) for name, v in told["values"].items()}
        rounds.append(times | told["times"])
    say("calls: batch, runs of 1 ms")
    return {
        "times": {name: statistics.median(each[name] for each in rounds) for name in rounds[0]},
        "errors": errors,
        "batch": [_batch(count) for count in STATES],
        "runs": {name: _run(name) for name in RUNS},
    }


def states(n: int) -> np.ndarray:
    """q, qd, qdd (3, n) of the one state."""
    return np.random.default_rng(11).uniform(-1.0, 1.0, (3, n))


def least(call: Callable[[], object], blocks: int = BLOCKS, calls: int = CALLS) -> float:
    """Least CPU microseconds of one call in a block of `calls`."""
    call()
    found = []
    for _ in range(blocks):
        start = time.process_time()
        for _ in range(calls):
            call()
        found.append(time.process_time() - start)
    return min(found) / calls * 1e6


def _ours(q: np.ndarray, qd: np.ndarray, qdd: np.ndarray) -> tuple[dict[str, float], dict[str, np.ndarray]]:
    model = _arm()
    last = model.frame("a7.link")
    calls: dict[str, Callable[..., np.ndarray]] = {
        "forward": lambda: model.forward_dynamics(0.0, q, qd),
        "mass": lambda: model.mass_matrix(0.0, q),
        "inverse": lambda: model.inverse_dynamics(0.0, q, qd, qdd),
        "jacobian": lambda: last.jacobian(0.0, q),
        "energy": lambda: model.energy(0.0, q, qd),
    }
    values = {kind: call() for kind, call in calls.items()}
    into = {
        "forward": lambda out: model.forward_dynamics(0.0, q, qd, out=out),
        "mass": lambda out: model.mass_matrix(0.0, q, out=out),
        "inverse": lambda out: model.inverse_dynamics(0.0, q, qd, qdd, out=out),
        "jacobian": lambda out: last.jacobian(0.0, q, out=out),
        "energy": lambda out: model.energy(0.0, q, qd, out=out),
    }
    times = {f"lagdsl {kind}": least(call) for kind, call in calls.items()}
    rooms = {kind: np.empty_like(value) for kind, value in values.items()}
    return times | {f"lagdsl-out {kind}": least(partial(call, rooms[kind])) for kind, call in into.items()}, values


def _arm() -> lagdsl.Model:
    return lagdsl.compile(ours.MODELS / "panda.lag", engine="c")


def _xml(arm: serial.Arm) -> Path:
    path = contest.folder() / f"arm_{len(arm.links)}.xml"
    path.write_text(serial.mjcf(arm))
    return path


def _error(mine: np.ndarray, theirs: np.ndarray) -> float:
    return float(np.max(np.abs(mine - theirs)) / max(1.0, float(np.max(np.abs(mine)))))


def _batch(count: int) -> dict[str, Any]:
    """Wall nanoseconds of a state: one thread, and the number of threads that is left to us."""
    model, drawn = _arm(), serial.states(7, count, seed=3)
    q, qd = np.ascontiguousarray(drawn[:, :7]), np.ascontiguousarray(drawn[:, 7:])
    found: dict[str, Any] = {"count": count}
    for label, threads in (("one", 1), ("default", None)):
        work = partial(model.batch, 0.0, q, qd, threads=threads)
        work()
        walls = []
        for _ in range(max(20, 400_000 // count)):
            start = time.perf_counter()
            work()
            walls.append(time.perf_counter() - start)
        found[label] = min(walls) / count * 1e9
    return found


def _run(name: str) -> float:
    """CPU milliseconds of `simulate` over 1 ms with two rows."""
    model = lagdsl.compile(MODELS / f"{name}.lag", engine="c")
    stop = model.initial_state().t + 1e-3
    return least(partial(model.simulate, stop=stop, interval=1e-3), blocks=100, calls=1) / 1e3


def section(found: dict[str, Any]) -> list[str]:
    """Of README.md."""
    times, errors = found["times"], found["errors"]
    who = [name for name in ("lagdsl", "lagdsl-out", "pinocchio", "casadi", "mujoco") if _has(times, name)]
    titles = {"lagdsl-out": "lagdsl, `out=`", "pinocchio": "Pinocchio", "casadi": "CasADi", "mujoco": "MuJoCo"}
    lines = ["## Single calls from Python", ""]
    lines += ["The seven-axis arm at one state, CPU microseconds of a call in Python: least time of 200 blocks of 100"]
    lines += [
        f"calls, medians of {ROUNDS} rounds in which we and the peers take turns. MuJoCo is `mj_forward` after new"
    ]
    lines += ["positions and rates, CasADi its function of Lagrange's equations, without generated C.", ""]
    lines += ["| |" + "".join(f" {titles.get(name, name)} |" for name in who), "|---|" + "---|" * len(who)]
    for kind, title in KINDS.items():
        cells = (times.get(f"{name} {kind}") for name in who)
        lines.append(f"| {title} |" + "".join(" |" if cell is None else f" {cell:.2f} |" for cell in cells))
    if errors:
        lines += ["", f"Largest difference to a peer, relatively: {max(errors.values()):.0e}."]
    lines += [
        "",
        "`model.batch` of the arm, wall nanoseconds of a state, and `simulate` over 1 ms from a known start, CPU ms:",
        "",
    ]
    lines += ["| states | one thread | threads by default |", "|---|---|---|"]
    lines += [f"| {row['count']} | {row['one']:.0f} | {row['default']:.0f} |" for row in found["batch"]]
    lines += ["", "| model | a run of 1 ms [ms] |", "|---|---|"]
    return lines + [f"| `{name}` | {value:.2f} |" for name, value in found["runs"].items()]


def _has(times: dict[str, float], name: str) -> bool:
    return any(label.split()[0] == name for label in times)
