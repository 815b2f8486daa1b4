"""Exported modules, built by their own Makefile."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

Done = subprocess.CompletedProcess[str]
Made = Callable[..., Done]


def make(folder: Path, objects: Path, *arguments: str) -> Done:
    """`make` in the folder of a module. The object files of the runtime, which is the same for all modules, come from
    `objects`, and go there."""
    _copy(objects, folder / "lag")
    done = subprocess.run(["make", "-s", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    _copy(folder / "lag", objects)
    return done


def _copy(source: Path, target: Path) -> None:
    for path in sorted(source.glob("*.o")):
        shutil.copy(path, target)
