"""The folder of compiled models."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from lagdsl.foundation.diagnostics import CompilationFailed


def cache_folder() -> Path:
    """A folder that nobody else can write to: code is loaded from it. Raises CompilationFailed (E0913)."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    try:
        folder = (Path(base) if base else Path.home() / ".cache") / "lagdsl"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = folder.stat()
    except (OSError, RuntimeError) as problem:
        raise _unusable(str(problem)) from None
    if hasattr(os, "getuid") and status.st_uid != os.getuid():
        raise _unusable(f"{folder} belongs to somebody else")
    if status.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise _unusable(f"{folder} can be written by others")
    return folder


def _unusable(reason: str) -> CompilationFailed:
    from lagdsl.engines.runtime.building.compiler import failure

    return failure("E0913", reason=reason)
