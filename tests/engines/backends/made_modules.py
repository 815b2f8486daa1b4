"""Exported modules, built by their own Makefile."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

from choice import ALL

Done = subprocess.CompletedProcess[str]
Made = Callable[..., Done]
# Tests share these, and with them the object files of the runtime. Without optimization compiling takes half the time,
# and the compiler sees less to warn of.
PLAIN = "-O1" if ALL else "-O0"
SANITIZED = "-O0 -g -fsanitize=address,undefined -fno-sanitize-recover=all"
_RUNTIME = Path(__file__).parents[3] / "lagdsl" / "engines" / "runtime" / "c"


def sanitized_objects() -> Path:
    """The object files that the C tests of the runtime are linked with."""
    subprocess.run(["make", "--silent", "--directory", str(_RUNTIME), "objects"], check=True)
    return _RUNTIME / "build" / "sanitized"


def make(folder: Path, objects: Path, *arguments: str) -> Done:
    """`make` in the folder of a module. The object files of the runtime, which is the same for all modules, come from
    `objects`, and go there."""
    _copy(objects, folder / "lag")
    done = subprocess.run(["make", "-s", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    _copy(folder / "lag", objects)
    return done


def _copy(source: Path, target: Path) -> None:
    """Copies files that are not there yet; another process sees no file before it is whole."""
    for path in sorted(source.rglob("*.o")):
        wanted = target / path.relative_to(source)
        if not wanted.exists():
            wanted.parent.mkdir(exist_ok=True)
            draft = wanted.with_name(f"{path.name}.{os.getpid()}")
            shutil.copy(path, draft)
            draft.replace(wanted)
