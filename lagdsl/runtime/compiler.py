"""Finding a C compiler and calling it."""

from __future__ import annotations

import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from lagdsl.diagnostics import CompilationFailed, Sink

_CANDIDATES = ("cc", "gcc", "clang")
# No -ffast-math: results must be those of the graph's order of operations, the same in every run; for the same reason
# no contraction into fused multiply-adds, which differ between machines.
FLAGS = ("-std=c11", "-fPIC", "-ffp-contract=off", "-fno-math-errno")
# Above this size of generated text (bytes) compile time counts more than the speed of the result.
_LARGE = 200_000
_LONGEST_NOTE = 2000


@dataclass(frozen=True, slots=True)
class Compiler:
    """A command that takes the arguments of a C compiler; `identity` changes when it is replaced by another version."""

    command: tuple[str, ...]
    identity: str


def find_compiler() -> Compiler:
    """The compiler of $CC, else cc, gcc or clang, else that of the package ziglang. Raises E0911."""
    chosen = shlex.split(os.environ.get("CC", ""))
    for command in ([chosen] if chosen else []) + [[name] for name in _CANDIDATES]:
        program = shutil.which(command[0])
        if program is not None:
            return Compiler((program, *command[1:]), _identity(program))
    zig = importlib.util.find_spec("ziglang")
    if zig is not None and zig.origin is not None:
        return Compiler((sys.executable, "-m", "ziglang", "cc"), _identity(zig.origin))
    raise failure("E0911")


def compile_object(compiler: Compiler, folder: Path, source: str, target: str) -> None:
    """Compile the C file `source` of `folder` into the object file `target`. Raises CompilationFailed (E0912)."""
    _run(compiler, folder, [*flags((folder / source).stat().st_size), "-I.", "-c", "-o", target, source])


def link_shared(compiler: Compiler, folder: Path, objects: list[str], target: str) -> None:
    """Link object files into the shared library `target`. Raises CompilationFailed (E0912)."""
    _run(compiler, folder, ["-shared", "-o", target, *objects, "-lm"])


def flags(size: int) -> tuple[str, ...]:
    """Compiler flags for a text of `size` bytes; less optimization for what is too large for it."""
    return (*FLAGS, "-O1" if size > _LARGE else "-O2")


def _run(compiler: Compiler, folder: Path, arguments: list[str]) -> None:
    name = Path(compiler.command[0]).name
    command = [*compiler.command, *arguments]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    except OSError as problem:
        raise failure("E0912", notes=(str(problem),), compiler=name) from None
    if done.returncode != 0:
        raise failure("E0912", notes=(done.stderr.strip()[:_LONGEST_NOTE],), compiler=name)


def _identity(program: str) -> str:
    resolved = Path(program).resolve()
    status = resolved.stat()
    return f"{resolved}:{status.st_size}:{status.st_mtime_ns}"


def failure(code: str, notes: tuple[str, ...] = (), **arguments: str) -> CompilationFailed:
    """The exception that carries one diagnostic without a place in a text."""
    sink = Sink()
    sink.report(code, None, notes=notes, help=None, **arguments)
    return CompilationFailed(sink.diagnostics)
