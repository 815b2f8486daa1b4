"""`--gif`, `--png`, `--at`, `--follow`: the machine as a film and as a picture."""

from __future__ import annotations

from functools import wraps
from pathlib import Path
from typing import Any

import click

from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.groups import PATH, Command, combined
from lagdsl.interfaces.cli.output import draft_of, require_ending, require_figure, require_writable
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.literal import seconds


@record(kw_only=True)
class Pictures:
    """Paths of a film and of a picture, the times [s] of the picture; `follow`: the view goes with the machine."""

    gif: Path | None
    png: Path | None
    at: tuple[float, ...]
    follow: bool

    @property
    def wanted(self) -> bool:
        return self.gif is not None or self.png is not None


def takes_pictures(command: Command) -> Command:
    """Add `--gif`, `--png`, `--at` and `--follow`; the command gets them as `pictures`."""

    @wraps(command)
    def called(*, gif: Path | None, png: Path | None, at: str | None, follow: bool, **given: Any) -> None:
        command(pictures=Pictures(gif=gif, png=png, at=_times(at), follow=follow), **given)

    return combined(
        click.option("--gif", type=PATH, metavar="F.gif", help="Write a film of the machine."),
        click.option("--png", type=PATH, metavar="F.png", help="Write a picture of the machine: .png, .svg, .pdf."),
        click.option(
            "--at",
            metavar="T,...",
            help="Time of the picture [s]; of several times, the last is drawn in full and the others are pale.",
        ),
        click.option("--follow", is_flag=True, help="Let the view of the film and the picture go with the machine."),
    )(called)


def _times(text: str | None) -> tuple[float, ...]:
    """Times between commas, each a number of seconds or with a unit."""
    if text is None:
        return ()
    found = tuple(seconds("--at", piece.strip()) for piece in text.split(","))
    return tuple(time for time in found if time is not None)


def require_pictures(pictures: Pictures) -> None:
    """Leave with status 2, before the work is done, where a picture cannot be written."""
    for path in (pictures.gif, pictures.png):
        require_writable(path)
    require_ending(pictures.gif, "films are", ".gif")
    require_ending(pictures.png, "pictures are", ".png", ".svg", ".pdf")
    if pictures.at and pictures.png is None:
        raise click.UsageError("--at says which moments --png shows: give --png FILE, too")
    if pictures.follow and not pictures.wanted:
        raise click.UsageError("--follow is said of a film or a picture: give --gif FILE or --png FILE, too")
    for path in (pictures.gif, pictures.png):
        if path is not None:
            require_figure(Path("figure.png"))


def draw_pictures(pictures: Pictures, flat: FlatModel, wishes: Wishes, sink: Sink) -> None:
    """Write what is asked for. Raises CompilationFailed where there is no motion; leaves with status 2 for times that
    are not part of it."""
    from lagdsl.documents.plot.picture.film import write_film, write_picture

    try:
        if pictures.png is not None:
            with draft_of(pictures.png) as draft, progress(pictures.png.name):
                write_picture(flat, wishes, draft, pictures.at, sink, follow=pictures.follow)
        if pictures.gif is not None:
            with draft_of(pictures.gif) as draft, progress(pictures.gif.name):
                write_film(flat, wishes, draft, sink, follow=pictures.follow)
    except ValueError as error:
        raise click.UsageError(str(error)) from error
