"""README.md from the results of the parts."""

from collections.abc import Sequence

import auto
import calls
import fits
import living_page
import motion
import sizes_page
import steps
import tangents
from dynamics import OURS, family, ratio_name
from problems import ROWS
from targets import Results, table, targets

PEERS = (
    ("pinocchio", "Pinocchio ABA"),
    ("pinocchio_casadi", "Pinocchio by CasADi"),
    ("mujoco", "MuJoCo"),
    ("casadi", "CasADi, Lagrange"),
)
_HEAD = """# Benchmarks

Written by `make bench` from `results/`; `benchmarks/run.py --only arm,text` measures some parts anew.

Compile times are CPU seconds, medians of several fresh processes, imports not counted. Evaluations: all contestants in
one process, in turns, blocks of 0.1 ms, least time of 400 blocks; a ratio is formed within a process, the median over
five processes is told; below 1 lagdsl is faster. Before anything is timed its results are compared with those of an
independent formulation in extended precision (`oracle.py`, `planar.py`); what disagrees has no time.

Peers: Pinocchio's articulated-body algorithm, as its package has it and compiled for this machine from its headers, the
faster counts; the same algorithm on CasADi's expressions, generated as C; MuJoCo's `mj_forward` and, apart, only the
parts that accelerations need; Lagrange's equations by CasADi, energies typed by hand in space and, for planar chains,
in the plane, generated as C and compiled with six sets of flags, the best counts. lagdsl is what `engine="c"` gives;
its masses and inertias can be changed at run time, those of generated C are numbers. In rows "with `--fix '*'`"
they are numbers here, too."""


def page(found: dict[str, Results]) -> str:
    """All of it."""
    lines = [
        _HEAD,
        "",
        *_where(found),
        "",
        "## Targets",
        "",
        *table(targets(found)),
        "",
        *_limits(found),
        *_noise(found),
    ]
    for key, section in (
        ("arm", _arm),
        ("calls", calls.section),
        ("steps", steps.section),
        ("tangents", tangents.section),
        ("fits", fits.section),
        ("chains", _chains),
        ("text", _text),
        ("growth", _growth),
        ("sizes", sizes_page.sizes),
        ("iftomm", sizes_page.iftomm),
        ("accuracy", _accuracy),
        ("start", _start),
        ("auto", _auto),
        ("tape", _tape),
        ("runtime", _runtime),
        ("ensembles", _ensembles),
        ("drive", _drive),
        ("fmus", _fmus),
        ("living_page", living_page.section),
    ):
        if key in found:
            lines += ["", *section(found[key])]
    return "\n".join(lines) + "\n"


def summary(found: dict[str, Results]) -> str:
    """The table of targets alone."""
    return "\n".join(table(targets(found)))


def _limits(found: dict[str, Results]) -> list[str]:
    """The reason why a figure misses its target."""
    missed = {line.text for line in targets(found) if line.reached == "**missed**"}
    if not any(text.startswith("10-link chain, evaluation") for text in missed):
        return []
    (row,) = [row for row in found["chains"]["rows"] if (row["model"], row["n"]) == ("planar_chain", 10)]
    times = row["times"]["forward"]
    exact = min(time for label, time in times.items() if family(label) == "casadi" and "fast-math" not in label)
    return [
        "The chain of 10 links: elimination goes from link to link and each step waits for the last (a flop takes",
        "twice as long as in a spatial chain), while CasADi forms a mass matrix of ten rows from independent sums. Its",
        "fastest C is compiled with `-ffast-math`, which reorders sums; lagdsl does not use it, because results are",
        "the same to the last bit in every form of a model. Against CasADi's best C without it the ratio is "
        f"{times['lagdsl'] / exact:.2f}.",
        "",
    ]


def _where(found: dict[str, Results]) -> list[str]:
    if not found:
        return ["Nothing has been measured."]
    last = max(found.values(), key=lambda part: str(part["date"]))
    versions = ", ".join(f"{name} {number}" for name, number in last["versions"].items())
    lines = [f"{last['cores']} cores, {last['system']}; processors stand below. {versions}."]
    absent = [name for name in ("pinocchio", "mujoco", "casadi") if name not in last["versions"]]
    if absent:
        lines += ["", f"Not installed, and left out: {', '.join(absent)} (`make peers`)."]
    return lines


