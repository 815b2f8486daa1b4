"""`lag fmt`: the one way a model text looks."""

from __future__ import annotations

import difflib
import sys
from pathlib import Path

import click

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.model_file import read_or_leave, tell
from lagdsl.interfaces.cli.output import write_text
from lagdsl.interfaces.cli.status import ERRORS, USAGE
from lagdsl.language.syntax.printer import format_text


@click.command("fmt")
@click.argument("files", metavar="FILE...", nargs=-1, required=True)
@click.option("--check", "check_only", is_flag=True, help="Change nothing; status 1 if a file would change.")
@click.option("--diff", "show_diff", is_flag=True, help="Change nothing; show what would change.")
def command(files: tuple[str, ...], check_only: bool, show_diff: bool) -> None:
    """Format model texts in place; `-` reads standard input and writes standard output."""
    if "-" in files and len(files) > 1:
        raise click.UsageError("`-` cannot be combined with other files")
    outcomes = [_format(name, check_only, show_diff) for name in files]
    click.get_current_context().exit(max(outcomes))


def _format(name: str, check_only: bool, show_diff: bool) -> int:
    source = _standard_input() if name == "-" else read_or_leave(Path(name), "text")
    sink = Sink()
    formatted = format_text(source, sink)
    if formatted is None:
        tell(sink.diagnostics, "text")
        return ERRORS
    if show_diff:
        _print_diff(name, source.text, formatted)
    elif check_only:
        if formatted != source.text:
            click.echo(f"would change {name}", err=True)
    elif name == "-":
        click.echo(formatted, nl=False)
    elif formatted.encode() != Path(name).read_bytes():
        write_text(formatted, Path(name))
    return ERRORS if check_only and formatted != source.text else 0


def _standard_input() -> SourceFile:
    try:
        text = sys.stdin.buffer.read().decode("utf-8")
    except UnicodeDecodeError as error:
        click.echo(f"standard input is not UTF-8 (byte {error.start})", err=True)
        click.get_current_context().exit(USAGE)
    return SourceFile("<stdin>", text.removeprefix("\ufeff").replace("\r\n", "\n"))


def _print_diff(name: str, before: str, after: str) -> None:
    lines = difflib.unified_diff(
        before.splitlines(keepends=True), after.splitlines(keepends=True), name, f"{name} (formatted)"
    )
    for line in lines:
        click.echo(line, nl=not line.endswith("\n"))
