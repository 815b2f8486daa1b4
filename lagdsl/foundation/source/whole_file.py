"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """A draft to write to, which takes the name `path` when all went well; nothing is left behind when it did not.

    A link stays a link, permissions stay as they were, a device or pipe is written directly. Raises OSError.
    """
    if path.exists() and (not path.is_file() or path.is_relative_to("/dev")):
        yield path
        return
    target = path.resolve()
    descriptor, name = tempfile.mkstemp(dir=target.parent, prefix=".", suffix=target.suffix)
    os.close(descriptor)
    draft = Path(name)
    try:
        yield draft
        _give_permissions(target, draft)
        draft.replace(target)
    finally:
        draft.unlink(missing_ok=True)


def _give_permissions(target: Path, draft: Path) -> None:
    """Sets the permissions of the old file, or of any new file."""
    if target.exists():
        draft.chmod(target.stat().st_mode & 0o7777)
    else:
        mask = os.umask(0)
        os.umask(mask)
        draft.chmod(0o666 & ~mask)