def _noise(found: dict[str, Results]) -> list[str]:
    """When every part was measured, and whether the machine was quiet."""
    lines = ["| part | measured | commit | processor | load before / after |", "|---|---|---|---|---|"]
    for name, part in found.items():
        lines.append(
            f"| {name} | {part['date']} | {part['versions']['lagdsl']} | {part['processor']} "
            f"| {part['load']} / {part['load after']} |"
        )
    busy = [name for name, part in found.items() if max(part["load"], part["load after"]) > part["cores"]]
    if busy:
        lines += [
            "",
            f"Others were at work while {', '.join(busy)} ran (load above the number of cores): CPU times there are",
        ]
        lines += ["too long, by up to a half, and single ratios off by some percent."]
    return lines


def _contest(row: Results, ours: str = "lagdsl") -> list[str]:
    """Cells: our time, then time and ratio for each of PEERS."""
    times = row["times"].get("forward", {})
    cells = [_microseconds(times.get(ours))]
    for peer, _ in PEERS:
        theirs = [time for label, time in times.items() if family(label) == peer]
        ratio = row["ratios"].get(ratio_name(ours, peer))
        cells += [_microseconds(min(theirs, default=None)), "" if ratio is None else f"{ratio:.2f}"]
    return cells


def _contest_table(rows: Sequence[tuple[str, list[str]]]) -> list[str]:
    head = "| | lagdsl [us] |" + "".join(f" {title} [us] | ratio |" for _, title in PEERS)
    return [head, "|---|---|" + "---|---|" * len(PEERS), *(f"| {name} | " + " | ".join(c) + " |" for name, c in rows)]


def _arm(found: Results) -> list[str]:
    contest = found["contest"]
    times = contest["times"]
    lines = ["## The seven-axis arm", ""]
    titles = ("panda", "with `--fix '*'`", "typed as scalars", "typed as scalars, with `--fix '*'`")
    rows = [(title, ours) for title, ours in zip(titles, OURS, strict=True) if ours in times["forward"]]
    lines += _contest_table([(title, _contest(contest, ours)) for title, ours in rows])
    lines += ["", "| every contestant | ns | error |", "|---|---|---|"]
    for kind, entries in times.items():
        for label, time in sorted(entries.items(), key=lambda item: item[1]):
            lines.append(
                f"| {kind}: {label.replace('_', ' ')} | {time:.0f} | {contest['errors'][f'{label}/{kind}']:.0e} |"
            )
    single = times["forward"].get("lagdsl")
    lines += ["", "`model.batch`, 20 000 states (NumPy: 4000), called from Python; CPU time summed over threads:", ""]
    lines += ["| | wall [ns per state] | CPU [ns per state] | CPU, of a single one in C |", "|---|---|---|---|"]
    for row in found["batch"]:
        share = f"{row['cpu'] / single:.2f}" if single else ""
        lines.append(f"| {row['label']} | {row['wall']:.0f} | {row['cpu']:.0f} | {share} |")
    return lines


def _chains(found: Results) -> list[str]:
    lines = ["## Chains", "", "![chains](chains.png)", ""]
    rows = []
    for row in found["rows"]:
        rows.append((f"{row['model']} {row['n']}", _contest(row)))
        if "lagdsl_fixed" in row["times"].get("forward", {}):
            rows.append(("with `--fix '*'`", _contest(row, "lagdsl_fixed")))
    return lines + _contest_table(rows)


def _text(found: Results) -> list[str]:
    lines = ["## Text to library", "", f"CPU seconds, medians of {found['runs']} runs; all functions of the model.", ""]
    lines += ["| | Python | cc | C [kB] | flops of one forward dynamics |", "|---|---|---|---|---|"]
    for row in found["rows"]:
        flops = "" if row["flops"] is None else str(row["flops"])
        lines.append(
            f"| {row['model']} {row['n']} | {row['python']:.2f} | {row['compiler']:.2f} "
            f"| {row['size'] / 1000:.0f} | {flops} |"
        )
    if found["casadi"]:
        theirs = found["casadi"]
        lines += [
            "",
            f"CasADi, planar chain of 50 links, qdd alone, `{theirs['flags']}`: Python {theirs['python']:.2f},",
        ]
        lines += [f"cc {theirs['compiler']:.2f}."]
    return lines


