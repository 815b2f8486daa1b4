"""Forward dynamics against Pinocchio, MuJoCo and CasADi: the same physics, agreement first, then one run of all."""

import json
import resource
import statistics
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import loops
import numpy as np
import ours
import serial

RUNS = 3
CASES = [
    ("panda", None),
    ("panda_scalars", None),
    *(("planar_chain", n) for n in (2, 5, 10, 20, 50, 100)),
    *(("spatial_chain", n) for n in (2, 5, 10, 20, 50, 100)),
]
MANY = 2000
# Above it, C compilers take minutes for what CasADi writes when they optimize.
LARGEST_CASADI = 20
LARGEST_TUNED = 20
BEST_FLAGS = (("-O2",), ("-O3", "-march=native", "-ffast-math"))
AGREES = 1e-7  # of the largest acceleration; the table tells the figure itself


@dataclass
class Row:
    """Nanoseconds per call by what was called; errors against Pinocchio; CPU seconds of compilers."""

    model: str
    n: int
    times: dict[str, float] = field(default_factory=dict)
    errors: dict[str, float] = field(default_factory=dict)
    python: float = 0.0
    compiler: float = 0.0
    casadi_python: float = 0.0
    casadi_compiler: float = 0.0


def measure(cases: list[tuple[str, int | None]], progress: Callable[[str], None]) -> list[Row]:
    """A row for every case."""
    rows = []
    for name, size in cases:
        progress(f"{name} {size or ''}")
        rows.append(_row(name, size))
    return rows


def _row(name: str, size: int | None) -> Row:
    arm = serial.ARMS[name](size or 7)
    n = len(arm.links)
    folder = loops.FOLDER
    folder.mkdir(mode=0o700, exist_ok=True)
    states = folder / "states.txt"
    values = serial.states(n)
    serial.write_states(states, values)
    made, *tuned = ours.make(name, size, "cc", *(["cc -march=native"] if n <= LARGEST_TUNED else []))
    row = Row(name, n, python=made.python, compiler=made.compiler)
    commands: dict[str, tuple[list[str | Path], dict[str, str]]] = {
        "lagdsl": ([loops.loop("lagdsl"), made.library, made.symbol, states], {"forward": "", "jacobian": " J"}),
    }
    for each in tuned:
        commands["lagdsl native"] = ([loops.loop("lagdsl"), each.library, each.symbol, states], {"forward": ""})
    commands |= _peers(name, n, arm, states, row)
    found: dict[str, list[float]] = {}
    results: dict[str, np.ndarray] = {}
    for _ in range(RUNS):  # in turns, so that all see the same machine
        for label, (command, kept) in commands.items():
            timing = loops.run(command)
            results[label] = timing.forward()
            for each, suffix in kept.items():
                if each in timing.least:
                    found.setdefault(label + suffix, []).append(timing.least[each])
    row.times = {label: statistics.median(times) for label, times in found.items()}
    _compare(row, results, made, name)
    return row


