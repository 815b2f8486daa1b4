"""`--plot`, `--show`, `--xy`: figures of columns as people choose them."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from pathlib import Path

import click

from lagdsl.documents.plot.names import ENERGY, panels_of, paths_of
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.columns import way_to_column
from lagdsl.interfaces.cli.groups import PATH, Decorator, group
from lagdsl.interfaces.cli.output import draft_of, require_figure, require_writable
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.arrays import UnknownColumn
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.table import called_heads


@record(kw_only=True)
class Plot:
    """The path of a figure, the panels over time, and the pairs of columns against each other."""

    path: Path | None
    show: tuple[str, ...]
    xy: tuple[tuple[str, str], ...]


takes_plot: Decorator = group(
    "plot",
    Plot,
    click.option("--plot", "path", type=PATH, help="Write a figure of the motion: .png, .svg, .pdf."),
    click.option(
        "--show",
        multiple=True,
        metavar="NAMES",
        help="Columns of the figure: 'theta, der(theta)'; two units have two axes. Once for each panel.",
    ),
    click.option(
        "--xy",
        multiple=True,
        nargs=2,
        metavar="NAMES NAMES",
        help="Columns against each other: --xy theta 'der(theta)'. Once for each panel.",
    ),
)


def require_sound(plot: Plot) -> None:
    """Leave with status 2, before the work is done, where no figure can come of it."""
    require_writable(plot.path)
    if plot.path is not None:
        require_figure(plot.path)
    elif plot.show or plot.xy:
        raise click.UsageError("--show and --xy choose what --plot draws: give --plot FILE, too")


def require_names(plot: Plot, models: Iterable[FlatModel]) -> None:
    """Leave with status 2, before the work is done, where no model has a column of such a name."""
    subjects = list(models)
    names = [name for flat in subjects for name in called_heads(flat)]
    chosen(plot, dict.fromkeys([*names, ENERGY]), subjects)


def chosen(
    plot: Plot, known: Collection[str], models: Iterable[FlatModel] = ()
) -> tuple[list[list[str]], list[list[tuple[str, str]]]]:
    """Columns of the panels, and pairs of columns; leaves with status 2 for names that are not known."""
    try:
        return panels_of(plot.show, known), paths_of(plot.xy, known)
    except UnknownColumn as error:
        raise click.UsageError(f"{error}{way_to_column(error.args[1], models)}") from error
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def draw_plot(plot: Plot, motion: Trajectory, kept: Trajectory) -> None:
    """Write the figure, if one is asked for: chosen columns of `motion`, or all that are `kept`."""
    if plot.path is None:
        return
    from lagdsl.documents.plot.figure import plot_of

    with draft_of(plot.path) as draft:
        plot_of(motion if plot.show or plot.xy else kept, draft, show=plot.show, xy=plot.xy)