def _growth(found: Results) -> list[str]:
    from growth import exponent

    lines = [
        "## Growth",
        "",
        f"Medians of {found['runs']} runs; exponents are least-squares slopes of the logarithms.",
        "",
    ]
    lines += ["![growth](growth.png)"]
    for name, points in found["curves"].items():
        lines += ["", f"| {name}: N | Python [CPU s] | cc [CPU s] | C [kB] | forward dynamics [us] | error |"]
        lines += ["|---|---|---|---|---|---|"]
        for p in points:
            error = "" if p["error"] is None else f"{p['error']:.0e}"
            lines.append(
                f"| {p['n']} | {p['python']:.2f} | {p['compiler']:.2f} | {p['size'] / 1000:.0f} "
                f"| {_microseconds(p['evaluation'])} | {error} |"
            )
        slopes = [exponent(points, key) for key in ("python", "compiler", "size", "evaluation")]
        lines.append("| exponent | " + " | ".join("" if s is None else f"{s:.2f}" for s in slopes) + " | |")
        last = [exponent(points[1:], key) for key in ("python", "compiler", "size", "evaluation")]
        if None not in last:
            lines.append("| without the first size | " + " | ".join(f"{s:.2f}" for s in last) + " | |")
    rows = {p["n"]: p["python"] for p in found["sympy"]}
    told = ", ".join(f"{n} links {seconds:.2f} s" for n, seconds in rows.items())
    return [*lines, "", f"SymPy `LagrangesMethod` and `lambdify`, planar chain, mass matrix and forcing: {told}."]


def _accuracy(found: Results) -> list[str]:
    lines = ["## Accuracy", ""]
    lines += [
        f"Errors over {found['states']} random states, angles all around, rates of 5 rad/s: worst (median), relative to"
    ]
    lines += ["the largest acceleration of the state.", ""]
    kinds = ("lagdsl to pinocchio", "lagdsl to exact", "pinocchio to exact")
    lines += ["| | " + " | ".join(kinds) + " |", "|---|---|---|---|"]
    for row in found["rows"]:
        cells = [f"{row[kind]['worst']:.0e} ({row[kind]['median']:.0e})" if kind in row else "" for kind in kinds]
        lines.append(f"| {row['model']} {row['n']} | " + " | ".join(cells) + " |")
    return lines


def _start(found: Results) -> list[str]:
    lines = ["## Starting", "", "| CPU s | | | ratio |", "|---|---|---|---|"]
    lines += [
        f"| `lag check models/pendulum.lag` against `import numpy`, whole processes | {found['check']:.3f} | "
        f"{found['numpy']:.3f} | {found['check'] / found['numpy']:.2f} (at most 4) |",
        f"| cart double pendulum, text to NumPy functions, against SymPy's `LagrangesMethod` | {found['ours']:.3f} | "
        f"{found['sympy']:.3f} | {found['ours'] / found['sympy']:.3f} (at most 0.1) |",
        "",
        "The hanging chain, text to program, all functions:",
        "",
        "| links | graph nodes | CPU s |",
        "|---|---|---|",
        *(f"| {row['n']} | {row['nodes']} | {row['seconds']:.3f} |" for row in found["chain"]),
        f"| exponent (below 2) | {found['nodes']:.2f} | {found['seconds']:.2f} |",
    ]
    return lines


def _runtime(found: Results) -> list[str]:
    lines = [
        "## Motions",
        "",
        "Errors are those of the state at the end, against an independent integration of equations typed by hand (van",
        "der Pol: the published values). Every integrator runs with tolerances half a decade apart.",
        "",
        f"Time for an error of at most {found['goal']:.0e}, the quickest run that has it, least of several:",
        "",
        "| | C runtime [ms] | `model.simulate` [ms] | CVODES by CasADi [ms] | ratio | SciPy, Numba [ms] | ratio |",
        "|---|---|---|---|---|---|---|",
    ]
    problems = found["problems"].values()
    lines += [_times(problem) for problem in problems if not problem["stiff"]]
    lines += [
        "",
        "Right-hand sides for an error, Newton iterations included, between the runs of the frontier; Jacobians apart.",
        "Where no run of lagdsl is so inexact, its cheapest counts.",
        f"An error is the largest at {ROWS} equidistant times of the motion, by the dense output of each.",
        "CVODE is the best of CasADi's and scikit-sundae's, exact Jacobian, three absolute tolerances.",
        "",
        "| | error | Radau | automatic | CVODE | Radau to CVODE |",
        "|---|---|---|---|---|---|",
    ]
    for problem in problems:
        if problem["stiff"]:
            automatic = {error: mine for error, mine, _ in motion.count_ratios(problem, "auto")}
            for error, mine, theirs in motion.count_ratios(problem):
                also = f"{automatic[error]:.0f}" if error in automatic else ""
                lines.append(
                    f"| {problem['title']} | {error:.0e} | {mine:.0f} | {also} | {theirs:.0f} | {mine / theirs:.2f} |"
                )
    lines += [
        "",
        "| Radau, stiff | tolerance | error | right-hand sides | Jacobians | steps |",
        "|---|---|---|---|---|---|",
    ]
    for problem in problems:
        for row in problem["rows"] if problem["stiff"] else []:
            if row["way"] == "radau" and row["error"] is not None:
                lines.append(
                    f"| {problem['title']} | {row['tolerance']:.1e} | {row['error']:.1e} | {row['evaluations']} "
                    f"| {row['jacobians']} | {row['steps']} |"
                )
    return lines


