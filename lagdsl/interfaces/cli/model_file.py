"""Code that all commands with a model share: their arguments, and printing of diagnostics."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal, NoReturn, TypeAlias

import click

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.groups import PATH, Decorator, group
from lagdsl.interfaces.cli.status import ERRORS, USAGE
from lagdsl.language.semantics.classes.library import read_source

if TYPE_CHECKING:
    from lagdsl.language.flat.model import FlatModel

# Facts of a model that nobody needs with every run.
_TOLD_BY_CHECK = frozenset({"N0513", "N0515", "N0701"})
Format: TypeAlias = Literal["text", "json"]

# Files beside the model that cannot be read: tables, files of robots.
_UNREADABLE = frozenset({"E0820", "E1000"})


takes_format: Decorator = click.option(
    "--format",
    "style",
    type=click.Choice(["text", "json"]),
    default="text",
    show_default=True,
    help="Format of the diagnostics.",
)


@record(kw_only=True)
class ModelFile:
    """The file, the name of the model in it (None: the last complete one), and the form of diagnostics."""

    file: Path
    model: str | None
    style: Format


takes_model: Decorator = group(
    "model_file",
    ModelFile,
    click.argument("file", type=PATH),
    click.option(
        "-m", "--model", metavar="MODEL", help="Name of the model in the file; default: the last complete one."
    ),
    takes_format,
)


def read_or_leave(file: Path, style: Format, *, to_output: bool = False) -> SourceFile:
    """The text of FILE; leaves with status 2 where it cannot be read."""
    sink = Sink()
    source = read_source(file, sink)
    if source is None:
        tell(sink.diagnostics, style, to_output=to_output)
        click.get_current_context().exit(USAGE)
    return source


def flat_or_leave(model_file: ModelFile, assignments: Sequence[str] = ()) -> FlatModel:
    """The flat model of FILE with the values of `--set`, its warnings told; leaves where it is wrong.

    Raises SettingError.
    """
    from lagdsl.language.settings.settings import split
    from lagdsl.motion.pipeline import flatten_set, parse_file

    style = model_file.style
    source = read_or_leave(model_file.file, style)
    sink = Sink()
    unit = parse_file(source, sink)
    flat = flatten_set(unit, sink, model=model_file.model, pairs=split(assignments)) if unit is not None else None
    if flat is None:
        leave_with_errors(sink.diagnostics, style)
    tell(sink.diagnostics, style)
    return flat


def tell(diagnostics: Sequence[Diagnostic], style: Format, *, to_output: bool = False) -> None:
    """Print diagnostics to standard error, or JSON to standard output where it is the result, of `lag check`."""
    diagnostics = diagnostics if to_output else [each for each in diagnostics if each.code not in _TOLD_BY_CHECK]
    if style == "json":
        from lagdsl.foundation.diagnostics.json import to_json

        click.echo(to_json(diagnostics), err=not to_output)
    elif diagnostics:
        from lagdsl.foundation.diagnostics.render import render_all

        click.echo(render_all(diagnostics, color=_color()).rstrip("\n"), err=True)


def leave_with_errors(diagnostics: Sequence[Diagnostic], style: Format) -> NoReturn:
    """Tell them and leave with status 1, or 2 where a file cannot be read."""
    tell(diagnostics, style)
    unreadable = any(diagnostic.code in _UNREADABLE for diagnostic in diagnostics)
    click.get_current_context().exit(USAGE if unreadable else ERRORS)


def _color() -> bool:
    return sys.stderr.isatty() and not os.environ.get("NO_COLOR")
