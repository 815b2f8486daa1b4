"""`lag modes FILE`: frequencies, damping, shapes, stability; eigenvalues over a parameter."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np

from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.modes_text import modes_text, variation_text
from lagdsl.interfaces.cli.output import draft_of, require_figure, require_writable
from lagdsl.interfaces.cli.pages import require_page, write_page
from lagdsl.interfaces.cli.small_motions import Options, Request, finish, request, takes_state
from lagdsl.language.settings.axis import varied
from lagdsl.language.settings.settings import split
from lagdsl.motion.analysis.modes import Modes
from lagdsl.motion.analysis.sampled.verdict import SampledModes
from lagdsl.motion.analysis.variation import Variation
from lagdsl.motion.analysis.where import modes, vary


@click.command("modes", cls=Command)
@takes_state
@click.option(
    "--vary",
    "assignment",
    metavar="NAME=VALUES",
    help="Compute eigenvalues over a parameter, an input or a start, and locate thresholds: an interval 'P=0:3 N', a "
    "range 'P=0:0.1:3 N' (first:step:last) or 'P=linspace(0, 3, 31) N', a list.",
)
@click.option("--plot", "picture", type=PATH, help="Write a figure: mode shapes or root locus.")
@click.option(
    "--page",
    "--show",
    "page",
    type=PATH,
    metavar="F.html",
    help="Write a page on which the modes move; with --vary thresholds and root locus stand beside them.",
)
def command(options: Options, assignment: str | None, picture: Path | None, page: Path | None) -> None:
    """Show the modes of FILE about its initial state."""
    require_writable(picture)
    require_page(page)
    if picture is not None:
        require_figure(picture)
    asked = request(options)
    found_over: Variation | None = None
    if assignment is None:
        found = asked.ask(modes)
        finish(asked, modes_text(asked.system, found), _modes_data(found), _modes_table(found))
    else:
        ((name, grid),) = split([assignment]).items()
        target, values = varied(asked.system.flat, name, grid, asked.sink)
        found_over = asked.ask(lambda system, at, sink: vary(system, at, target.key, np.array(values), sink))
        finish(
            asked, variation_text(found_over, target.display), _variation_data(found_over), _variation_table(found_over)
        )
    if page is not None:
        about = found if assignment is None else asked.ask(modes)
        write_page(page, lambda: _page(asked, about, found_over), asked.sink, options.model_file.style)
    if picture is not None:
        from lagdsl.documents.plot.modes import plot_modes, plot_variation

        with draft_of(picture) as draft:
            if assignment is None:
                plot_modes(found, draft)
            elif found_over is not None:
                plot_variation(found_over, draft)


def _page(asked: Request, found: Modes, variation: Variation | None) -> str:
    from lagdsl.documents.page.modes import modes_page

    names = [slot.name for slot in asked.system.engine.layout.parameters]
    return modes_page(asked.system.flat, found, names=names, variation=variation, source=asked.source)


def _modes_data(found: Modes) -> dict[str, Any]:
    return {
        "model": found.model,
        "kind": found.steadiness.kind,
        "stability": found.stability,
        "held": list(found.held),
        **_loop_data(found.loop),
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


def _loop_data(loop: SampledModes | None) -> dict[str, Any]:
    if loop is None:
        return {}
    return {
        "period": loop.period,
        "multipliers": loop.multipliers,
        "loop_states": [n.name for n in loop.names],
        "fixed_point": not loop.unbalanced,
        "without": [each.name for each in loop.ignored],
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
        "held": list(found.held),
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
