"""Compiler for a platform: the one of the package ziglang for all, else this machine's for its own."""

from __future__ import annotations

import subprocess
from pathlib import Path

from lagdsl.engines.runtime.building.compiler import FLAGS, failure, find_compiler
from lagdsl.engines.runtime.building.linking import libraries, link_flags, zig_program
from lagdsl.engines.runtime.building.platforms import Platform, this_machine
from lagdsl.foundation.record import record
from lagdsl.foundation.resources import fmi_folder

_LONGEST_NOTE = 2000
# The linker drops functions that nobody calls; all processors round alike.
COMPILE = (*FLAGS, "-DLAG_ALIKE", "-g0", "-ffunction-sections", "-fdata-sections", "-I.")
# Files of the runtime and of the shells are the same for all models: an installation brings them, compiled with these.
SHARED = COMPILE
_SHARED_FILES = ("lag/", "units/")
# Units that do little in a step take half the time in this way, and runs as much as before. `zig cc` reads -O1 as -O2.
_LIGHT = ("-Xclang", "-O1", "-mllvm", "-inline-threshold=25")
_LIGHT_UNITS = ("units/events.c", "units/starts.c")
# Only what the headers of the standard export is seen from outside: in ELF it is the linker that hides the rest, so
# that an engine can be linked from the same objects.
_HIDING = {"linux": "-fno-semantic-interposition", "windows": "-fvisibility=hidden", "macos": "-fvisibility=hidden"}
# The few functions for which MinGW's library would be linked.
WINDOWS_LIBRARY = fmi_folder() / "windows" / "library.c"
_EXPORTED = "exported.map"
_EXPORTS = "{ global: fmi2*; fmi3*; local: *; };\n"


@record()
class Toolchain:
    """`command` takes the arguments of a C compiler; `identity` changes when it is replaced by another version.
    `by_zig` where it is the one of the package ziglang, whose objects are the same on all machines."""

    platform: Platform
    command: tuple[str, ...]
    identity: str
    by_zig: bool

    def compile(self, folder: Path, source: str, target: str) -> None:
        """The C file `source` into the object file `target`, both in `folder`. Raises CompilationFailed (E0906)."""
        self._run(folder, [*self._flags(source), "-c", "-o", target, source])

    def link(self, folder: Path, objects: list[str], target: str, *, opened: bool = False) -> None:
        """Object files into the library `target`, which depends on C's own libraries only, and shows what the headers
        of the standard export, or all its functions if it is `opened`. Raises CompilationFailed."""
        system = self.platform.system
        more = []
        if self.opens and not opened:
            (folder / _EXPORTED).write_text(_EXPORTS, encoding="ascii")
            more.append(f"-Wl,--version-script={_EXPORTED}")
        if system == "windows" and self.by_zig:
            made = f"{target}.library.o"
            self._run(folder, [*FLAGS, "-fno-builtin", "-c", "-o", made, str(WINDOWS_LIBRARY)])
            more.append(made)
        after = libraries(system, by_zig=self.by_zig)
        self._run(folder, [*link_flags(system, target), *more, "-o", target, *objects, *after])

    @property
    def opens(self) -> bool:
        """True if the linker decides what is seen from outside."""
        return self.platform.system == "linux"

    def flags(self, source: str) -> tuple[str, ...]:
        """All that the object of the C file `source` depends on beside texts."""
        return (*self.command, self.identity, *self._flags(source))

    def _flags(self, source: str) -> tuple[str, ...]:
        return _flags_of(self.platform, source, by_zig=self.by_zig)

    def _run(self, folder: Path, arguments: list[str]) -> None:
        command = [*self.command, *arguments]
        try:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", check=False)
        except OSError as problem:
            raise failure(
                "E0906", notes=(str(problem),), platform=self.platform.name, compiler=Path(self.command[0]).name
            ) from None
        if done.returncode != 0:
            said = done.stderr.strip()[:_LONGEST_NOTE] or f"it left with status {done.returncode}"
            raise failure("E0906", notes=(said,), platform=self.platform.name, compiler=Path(self.command[0]).name)


def target_flags(platform: Platform, source: str) -> tuple[str, ...]:
    """All that the object of the C file `source` by ziglang depends on beside texts."""
    return ("zig", platform.target, *_flags_of(platform, source, by_zig=True))


def _flags_of(platform: Platform, source: str, *, by_zig: bool) -> tuple[str, ...]:
    flags = SHARED if source.startswith(_SHARED_FILES) else COMPILE
    light = _LIGHT if by_zig and source in _LIGHT_UNITS else ()
    return (*flags, *light, _HIDING[platform.system])


def toolchain(platform: Platform) -> Toolchain:
    """Raises CompilationFailed: E0905 where nothing here compiles for the platform, E0911 without any compiler."""
    zig = zig_program()
    if zig is not None:
        command = (str(zig), "cc", "-target", platform.target)
        return Toolchain(platform, command, _identity(zig), by_zig=True)
    if platform.name != this_machine():
        raise failure("E0905", platform=platform.name)
    compiler = find_compiler()
    return Toolchain(platform, compiler.command, compiler.identity, by_zig=False)


def _identity(program: Path) -> str:
    status = program.stat()
    return f"{program.resolve()}:{status.st_size}:{status.st_mtime_ns}"
