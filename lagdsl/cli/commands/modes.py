"""`lag modes FILE`: frequencies, damping, shapes, stability; eigenvalues over a parameter."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import numpy as np

from lagdsl.analysis.modes import Modes
from lagdsl.analysis.variation import Variation
from lagdsl.analysis.where import modes, vary
from lagdsl.cli.model_file import Format
from lagdsl.cli.modes_text import modes_text, variation_text
from lagdsl.cli.output import draft_of, require_figure, require_writable
from lagdsl.cli.small_motions import finish, grid, request, require_form, takes_state
from lagdsl.runtime.engines.engine import EngineName


@click.command("modes")
@takes_state
@click.option("--trim", is_flag=True, help="Linearize about the equilibrium nearest to the start.")
@click.option(
    "--vary",
    "varied",
    metavar="NAME=FROM:TO:COUNT",
    help="Compute eigenvalues over a parameter, and locate thresholds.",
)
@click.option("--plot", "picture", type=click.Path(path_type=Path), help="Write a figure: mode shapes or root locus.")
def command(
    file: Path,
    model: str | None,
    style: Format,
    time: str | None,
    inputs: tuple[str, ...],
    assignments: tuple[str, ...],
    engine: EngineName,
    output: Path | None,
    trim: bool,
    varied: str | None,
    picture: Path | None,
) -> None:
    """Show the modes of FILE about its initial state."""
    require_form(output)
    for path in (output, picture):
        require_writable(path)
    if picture is not None:
        require_figure(picture)
    asked = request(file, model, style, time, inputs, assignments, engine)
    where = replace(asked.where, trim=trim)
    if varied is None:
        found = asked.ask(modes, where)
        finish(asked, modes_text(asked.system, found), _modes_data(found), _modes_table(found), output)
    else:
        name, values = grid(asked.system.flat, varied)
        found_over = asked.ask(lambda system, at, sink: vary(system, at, name, np.array(values), sink), where)
        finish(asked, variation_text(found_over), _variation_data(found_over), _variation_table(found_over), output)
    if picture is not None:
        from lagdsl.plot.modes import plot_modes, plot_variation

        with draft_of(picture) as draft:
            if varied is None:
                plot_modes(found, draft)
            else:
                plot_variation(found_over, draft)


def _modes_data(found: Modes) -> dict[str, Any]:
    return {
        "model": found.model,
        "kind": found.steadiness.kind,
        "stability": found.stability,
        "eigenvalues": found.eigenvalues,
        "frequencies": found.frequencies,
        "damping": found.damping,
        "time_constants": found.time_constants,
        "places": [n.name for n in found.places],
        "shapes": found.shapes,
        "states": [n.name for n in found.states],
        "vectors": found.vectors,
        "dropped": found.dropped,
        "t": found.point.t,
        "q": found.point.q,
        "qd": found.point.qd,
        "z": found.point.z,
        "u": found.point.u,
    }


def _modes_table(found: Modes) -> list[list[Any]]:
    names = [n.name for n in found.places]
    header = ["re [1/s]", "im [1/s]", "frequency [Hz]", "damping", "time constant [s]"]
    header += [f"{part}({name})" for name in names for part in ("re", "im")]
    columns = zip(
        found.eigenvalues.tolist(), found.frequencies.tolist(), found.damping.tolist(), found.time_constants.tolist(),
        found.shapes.tolist(), strict=True,
    )  # fmt: skip
    rows: list[list[Any]] = [
        [s.real, s.imag, f, z, tau, *(part for x in shape for part in (x.real, x.imag))]
        for s, f, z, tau, shape in columns
    ]
    return [header, *rows]


def _variation_data(found: Variation) -> dict[str, Any]:
    return {
        "model": found.model,
        "varied": found.varied.name,
        "unit": found.varied.unit,
        "values": found.values,
        "eigenvalues": found.eigenvalues,
        "unstable": list(found.unstable),
        "thresholds": [each.value for each in found.thresholds],
        "kinds": [each.kind for each in found.thresholds],
        "threshold_frequencies": [each.frequency for each in found.thresholds],
        "unstable_above": [each.unstable_above for each in found.thresholds],
    }


def _variation_table(found: Variation) -> list[list[Any]]:
    count = found.eigenvalues.shape[1]
    header = [found.varied.name, "unstable", *(f"{part}({i + 1})" for i in range(count) for part in ("re", "im"))]
    rows = zip(found.values.tolist(), found.unstable, found.eigenvalues.tolist(), strict=True)
    return [header, *([v, n, *(part for s in each for part in (s.real, s.imag))] for v, n, each in rows)]
