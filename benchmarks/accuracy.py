"""Errors of forward dynamics over many random states: against Pinocchio, and of both against extended precision."""

from collections.abc import Callable
from pathlib import Path

import contest
import numpy as np
import oracle
import ours
import peers
import serial

STATES = 2000
CASES = [
    ("panda", 7),
    ("panda_scalars", 7),
    *((name, n) for name in ("planar_chain", "spatial_chain") for n in (2, 5, 10, 20, 50, 100)),
]


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """Worst and median of the errors of the states, each relative to the largest acceleration of its state."""
    return {"rows": [_row(name, n, say) for name, n in CASES], "states": STATES}


def _row(name: str, n: int, say: Callable[[str], None]) -> dict[str, object]:
    say(f"accuracy: {name} {n}")
    arm = serial.ARMS[name](n)
    made = ours.make(name, None if name.startswith("panda") else n)
    values = serial.wide_states(n, STATES)
    states = contest.folder() / "accuracy.txt"
    serial.write_states(states, values)
    entry = contest.Contestant("lagdsl", "lagdsl", (made.library, *made.symbols, "forward"))
    found = contest.results(states, entry)["forward"]
    exact = np.concatenate([oracle.serial_arm(arm, part) for part in np.array_split(values, 10)])
    row: dict[str, object] = {"model": name, "n": n}
    _note(row, "lagdsl to exact", oracle.error(found, exact))
    if "pinocchio" in peers.where():
        theirs = _pinocchio(arm, states)
        _note(row, "lagdsl to pinocchio", oracle.error(found, theirs))
        _note(row, "pinocchio to exact", oracle.error(theirs, exact))
    return row


def _pinocchio(arm: serial.Arm, states: Path) -> np.ndarray:
    numbers = contest.folder() / "accuracy_arm.txt"
    numbers.write_text(serial.numbers(arm))
    entry = contest.Contestant("pinocchio", "pinocchio", (numbers, ""))
    runs = contest.hold(states, [entry], rounds=0, runs=1)
    return runs[0].results["pinocchio_local", "forward"]


def _note(row: dict[str, object], name: str, errors: np.ndarray) -> None:
    row[name] = {"worst": float(np.max(errors)), "median": float(np.median(errors))}
