"""`lag show FILE`: the machine in a browser, moving, with sliders, curves and equations."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.model_file import Format, ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import Span, takes_end, takes_settings
from lagdsl.interfaces.cli.output import require_writable, write_text
from lagdsl.interfaces.cli.pages import open_page, require_page
from lagdsl.interfaces.cli.pictures import Pictures, draw_pictures, require_pictures, takes_pictures
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import FAILED_RUN
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import Compilation, findings


@click.command("show", cls=Command)
@takes_model
@takes_end
@takes_settings
@click.option("-o", "--output", type=PATH, metavar="F.html", help="Write the page here. Default: MODEL.html.")
@takes_pictures
@click.option(
    "--from", "rows", type=PATH, metavar="F.csv", help="Show the motion in this file instead of a simulation."
)
@click.option("--no-open", is_flag=True, help="Write the page, and do not open it.")
def command(
    model_file: ModelFile,
    span: Span,
    assignments: tuple[str, ...],
    output: Path | None,
    pictures: Pictures,
    rows: Path | None,
    no_open: bool,
) -> None:
    """Write a page that shows the machine in FILE, and open it in a browser. The page needs no network.

    With --gif or --png, write these files instead, and the page only if -o names it.
    """
    require_page(output)
    require_pictures(pictures)
    _require_alone(rows, pictures, span)
    style = model_file.style
    source = read_or_leave(model_file.file, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(model_file, source, sink, split(assignments))
    wishes = Wishes(stop=span.end, tolerance=span.tolerance, parameters=chosen.parameters, start=chosen.start)
    if pictures.wanted:
        draw_pictures(pictures, compilation.flat, wishes, sink if output is None else Sink())
    if output is not None or not pictures.wanted:
        path = Path(f"{compilation.flat.name}.html") if output is None else output
        require_writable(path)
        text = _page(compilation, wishes, rows, source, sink, style)
        write_text(text, path)
        open_page(path, no_open=no_open)
    tell(sink.diagnostics, style)
    if sink.has_errors:
        click.get_current_context().exit(FAILED_RUN)


def _require_alone(rows: Path | None, pictures: Pictures, span: Span) -> None:
    """Leave with status 2 where an option asks for a motion that --from does not integrate."""
    if rows is not None and (pictures.wanted or span.stop is not None or span.tolerance is not None):
        raise click.UsageError("--from shows the rows of a file: leave --stop, --tolerance, --gif and --png out")


def _page(
    compilation: Compilation, wishes: Wishes, rows: Path | None, source: SourceFile, sink: Sink, style: Format
) -> str:
    """The text of the page; leaves where there is no motion at all."""
    from lagdsl.documents.page.page import page
    from lagdsl.documents.page.results import results_page

    try:
        with progress("page"):
            if rows is not None:
                return results_page(compilation.flat, rows, wishes, source=source, sink=sink)
            return page(compilation.flat, wishes, source=source, sink=sink, compilation=compilation)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
