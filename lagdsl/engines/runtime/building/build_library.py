"""The C runtime as a shared library: built with the package, and in a checkout when its sources change.

An installed library runs on every processor of its kind, so the flags ask for no more than the least of them. It calls
nothing but C's own libraries, and no Python. The build hook (`hatch_build.py`) imports this module without any
third-party package.
"""

from __future__ import annotations

import hashlib
import os
import platform as machine
import sysconfig
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from lagdsl.engines.backends.c.include_files import included
from lagdsl.engines.runtime.building.compiler import FLAGS, Compiler, find_compiler, run_compiler
from lagdsl.engines.runtime.building.linking import libraries, link_flags
from lagdsl.engines.runtime.building.platforms import PLATFORMS, Platform, library_name, platform_of, this_machine
from lagdsl.engines.runtime.lock import locked
from lagdsl.foundation.resources import c_folder

# Calls within the library stay within it, and may be inlined.
_COMPILE = (*FLAGS, "-fno-semantic-interposition")
# Modules that compile the sources: a change of them changes the library, too.
_BUILDERS = ("build_library.py", "compiler.py", "linking.py", "platforms.py")


def wheel_tag(name: str | None = None) -> str:
    """The tag of a wheel that carries the library for the platform `name`, or for this machine."""
    if name is not None:
        return f"py3-none-{platform_of(name).wheel}"
    if this_machine().startswith("macos"):  # Python's own name is that of all processors it was built for
        return f"py3-none-{platform_of(this_machine()).wheel}"
    return "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")


def build_library(folder: Path, name: str | None = None, objects: Path | None = None) -> Path:
    """Build the library for the platform `name`, or for this machine, into `folder`; returns its path.

    `objects` is a folder that keeps object files, by content, from one build to the next.
    Raises CompilationFailed: E0911 no compiler, E0912 it failed.
    """
    compiler = _compiler(name)
    system = (name or this_machine()).partition("-")[0]
    file = library_name(system)
    more = libraries(system, by_zig=False)  # of what ziglang compiles, the test of the processor's registers is needed
    return compile_runtime(compiler, folder / file, link_flags(system, file), more, objects)


def compile_runtime(
    compiler: Compiler, target: Path, link: Sequence[str], libraries: Sequence[str], objects: Path | None = None
) -> Path:
    """All sources into the one file `target`, which appears when it is whole; `link` comes before the objects."""
    sources = sorted((c_folder() / "lag").rglob("*.c"))
    with tempfile.TemporaryDirectory(dir=target.parent, prefix="build-") as made:
        kept = objects or Path(made)
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            parts = list(pool.map(partial(_object, compiler, kept), sources))
        run_compiler(compiler, Path(made), [*link, "-o", target.name, *map(str, parts), *libraries])
        (Path(made) / target.name).replace(target)
        for path in set(kept.glob("*.o")) - set(parts):  # those of older sources
            path.unlink(missing_ok=True)
    return target


def _compiler(name: str | None) -> Compiler:
    """Compiler for the platform: this machine's compiler, or ziglang, with the least processor as its target."""
    if name is None:
        compiler = find_compiler()
        if not _is_zig(compiler) or this_machine() not in PLATFORMS:
            return compiler
        return _aimed(compiler, platform_of(this_machine()))
    return _aimed(find_compiler(only_zig=True), platform_of(name))


def _is_zig(compiler: Compiler) -> bool:
    return "ziglang" in compiler.command


def _aimed(compiler: Compiler, at: Platform) -> Compiler:
    return Compiler((*compiler.command, "-target", at.target), compiler.identity)


def _object(compiler: Compiler, kept: Path, source: Path) -> Path:
    """The object file of one C file, named after all that it depends on."""
    text = source.read_text(encoding="utf-8")
    headers = included([text], _header)
    digest = hashlib.sha256()
    for part in (*compiler.command, compiler.identity, *_COMPILE, machine.machine(), text, *headers.values()):
        digest.update(part.encode() + b"\0")
    path = kept / f"{source.stem}-{digest.hexdigest()[:24]}.o"
    if not path.exists():
        include = f"-I{c_folder()}"
        with tempfile.TemporaryDirectory(dir=kept, prefix="build-") as folder:
            run_compiler(compiler, Path(folder), [*_COMPILE, include, "-c", "-o", "one.o", str(source)])
            (Path(folder) / "one.o").replace(path)
    return path


def _header(name: str) -> str:
    return (c_folder() / name).read_text(encoding="utf-8")


# ---- in a checkout ---------------------------------------------------------------------------------------------------


def up_to_date(library: Path, build: Callable[[Path], None] | None = None) -> Path:
    """The library of a checkout, built first where it is missing or older than its sources.

    Processes that start at the same time wait for one of them to build it.
    """
    if _is_current(library):
        return library
    library.parent.mkdir(parents=True, exist_ok=True)
    with locked(library.parent / "lock"):
        if not _is_current(library):
            (build or _rebuild)(library)
    return library


def _rebuild(library: Path) -> None:
    newest = _newest_source()
    objects = library.parent / "objects"
    objects.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=library.parent, prefix="build-") as made:
        found = build_library(Path(made), objects=objects)
        # as old as what it was made from: what was edited meanwhile is newer
        os.utime(found, ns=(newest, newest))
        found.replace(library)


def _is_current(library: Path) -> bool:
    try:
        return library.stat().st_mtime_ns >= _newest_source()
    except FileNotFoundError:
        return False


def _newest_source() -> int:
    """When a source was changed last, or a file came or went [ns]."""
    here = Path(__file__).parent
    times = [(here / name).stat().st_mtime_ns for name in _BUILDERS]
    top = c_folder() / "lag"
    for folder in (top, *(Path(entry.path) for entry in os.scandir(top) if entry.is_dir())):
        times.append(folder.stat().st_mtime_ns)
        times += [entry.stat().st_mtime_ns for entry in os.scandir(folder)]
    return max(times)
