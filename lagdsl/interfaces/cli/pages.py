"""`--page`: results as a page that moves."""

from __future__ import annotations

import webbrowser
from collections.abc import Callable
from pathlib import Path

import click

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.interfaces.cli.model_file import Format, leave_with_errors
from lagdsl.interfaces.cli.output import require_ending, require_writable, write_text
from lagdsl.interfaces.cli.progress import progress
from lagdsl.motion.pipeline import findings


def require_page(path: Path | None) -> None:
    """Leave with status 2, before the work is done, where no page can be written."""
    require_ending(path, "pages are", ".html", ".htm")
    require_writable(path)


def write_page(path: Path, text: Callable[[], str], sink: Sink, style: Format) -> None:
    """Write the page; leaves where there is none."""
    try:
        with progress(path.name):
            written = text()
        write_text(written, path)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def open_page(path: Path, *, no_open: bool) -> None:
    """In the browser, where there is one and it is wanted; else tell where the page lies."""
    if no_open or not webbrowser.open(path.resolve().as_uri()):
        click.echo(f"wrote {path}")