def _peers(
    name: str, n: int, arm: serial.Arm, states: Path, row: Row
) -> dict[str, tuple[list[str | Path], dict[str, str]]]:
    """Commands of the peers that are installed, and which of their times to keep under which suffix."""
    commands: dict[str, tuple[list[str | Path], dict[str, str]]] = {}
    there, folder = loops.peers(), loops.FOLDER
    if "pinocchio" in there:
        (folder / "arm.txt").write_text(serial.numbers(arm))
        kept = {"aba_local": " local", "aba_world": " world", "derivatives": " J"}
        commands["pinocchio"] = ([loops.loop("pinocchio"), folder / "arm.txt", states], kept)
    if "mujoco" in there:
        (folder / "arm.xml").write_text(serial.mjcf(arm))
        commands["mujoco"] = ([loops.loop("mujoco"), folder / "arm.xml", states], {"mj_forward": ""})
    if "casadi" in there and name != "panda_scalars":
        text = folder / f"casadi_{name}_{n}.c"
        row.casadi_python = json.loads(loops.in_peers("casadi", name, str(n), text))["seconds"]
        for number, flags in enumerate(BEST_FLAGS if n <= LARGEST_CASADI else (("-O0",),)):
            library = text.with_suffix(f".{number}.so")
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(["cc", *flags, "-fPIC", "-shared", str(text), "-o", str(library), "-lm"], check=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            row.casadi_compiler = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            label = f"casadi {' '.join(flags)}"
            commands[label] = ([loops.loop("casadi"), library, states, str(n)], {"casadi": ""})
    return commands


def _compare(row: Row, results: dict[str, np.ndarray], made: ours.Made, name: str) -> None:
    """Errors relative to the largest acceleration of each state; whoever disagrees has no time."""
    reference = results.get("pinocchio", results["lagdsl"])
    size = np.max(np.abs(reference), axis=1, keepdims=True)
    for label, found in results.items():
        row.errors[label] = float(np.max(np.abs(found - reference) / size))
        if not row.errors[label] < AGREES:
            row.times = {key: value for key, value in row.times.items() if not key.startswith(label)}
    if "pinocchio" in results:
        row.errors["lagdsl, many"] = _many(made, name, row.n)


def _many(made: ours.Made, name: str, n: int) -> float:
    """The same over many random states."""
    values = serial.states(n, MANY, seed=2)
    given, out, rows = (loops.FOLDER / file for file in ("many.npy", "many_out.npy", "many.txt"))
    np.save(given, values)
    serial.write_states(rows, values)
    loops.in_peers("pinocchio", name, str(n), given, out)
    reference = np.load(out)
    found = loops.run([loops.loop("lagdsl"), made.library, made.symbol, rows, str(MANY)]).forward()
    return float(np.max(np.max(np.abs(found - reference), axis=1) / np.max(np.abs(reference), axis=1)))


def best(row: Row, peer: str) -> float | None:
    """The fastest variant of a peer, Jacobians apart."""
    times = [time for label, time in row.times.items() if label.split()[0] == peer and not label.endswith(" J")]
    return min(times, default=None)


def tables(rows: list[Row]) -> list[str]:
    """Times in microseconds and their ratios, agreement, compilers."""
    there = loops.peers()
    names = [name for name in ("pinocchio", "mujoco", "casadi") if name in there]
    missing = [name for name in ("pinocchio", "mujoco", "casadi") if name not in there]
    lines = ["## Forward dynamics of one state", ""]
    lines += [
        "qdd at 16 random states in turn, loops in C and C++, one core: least time per call over many short blocks, "
        f'median of {RUNS} runs taken in turns. `lagdsl` is compiled as `engine="c"` does, `native` with '
        "`-march=native`; ratios are those of the better of both to the better of the peer's variants. "
        "Peers: " + "; ".join([f"{name} {there[name]['version']}" for name in names] or ["none"]) + ".",
        "",
    ]
    if missing:
        lines += [f"Not installed, and left out: {', '.join(missing)} (`make peers`).", ""]
    lines += ["| model | joints | lagdsl [us] | native [us] |" + "".join(f" {n} [us] | ratio |" for n in names)]
    lines += ["|---|---|---|---|" + "---|---|" * len(names)]
    for row in rows:
        own = best(row, "lagdsl")
        cells = [_time(row.times.get("lagdsl")), _time(row.times.get("lagdsl native"))]
        for name in names:
            theirs = best(row, name)
            cells += [_time(theirs), f"{own / theirs:.2f}" if own and theirs else ""]
        lines.append(f"| {row.model} | {row.n} | " + " | ".join(cells) + " |")
    lines += [
        "",
        "### With the Jacobian",
        "",
        "qdd and its derivatives by q and qd; Pinocchio: `computeABADerivatives`.",
        "",
    ]
    lines += ["| model | joints | lagdsl [us] | Pinocchio [us] | ratio |", "|---|---|---|---|---|"]
    for row in rows:
        own, theirs = row.times.get("lagdsl J"), row.times.get("pinocchio J")
        if own and theirs:
            lines.append(f"| {row.model} | {row.n} | {_time(own)} | {_time(theirs)} | {own / theirs:.2f} |")
    lines += ["", "### Agreement", ""]
    lines += [
        f"Largest error, of the largest acceleration of a state, against Pinocchio, over 16 states; {MANY} for lagdsl.",
        "",
    ]
    lines += [f"| model | joints | lagdsl, {MANY} states | mujoco | casadi |", "|---|---|---|---|---|"]
    for row in rows:
        peers = [
            max((e for label, e in row.errors.items() if label.startswith(p)), default=None)
            for p in ("mujoco", "casadi")
        ]
        figures = [row.errors.get("lagdsl, many"), *peers]
        lines.append(
            f"| {row.model} | {row.n} | " + " | ".join("" if e is None else f"{e:.0e}" for e in figures) + " |"
        )
    lines += ["", "### Text to library", ""]
    lines += [
        "CPU seconds; all functions of the model for lagdsl, qdd alone for CasADi (last flags tried; above "
        f"{LARGEST_CASADI} joints `-O0`).",
        "",
    ]
    lines += ["| model | joints | lagdsl: Python | cc | CasADi: Python | cc |", "|---|---|---|---|---|---|"]
    for row in rows:
        theirs = [f"{row.casadi_python:.2f}", f"{row.casadi_compiler:.2f}"] if row.casadi_python else ["", ""]
        lines.append(f"| {row.model} | {row.n} | {row.python:.2f} | {row.compiler:.2f} | {theirs[0]} | {theirs[1]} |")
    return lines


def _time(nanoseconds: float | None) -> str:
    return "" if nanoseconds is None else f"{nanoseconds / 1000:.3g}"
