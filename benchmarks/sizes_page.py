"""The sections of README.md on whole runs: in the size of the model, and the IFToMM benchmarks."""

from typing import Any

Results = dict[str, Any]
_SIZES = """\
CPU seconds of the derivation, of start values, of the motion behind them (projection and events in it), and the
growth of the memory of the process; tapes, least of several runs, BLAS with one thread. Exponents as above, of
all sizes; those of memory of the sizes with 16 MB and more, since memory of small models is noise of the process. They
belong to N, but to N^2 masses of a grid and to N (N - 1)/2 pairs of bodies. Sizes that would take longer than the time
of the part are left out. Strains of the beam with shear are differences of positions: behind 512 elements the round-off
of its forces is more than the default tolerance of 1e-8 admits, and all methods take steps of this noise."""
_NOISE = 16.0  # MB of memory
_EVENTS = """\
N balls have N times the events of one, at instants of their own. Each ball is an island: it has steps and instants of
its own, so N balls cost N times one (`docs/adr/0011`). Rows of all balls at the events of all are N^2 numbers; they are
made when somebody reads them.
An event with its step in evaluations, those of the step among them:"""
_IFTOMM = """\
A01 to A05 of the library of computational benchmark problems (M. Gonzalez, D. Dopico, U. Lugris, J. Cuadrado,
Multibody System Dynamics 16 (2006) 179), parameters from its specifications. Published: an implementation in
OpenSim 3.2 on an Intel Core i5-4570 at 3.2 GHz (L. Tagliapietra, M. Vivian, E. Ceseracciu, M. Reggiani, 2015),
as its pages give them; no other published CPU time was at hand. Error: of the coordinates [rad, m], A02 against
the pendulum that a row of parallel bars is, else against a tolerance of 1e-11; formulations typed by hand are
in `tests/physics/test_iftomm_benchmarks.py`. The library allows A02 errors of 1e-1 (low) and 1e-3 (high
precision). Energy: its change, as a part of its size. Tapes, tolerance 1e-8, 400 rows."""


def sizes(found: Results) -> list[str]:
    from growth import exponent
    from sizes import FAMILIES

    lines = ["## Whole runs in the size of the model", ""]
    lines += [_SIZES, "", "![sizes](sizes.png)"]
    for name, points in found["curves"].items():
        family = FAMILIES[name]
        lines += [
            "",
            f"| {family.title}, {family.stop:g} s: N "
            "| derivation | start | motion | start and motion | memory [MB] | steps |",
        ]
        lines += ["|---|---|---|---|---|---|---|"]
        rows = [{**p, "whole": p["start"] + p["motion"], "memory": p["memory"] or None} for p in points]
        for p in rows:
            lines.append(
                f"| {p['n']} | {p['derive']:.2f} | {p['start']:.4f} | {p['motion']:.4f} | {p['whole']:.4f} "
                f"| {p['memory'] or 0.0:.0f} | {p['steps']} |"
            )
        curve = [{**p, "n": family.parts(int(p["n"]))} for p in rows]
        slopes = [exponent(curve, key) for key in ("derive", "start", "whole")]
        slopes.append(exponent([p for p in curve if (p["memory"] or 0.0) >= _NOISE], "memory", least=3))
        told = ["" if slope is None else f"{slope:.2f}" for slope in slopes]
        of = "" if family.unit == "N" else f" of {family.unit}"
        lines.append(f"| exponent{of} | {told[0]} | {told[1]} | | {told[2]} | {told[3]} | |")
        lines += _events(points) if "events" in points[0] else []
    return lines


def _events(points: list[dict[str, float]]) -> list[str]:
    lines = ["", _EVENTS, "", "| N | events | an event [us] | an evaluation [us] | an event in evaluations |"]
    lines.append("|---|---|---|---|---|")
    for p in points:
        event, evaluation = 1e6 * p["event"], 1e6 * p["evaluation"]
        lines.append(f"| {p['n']} | {p['events']} | {event:.0f} | {evaluation:.2f} | {event / evaluation:.0f} |")
    return lines


def iftomm(found: Results) -> list[str]:
    lines = ["## IFToMM benchmarks", ""]
    lines += [
        _IFTOMM,
        "",
        "| | end [s] | steps | CPU [s] | published [s] | error | energy |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in found["rows"]:
        published = "" if row["published"] is None else f"{row['published']:.3f}"
        energy = "" if row["energy"] is None else f"{row['energy']:.0e}"
        lines.append(
            f"| {row['title']} | {row['stop']:g} | {row['steps']} | {row['seconds']:.4f} | {published} "
            f"| {row['error']:.0e} | {energy} |"
        )
    return lines
