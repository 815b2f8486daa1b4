"""Where results go: standard output, or a file that appears whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from lagdsl.cli.status import USAGE


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


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """A path to write to that takes the name `path` when all went well; a device or pipe is written directly."""
    if path.exists() and not path.is_file():
        yield path
        return
    try:
        descriptor, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=path.suffix)
        os.close(descriptor)
    except OSError as error:
        raise Unwritable(path, error) from error
    draft = Path(name)
    try:
        yield draft
        _same_mode(path, draft)
        draft.replace(path)
    except OSError as error:
        raise Unwritable(path, error) from error
    finally:
        draft.unlink(missing_ok=True)


def _same_mode(path: Path, draft: Path) -> None:
    """The permissions that the file had, or those that any new file gets."""
    if path.exists():
        draft.chmod(path.stat().st_mode & 0o7777)
    else:
        mask = os.umask(0)
        os.umask(mask)
        draft.chmod(0o666 & ~mask)


def write_text(text: str, path: Path | None) -> None:
    """To the file, or to standard output."""
    if path is None:
        click.echo(text, nl=not text.endswith("\n"))
        return
    with whole_file(path) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")