def _tape(found: Results) -> list[str]:
    lines = [
        "## Tapes",
        "",
        "Nanoseconds of one call of `elimination`, interpreted and compiled. A chain is one product and sum of",
        "doubles that waits in memory for the one before. Lanes run eight states at once.",
        "",
        "| | instructions | tape | C | ratio | an instruction / chain | lanes, per state | lanes / C |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in found["calls"]:
        lines.append(
            f"| {row['model']} | {row['instructions']:.0f} | {row['tape']:.0f} | {row['c']:.0f} | {row['ratio']:.2f} "
            f"| {row['of chain']:.2f} | {row['lanes']:.0f} | {row['lanes ratio']:.2f} |"
        )
    lines += ["", "| | tape built in [CPU s] | kB |", "|---|---|---|"]
    for row in found["built"]:
        lines.append(f"| {row['model']} {row['n'] or ''} | {row['python']:.3f} | {row['bytes'] / 1000:.0f} |")
    return lines


def _auto(found: Results) -> list[str]:
    rows, least = found["rows"], found["least"]
    lines = [
        "## The engine `auto`",
        "",
        "Every model of `models/`, from its program to the end of its experiment, CPU seconds with those of the",
        "compiler: the least of five, of one where that takes long. Cold: nothing lies in the cache; warm: libraries",
        "lie there. The ratio is that of `auto` to the better of tape and C; times below",
        f"{1e3 * least:.0f} ms count as that. The ten longest and the ten with the largest ratios:",
        "",
        "| | tape | C cold | `auto` cold | ratio | C warm | `auto` warm | ratio |",
        "|---|---|---|---|---|---|---|---|",
    ]

    def largest(row: Results) -> float:
        return max(auto.ratio(row, cache, least) for cache in ("cold", "warm"))

    longest = sorted(rows, key=lambda row: -row["tape"])[:10]
    apart = sorted(rows, key=lambda row: -largest(row))[:10]
    for row in (*longest, *(row for row in apart if row not in longest)):
        cold, warm = (auto.ratio(row, cache, least) for cache in ("cold", "warm"))
        lines.append(
            f"| {row['model']} | {row['tape']:.3f} | {row['c cold']:.3f} | {row['auto cold']:.3f} | {cold:.2f} "
            f"| {row['c warm']:.3f} | {row['auto warm']:.3f} | {warm:.2f} |"
        )
    within = sum(largest(row) <= auto.MOST for row in rows)
    return [*lines, "", f"Of {len(rows)} models {within} are within {auto.MOST:g} with both caches."]


def _ensembles(found: Results) -> list[str]:
    return [
        "## Sweeps",
        "",
        f"`lag sweep` of {found['runs']} motions of the double pendulum to a file, two parameters random, 10 s to",
        f"1e-6, 101 rows each: {found['wall']:.1f} s wall, the whole command, median of three.",
    ]


def _drive(found: Results) -> list[str]:
    return [
        "## A drive",
        "",
        "Motor, gear and slider-crank under a PID of 5 ms (`benchmarks/models/drive.lag`), 5 s to 1e-6:",
        f"`model.simulate` {found['wall']:.2f} s wall, the whole `lag run` {found['command']:.2f} s;",
        f"{found['steps']} steps.",
    ]


def _fmus(found: Results) -> list[str]:
    return [
        "## FMUs",
        "",
        "`lag fmu` for the machine it runs on: whole processes, compilers included; what all models share is there. A",
        "communication step: the difference of two runs whose integrator makes the same steps, with many and with few.",
        "",
        "| | |",
        "|---|---|",
        f"| the seven-axis arm, new [CPU s] | {found['new']:.2f} |",
        f"| the same once more [CPU s] | {found['again']:.2f} |",
        f"| a communication step of the double pendulum [ns] | {found['step']:.0f} |",
    ]


def _times(problem: Results) -> str:
    cells = [problem["title"], _milliseconds(motion.best(problem, "auto"))]
    cells.append(f"{1e3 * problem['simulate']:.2f}" if "simulate" in problem else "")
    for peer in ("CVODES", "SciPy"):
        ratio = motion.time_ratio(problem, peer)
        cells += [_milliseconds(motion.best(problem, peer)), "" if ratio is None else f"{ratio:.3f}"]
    return "| " + " | ".join(cells) + " |"


def _milliseconds(row: Results | None) -> str:
    return "" if row is None else f"{1e3 * row['seconds']:.2f}"


def _microseconds(nanoseconds: float | None) -> str:
    return "" if nanoseconds is None else f"{nanoseconds / 1000:.3g}"
