"""The targets of elimination, of the C that is generated and of what runs it, and what was measured."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import auto
import motion
from growth import exponent

Results = dict[str, Any]
Figure = float | None


@dataclass(frozen=True)
class Target:
    """A line of the table; nothing to read where a part was not measured or a peer is missing."""

    text: str
    must: tuple[float, ...]
    stretch: tuple[float, ...]
    measured: tuple[Figure, ...]
    part: str
    pattern: str = "{:.2f}"

    @property
    def reached(self) -> str:
        """stretch, must, missed, or nothing."""
        if None in self.measured:
            return ""
        figures = [figure for figure in self.measured if figure is not None]
        if all(figure <= limit for figure, limit in zip(figures, self.stretch, strict=True)):
            return "stretch"
        return "must" if all(f <= limit for f, limit in zip(figures, self.must, strict=True)) else "**missed**"


def targets(found: Results) -> list[Target]:
    """All of them, in the order of the table."""
    text, chain, growth = _text(found), _chain(found), _growth(found)
    arm = _ratios(found.get("arm", {}).get("contest"))
    planar, spatial = text("planar_chain", 100), text("spatial_chain", 100)
    casadi = (found.get("text") or {}).get("casadi")
    fifty = text("planar_chain", 50)
    share = None
    if casadi and fifty:
        share = (fifty["python"] + fifty["compiler"]) / (casadi["python"] + casadi["compiler"])
    return [
        Target(
            "100-link planar chain, text to library: Python / cc [CPU s]", (1.5, 1.0), (0.5, 0.3), _cpu(planar), "text"
        ),
        Target("100-link spatial chain: Python / cc [CPU s]", (3, 1.5), (1, 0.5), _cpu(spatial), "text"),
        Target(
            "exponent of Python time, N = 20 to 500: planar / spatial chain",
            (1.25, 1.25),
            (1.1, 1.1),
            (growth("planar_chain", "python"), growth("spatial_chain", "python")),
            "growth",
        ),
        Target(
            "flops per link at N = 100: planar / spatial",
            (75, 400),
            (56, 361),
            (_per_link(planar), _per_link(spatial)),
            "text",
            "{:.1f}",
        ),
        Target(
            "evaluation against Pinocchio's ABA, N = 100: planar / spatial",
            (0.20, 0.35),
            (0.09, 0.20),
            (chain("planar_chain", 100, "pinocchio"), chain("spatial_chain", 100, "pinocchio")),
            "chains",
            "{:.3f}",
        ),
        Target(
            "7-axis arm: forward dynamics against Pinocchio's ABA",
            (0.25,),
            (0.12,),
            (arm("pinocchio"),),
            "arm",
            "{:.3f}",
        ),
        Target(
            "the same against CasADi's Lagrange as C at its best flags",
            (0.65,),
            (0.45,),
            (arm("casadi"),),
            "arm",
            "{:.3f}",
        ),
        Target(
            "50-link chain, text to optimized library, against CasADi as C with `-O0`", (0.5,), (0.1,), (share,), "text"
        ),
        Target(
            "10-link chain, evaluation against CasADi's best C",
            (0.8,),
            (0.55,),
            (chain("planar_chain", 10, "casadi"),),
            "chains",
            "{:.3f}",
        ),
        Target(
            "the arm typed as plain scalar energies, against Pinocchio's ABA",
            (0.5,),
            (0.24,),
            (arm("scalars pinocchio"),),
            "arm",
            "{:.3f}",
        ),
        Target(
            "qdd and its state Jacobian, 7-axis arm, against `computeABADerivatives`",
            (0.5,),
            (0.17,),
            (arm("jacobian"),),
            "arm",
            "{:.3f}",
        ),
        Target(
            "batch, 7-axis arm: per state against a single one, one core",
            (0.35,),
            (0.17,),
            (arm("batch"),),
            "arm",
            "{:.3f}",
        ),
        Target(
            "relative error against Pinocchio, N up to 100, 2000 random states",
            (1e-11,),
            (1e-13,),
            (_worst(found),),
            "accuracy",
            "{:.0e}",
        ),
        Target(
            "beam in absolute angles: exponent of Python time, N = 10 to 80",
            (1.5,),
            (1.2,),
            (growth("beam", "python"),),
            "growth",
        ),
        Target(
            "chain of N four-bar linkages: exponent of the time of an evaluation, N = 5 to 80",
            (1.6,),
            (1.1,),
            (growth("four_bars", "evaluation"),),
            "growth",
        ),
        *_calls(found.get("calls", {})),
        *_steps(found.get("steps", {})),
        *_derivatives(found.get("tangents", {})),
        *_starts(found.get("start", {})),
        *_motions(found),
        *_tapes(found),
        *_whole(found),
        Target(
            "7-axis arm as an FMU of one platform, when it is new [CPU s]",
            (10,),
            (5,),
            (found.get("fmus", {}).get("new"),),
            "fmus",
        ),
        Target(
            "communication step of an FMU beyond the integrator, from C [ns]",
            (200,),
            (50,),
            (found.get("fmus", {}).get("step"),),
            "fmus",
            "{:.0f}",
        ),
        *(_living_pages(found["living_page"]) if "living_page" in found else []),
    ]


def _living_pages(found: Results) -> list[Target]:
    double, ten, hundred = found["rows"]
    return [
        Target(
            "living page of the double pendulum / of ten links, 10 s [kB]",
            (1200, 1600),
            (600, 800),
            (double["bytes"] / 1e3, ten["bytes"] / 1e3),
            "living_page",
            "{:.0f}",
        ),
        Target("its first picture [ms]", (1000,), (300,), (double["first"],), "living_page", "{:.0f}"),
        Target(
            "10 s of double pendulum anew at the move of a slider [ms]",
            (16,),
            (4,),
            (double["waited"],),
            "living_page",
            "{:.1f}",
        ),
        Target(
            "a picture of 100 links, drawn by software [ms]", (50,), (17,), (1e3 / hundred["frames"],), "living_page"
        ),
    ]


def _calls(found: Results) -> list[Target]:
    times, runs = found.get("times", {}), found.get("runs", {})
    kinds = ("forward", "mass", "inverse", "jacobian")
    ours = tuple(times.get(f"lagdsl {kind}") for kind in kinds)
    theirs = times.get("pinocchio forward")
    ratio = ours[0] / theirs if ours[0] and theirs else None
    ahead = [row["default"] / row["one"] for row in found.get("batch", [])]
    return [
        Target(
            "a call in Python at one state, 7-axis arm: forward dynamics / M / inverse dynamics / Jacobian [us]",
            (3, 3, 3, 3),
            (1.6, 1.6, 1.6, 1.6),
            ours,
            "calls",
        ),
        Target("forward dynamics, against Pinocchio's ABA, both from Python", (1,), (0.8,), (ratio,), "calls"),
        Target(
            "`simulate` over 1 ms: double pendulum / panda / Stewart platform / robot arm [ms]",
            (0.1, 0.2, 0.3, 0.3),
            (0.05, 0.1, 0.15, 0.15),
            tuple(runs.get(name) for name in ("double_pendulum", "robots/panda", "stewart_platform", "robot_arm")),
            "calls",
        ),
        Target(
            "`batch` with its own number of threads against one, worst of 500 to 20 000 states",
            (1.05,),
            (1.0,),
            (max(ahead, default=None),),
            "calls",
        ),
    ]


def _steps(found: Results) -> list[Target]:
    own = found.get("runtime")
    above = found["session"] - own if own else None
    ratio = found["session"] / found["fmpy"] if own else None
    return [
        Target("a step of a session above the integrator, double pendulum [us]", (10,), (3,), (above,), "steps"),
        Target("the same, all of it, against an FMU under FMPy", (1,), (0.8,), (ratio,), "steps"),
    ]


def _derivatives(found: Results) -> list[Target]:
    def runs(name: str) -> tuple[Figure, ...]:
        engines = found.get("rows", {"auto": {}, "c": {}}).values()
        return tuple(rows[name]["tangents"] / rows[name]["run"] if name in rows else None for rows in engines)

    rows = (
        ("derivatives of 10 s of double pendulum by 8 quantities, in runs: auto / c", "double pendulum", (3.5, 3.0)),
        ("the same by 10, with gravity and friction", "with gravity and friction", (3.5, 3.0)),
        ("a motion of the 7-axis arm by 70 inertial parameters", "7-axis arm", (12.0, 8.0)),
        ("stiff slider-crank by 10 parameters, Radau", "stiff slider-crank", (4.0, 2.0)),
        ("slider-crank with elastic rod by 10 parameters, Radau", "slider-crank with elastic rod", (4.0, 3.0)),
    )
    return [
        Target(text, (must,) * 2, (stretch,) * 2, runs(name), "tangents", "{:.1f}")
        for text, name, (must, stretch) in rows
    ]


def _starts(found: Results) -> list[Target]:
    def ratio(ours: str, base: str) -> tuple[Figure]:
        return (found[ours] / found[base] if ours in found and base in found else None,)

    return [
        Target(
            "`lag run models/double_pendulum.lag`, nothing cached: CPU time against `import numpy, click, rich`",
            (3,),
            (2.5,),
            ratio("run", "base"),
            "start",
        ),
        Target(
            "`lag check` of ten lines: CPU time against `import numpy`", (4,), (3,), ratio("check", "numpy"), "start"
        ),
    ]


def _motions(found: Results) -> list[Target]:
    problems = found.get("runtime", {}).get("problems", {})

    def each(names: tuple[str, ...], figure: Callable[[Results], Figure]) -> tuple[Figure, ...]:
        return tuple(figure(problems[name]) if name in problems else None for name in names)

    chains, stiff = ("double_pendulum", "ten_links"), ("slider_crank", "oscillator")
    return [
        Target(
            "motions of 2 / 10 links to 1e-6, C runtime: time against CasADi's CVODES",
            (0.15, 0.15),
            (0.05, 0.05),
            each(chains, lambda problem: motion.time_ratio(problem, "CVODES")),
            "runtime",
            "{:.3f}",
        ),
        Target(
            "the same against SciPy's DOP853 with Numba",
            (0.03, 0.03),
            (0.01, 0.01),
            each(chains, lambda problem: motion.time_ratio(problem, "SciPy")),
            "runtime",
            "{:.3f}",
        ),
        Target(
            "stiff slider-crank / van der Pol: right-hand sides against the best CVODE, worst of all accuracies",
            (0.85, 0.85),
            (0.7, 0.7),
            each(stiff, motion.worst_count),
            "runtime",
        ),
    ]


def _tapes(found: Results) -> list[Target]:
    calls = {row["model"]: row for row in found.get("tape", {}).get("calls", [])}
    built = {(row["model"], row["n"]): row["python"] for row in found.get("tape", {}).get("built", [])}

    def all_of(figure: str) -> tuple[Figure, ...]:
        names = ("double_pendulum", "four_bar", "panda")
        return tuple(calls[name][figure] if name in calls else None for name in names)

    return [
        Target(
            "tape of the 7-axis arm: an instruction against a product and sum through memory",
            (2.0,),
            (1.2,),
            (all_of("of chain")[2],),
            "tape",
        ),
        Target(
            "a call on the tape against compiled C: double pendulum / four-bar / arm",
            (6.0,) * 3,
            (3.0,) * 3,
            all_of("ratio"),
            "tape",
        ),
        Target("the same in lanes, per state", (1.0,) * 3, (0.5,) * 3, all_of("lanes ratio"), "tape"),
        Target(
            "tape of the 100-link spatial chain, after derivation [CPU s]",
            (0.3,),
            (0.1,),
            (built.get(("spatial_chain", 100)),),
            "tape",
        ),
    ]


def _whole(found: Results) -> list[Target]:
    chosen = found.get("auto", {})
    rows, least = chosen.get("rows", []), chosen.get("least", 0.0)
    return [
        Target(
            "`auto` against the better of tape and C, worst model of `models/`: cold / warm cache",
            (auto.MOST,) * 2,
            (1.15,) * 2,
            (auto.worst(rows, "cold", least), auto.worst(rows, "warm", least)),
            "auto",
        ),
        Target(
            "`lag sweep`: 10 000 double pendulums, 10 s to 1e-6 [s wall]",
            (8,),
            (4,),
            (found.get("ensembles", {}).get("wall"),),
            "ensembles",
            "{:.1f}",
        ),
        Target(
            "motor, gear, slider-crank, PID of 5 ms, 5 s [s wall]",
            (1,),
            (0.5,),
            (found.get("drive", {}).get("wall"),),
            "drive",
        ),
    ]


def _text(found: Results) -> Callable[[str, int], Results | None]:
    rows = {(row["model"], row["n"]): row for row in found.get("text", {}).get("rows", [])}
    return lambda name, n: rows.get((name, n))


def _chain(found: Results) -> Callable[[str, int, str], Figure]:
    rows = {(row["model"], row["n"]): row for row in found.get("chains", {}).get("rows", [])}
    return lambda name, n, peer: _ratios(rows.get((name, n)))(peer)


def _ratios(row: Results | None) -> Callable[[str], Figure]:
    return lambda peer: (row or {}).get("ratios", {}).get(peer)


def _growth(found: Results) -> Callable[[str, str], Figure]:
    """Exponents; none where the curve ended early."""
    curves = found.get("growth", {}).get("curves", {})
    return lambda name, figure: exponent(curves.get(name, []), figure)


def _cpu(row: Results | None) -> tuple[Figure, Figure]:
    return (row["python"], row["compiler"]) if row else (None, None)


def _per_link(row: Results | None) -> Figure:
    return row["flops"] / row["n"] if row and row["flops"] is not None else None


def _worst(found: Results) -> Figure:
    errors = [row.get("lagdsl to pinocchio", {}).get("worst") for row in found.get("accuracy", {}).get("rows", [])]
    return max(errors) if errors and None not in errors else None


def table(lines: Sequence[Target]) -> list[str]:
    """In Markdown."""
    rows = ["| | must | stretch | measured | reached |", "|---|---|---|---|---|"]
    for line in lines:
        must, stretch = (" / ".join(f"{limit:g}" for limit in limits) for limits in (line.must, line.stretch))
        measured = " / ".join("-" if figure is None else line.pattern.format(figure) for figure in line.measured)
        rows.append(f"| {line.text} | {must} | {stretch} | {measured} | {line.reached} |")
    return rows
