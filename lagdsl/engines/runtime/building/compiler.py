"""Finding a C compiler and calling it."""

from __future__ import annotations

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import threading
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record

_CANDIDATES = ("cc", "gcc", "clang")
# No -ffast-math: results must be those of the order of operations in the text, the same in every run. For the same
# reason the compiler replaces no function of the library of mathematics by another, or by its value at a constant, and
# chooses no fused multiply-adds (the text says which there are, docs/adr/0014), nor vectors: GCC
# (seen with 12.2) fuses in those it finds all the same, and Clang takes a quarter longer to look for them. Nobody reads
# errno or the traps of the floating-point unit.
_ROUNDED = ("tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "pow")
FLAGS = (
    *("-std=c11", "-fPIC", "-O2", "-ffp-contract=off"),
    *("-fno-tree-vectorize", "-fno-tree-slp-vectorize", "-fno-math-errno", "-fno-trapping-math", "-DLAG_QUICK"),
    *(f"-fno-builtin-{name}" for name in _ROUNDED),
)
# Sums are not fused with their products either: results are those of a tape, to the bit.
ALIKE = "-DLAG_ALIKE"
# Wider registers and shorter code: libraries in the cache run where they were compiled.
_NATIVE = {"x86_64": "-march=native", "AMD64": "-march=native", "aarch64": "-mcpu=native"}
_PROCESSORS = Path("/proc/cpuinfo")
_KINDS_OF_PROCESSOR = ("vendor_id", "cpu family", "model", "stepping", "flags", "Features", "CPU ")
_LONGEST_NOTE = 2000


@record()
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


class Cancelled(Exception):  # noqa: N818  it is what somebody wanted
    """The compiler was ended because nobody waits for it any more."""


class Cancellation:
    """Ends a compiler that runs in another thread, and lets no other one begin."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._process: subprocess.Popen[str] | None = None
        self._done = False

    def cancel(self) -> None:
        """From any thread."""
        with self._lock:
            self._done = True
            if self._process is not None:
                self._process.kill()

    def begin(self, process: subprocess.Popen[str]) -> None:
        """This one may be ended from now on."""
        with self._lock:
            self._process = process
            if self._done:
                process.kill()

    def raise_if_cancelled(self) -> None:
        """Raises Cancelled."""
        if self._done:
            raise Cancelled


def compile_object(
    compiler: Compiler,
    folder: Path,
    source: str,
    target: str,
    flags: Sequence[str] = (),
    cancellation: Cancellation | None = None,
) -> None:
    """Compile the C file `source` of `folder` into the object file `target`. Raises CompilationFailed (E0912)."""
    arguments = [*FLAGS, *flags, *native_flags(compiler), "-I.", "-c", "-o", target, source]
    run_compiler(compiler, folder, arguments, cancellation)


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
    """Features that distinguish this machine's processor from others with the same system; empty if unknown."""
    try:
        first = _PROCESSORS.read_text(encoding="utf-8", errors="replace").split("\n\n")[0]
    except OSError:
        return ""
    return "\n".join(line for line in first.splitlines() if line.startswith(_KINDS_OF_PROCESSOR))


def run_compiler(
    compiler: Compiler, folder: Path, arguments: Sequence[str], cancellation: Cancellation | None = None
) -> None:
    """Call the compiler in `folder`. Raises CompilationFailed (E0912) with what it says, Cancelled where it was
    ended."""
    name = Path(compiler.command[0]).name
    command = [*compiler.command, *arguments]
    own = Cancellation() if cancellation is None else cancellation
    own.raise_if_cancelled()
    try:
        with subprocess.Popen(
            command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace"
        ) as process:
            own.begin(process)
            said = process.communicate()[1]
    except OSError as problem:
        raise failure("E0912", notes=(str(problem),), compiler=name) from None
    own.raise_if_cancelled()
    if process.returncode != 0:
        raise failure("E0912", notes=(said.strip()[:_LONGEST_NOTE],), compiler=name)


def _identity(program: str) -> str:
    resolved = Path(program).resolve()
    status = resolved.stat()
    return f"{resolved}:{status.st_size}:{status.st_mtime_ns}"


def failure(code: str, notes: tuple[str, ...] = (), **arguments: str) -> CompilationFailed:
    """The exception that carries one diagnostic without a place in a text."""
    sink = Sink()
    sink.report(code, None, notes=notes, help=None, edit=None, **arguments)
    return CompilationFailed(sink.diagnostics)
