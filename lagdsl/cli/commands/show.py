"""`lag show FILE`: the machine in a browser, moving, with sliders, curves and equations."""

from __future__ import annotations

import webbrowser
from pathlib import Path

import click

from lagdsl.cli.command import Command
from lagdsl.cli.compile_model import compile_or_leave
from lagdsl.cli.model_file import Format, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.cli.options import PATH, takes_settings, takes_stop, takes_tolerance
from lagdsl.cli.output import require_ending, require_writable, write_text
from lagdsl.cli.status import FAILED_RUN
from lagdsl.diagnostics import CompilationFailed, Severity, Sink
from lagdsl.pipeline import findings
from lagdsl.settings.literal import seconds
from lagdsl.settings.settings import split


@click.command("show", cls=Command)
@takes_model
@takes_stop
@takes_tolerance
@takes_settings
@click.option("-o", "--output", type=PATH, metavar="F.html", help="Write the page here. Default: MODEL.html.")
@click.option("--no-open", is_flag=True, help="Write the page, and do not open it.")
def command(
    file: Path,
    model: str | None,
    style: Format,
    stop: str | None,
    tolerance: float | None,
    assignments: tuple[str, ...],
    output: Path | None,
    no_open: bool,
) -> None:
    """Write a page that shows the machine in FILE, and open it in a browser. The page needs no network."""
    require_ending(output, "pages are", ".html", ".htm")
    require_writable(output)
    source = read_or_leave(file, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(source, sink, style, model, "graph", split(assignments))
    path = Path(f"{compilation.flat.name}.html") if output is None else output
    require_writable(path)

    from lagdsl.page.page import Wishes, page

    wishes = Wishes(stop=seconds("--stop", stop), tolerance=tolerance, parameters=chosen.parameters, start=chosen.start)
    try:
        text = page(compilation.flat, wishes, source=source, sink=sink)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
    tell(sink.diagnostics, style)
    write_text(text, path)
    if no_open or not webbrowser.open(path.resolve().as_uri()):
        click.echo(f"wrote {path}")
    if any(d.severity is Severity.ERROR for d in sink.diagnostics):
        click.get_current_context().exit(FAILED_RUN)
