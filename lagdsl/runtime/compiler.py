"""Finding a C compiler and calling it."""

from __future__ import annotations

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from lagdsl.diagnostics import CompilationFailed, Sink

_CANDIDATES = ("cc", "gcc", "clang")
# No -ffast-math: results must be those of the order of operations in the text, the same in every run. For the same
# reason the compiler chooses no fused multiply-adds (the text says which there are, docs/adr/0011), nor vectors: GCC
# (seen with 12.2) fuses in those it finds all the same, and Clang takes a quarter longer to look for them. Nobody reads
# errno or the traps of the floating-point unit.
FLAGS = (
    *("-std=c11", "-fPIC", "-O2", "-ffp-contract=off"),
    *("-fno-tree-vectorize", "-fno-tree-slp-vectorize", "-fno-math-errno", "-fno-trapping-math", "-DLAG_QUICK"),
)
# Wider registers and shorter code: libraries in the cache run where they were compiled.
_NATIVE = {"x86_64": "-march=native", "AMD64": "-march=native", "aarch64": "-mcpu=native"}
_PROCESSORS = Path("/proc/cpuinfo")
_KINDS_OF_PROCESSOR = ("vendor_id", "cpu family", "model", "stepping", "flags", "Features", "CPU ")
_LONGEST_NOTE = 2000


@dataclass(frozen=True, slots=True)
class Compiler:
    """A command that takes the arguments of a C compiler; `identity` changes when it is replaced by another version."""

    command: tuple[str, ...]
    identity: str


def find_compiler(*, only_zig: bool = False) -> Compiler:
    """The compiler of $CC, else cc, gcc or clang, else (or `only_zig`) that of the package ziglang. Raises E0911."""
    found = None if only_zig else machine_compiler()
    if found is not None:
        return found
    zig = importlib.util.find_spec("ziglang")
    if zig is not None and zig.origin is not None:
        return Compiler((sys.executable, "-m", "ziglang", "cc"), _identity(zig.origin))
    raise failure("E0911")


def machine_compiler() -> Compiler | None:
    """The compiler of $CC, else cc, gcc or clang; None where there is none of them."""
    chosen = shlex.split(os.environ.get("CC", ""))
    for command in ([chosen] if chosen else []) + [[name] for name in _CANDIDATES]:
        program = shutil.which(command[0])
        if program is not None:
            return Compiler((program, *command[1:]), _identity(program))
    return None


def compile_object(compiler: Compiler, folder: Path, source: str, target: str) -> None:
    """Compile the C file `source` of `folder` into the object file `target`. Raises CompilationFailed (E0912)."""
    run_compiler(compiler, folder, [*FLAGS, *native_flags(compiler), "-I.", "-c", "-o", target, source])


def link_shared(compiler: Compiler, folder: Path, objects: list[str], target: str) -> None:
    """Link object files into the shared library `target`. Raises CompilationFailed (E0912)."""
    run_compiler(compiler, folder, ["-shared", "-o", target, *objects, "-lm"])


def native_flags(compiler: Compiler) -> tuple[str, ...]:
    """Flags for this machine's own processor; none where it cannot be told from others, or $CC names one."""
    flag = _NATIVE.get(platform.machine())
    chosen = any(word.startswith("-m") for word in compiler.command[1:])
    return (flag,) if flag is not None and processor() and not chosen else ()


@cache
def processor() -> str:
    """What makes this machine's processor differ from others that would run the same system; empty if unknown."""
    try:
        first = _PROCESSORS.read_text(encoding="utf-8", errors="replace").split("\n\n")[0]
    except OSError:
        return ""
    return "\n".join(line for line in first.splitlines() if line.startswith(_KINDS_OF_PROCESSOR))


def run_compiler(compiler: Compiler, folder: Path, arguments: list[str]) -> None:
    """Call the compiler in `folder`. Raises CompilationFailed (E0912) with what it says."""
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
