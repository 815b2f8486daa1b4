"""Destinations of results: standard output, or a file that appears whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

import click

from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.interfaces.cli.status import USAGE


class Unwritable(click.ClickException):
    """An output that cannot be written."""

    exit_code = USAGE

    def __init__(self, path: Path, error: OSError) -> None:
        super().__init__(f"cannot write {path}: {error.strerror or error}")


def require_writable(path: Path | None) -> None:
    """Fail before the work is done, not after it, where the folder of `path` cannot be written."""
    if path is None:
        return
    if path.is_dir():
        raise Unwritable(path, IsADirectoryError(0, "it is a directory"))
    if not path.parent.is_dir():
        raise Unwritable(path, FileNotFoundError(0, "there is no such directory"))
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise Unwritable(path, PermissionError(0, "permission denied"))


_Form = TypeVar("_Form", bound=str)


class Forms(click.Choice[str]):
    """The forms of a result by name, or by the ending of the files: `markdown`, `md`."""

    def __init__(self, forms: Sequence[str], endings: Mapping[str, str]) -> None:
        super().__init__(forms)
        self._endings = {ending.removeprefix("."): form for ending, form in endings.items() if form in forms}

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        return super().convert(self._endings.get(value, value), param, ctx)


def form_of(path: Path | None, asked: _Form | None, endings: Mapping[str, _Form], default: _Form) -> _Form:
    """The form that `--to` asks for, else that of the ending of the file, as everywhere; `default` without either.
    Leaves with status 2 where both are there and differ, and for an ending that says nothing."""
    ending = "" if path is None else path.suffix.lower()
    told = endings.get(ending)
    if path is None or not ending or (asked is not None and told in (None, asked)):
        return default if asked is None else asked
    if told is None:
        raise click.UsageError(f"{path.name}: results are written as {', '.join(endings)}; or choose a form with --to")
    if asked is not None:
        raise click.UsageError(f"{path.name}: the ending means {told}, --to says {asked}; leave one of them out")
    return told


def require_ending(path: Path | None, what: str, *endings: str) -> None:
    """Leave with status 2, before the work is done, where the ending of a file promises something else."""
    if path is not None and path.suffix.lower() not in ("", *endings):
        raise click.UsageError(f"{path.name}: {what} written as {', '.join(endings)}")


def require_units(path: Path | None, units: bool) -> None:
    """Leave with status 2 where `--units` would change nothing."""
    if units and (path is None or path.suffix.lower() not in ("", ".csv")):
        raise click.UsageError("--units is for -o FILE.csv; files of other forms hold the units")


@contextmanager
def draft_of(path: Path) -> Iterator[Path]:
    """`whole_file` that leaves with status 2 where `path` cannot be written."""
    try:
        with whole_file(path) as draft:
            yield draft
    except BrokenPipeError:
        raise
    except OSError as error:
        raise Unwritable(path, error) from error


def write_text(text: str, path: Path | None) -> None:
    """To the file, or to standard output."""
    if path is None:
        click.echo(text, nl=not text.endswith("\n"))
        return
    with draft_of(path) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")


def require_figure(picture: Path) -> None:
    """Leave with status 2, before the work is done, where no figure of that ending can be drawn."""
    from importlib.util import find_spec

    from lagdsl.documents.plot.sheet import FORMS

    if picture.suffix.lower() not in ("", *FORMS):
        raise click.UsageError(f"{picture.name}: figures are written as {', '.join(FORMS)}")
    if find_spec("matplotlib") is None:
        raise click.UsageError("figures need matplotlib: pip install matplotlib")
