"""Compiled models: sources to a shared library, kept in a cache by content.

The name of a library is the hash of everything it was made from, so a rebuilt model never meets an older one under its
path, and processes that build the same one at the same time write the same bytes; the last rename wins.
"""

from __future__ import annotations

import hashlib
import platform
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.building.compiler import (
    FLAGS,
    Cancellation,
    Compiler,
    compile_object,
    failure,
    find_compiler,
    link_shared,
    native_flags,
    processor,
)
from lagdsl.engines.runtime.lock import lock_of, locked
from lagdsl.foundation.record import record


def build(
    sources: Mapping[str, str],
    flags: Sequence[str] = (),
    *,
    fresh: bool = False,
    name: str | None = None,
    cancellation: Cancellation | None = None,
) -> Path:
    """The shared library of C `sources` (text by relative path), from the cache unless `fresh`.

    `flags` come beside those that all libraries are compiled with. `name` is that of the file, with its folder if it
    has one; without a name it follows from everything that the library is made of. Raises CompilationFailed: E0911 no
    compiler, E0912 it failed, E0913 nowhere to write; Cancelled.
    """
    compiler = find_compiler()
    folder = cache_folder()
    library = folder / f"{name or content_hash(sources, compiler, flags)}.so"
    if fresh or not library.exists():
        _build_into(library, folder, sources, compiler, flags, cancellation)
    return library


def content_hash(sources: Mapping[str, str], compiler: Compiler, flags: Sequence[str] = ()) -> str:
    """Hexadecimal digest of sources, flags, compiler and machine, its processor too: the folder may be shared."""
    digest = hashlib.sha256()
    system = (platform.system(), platform.release(), platform.version(), *platform.libc_ver())
    machine = (*system, platform.machine(), processor())
    for part in (*compiler.command, compiler.identity, *FLAGS, *flags, *native_flags(compiler), *machine):
        digest.update(part.encode() + b"\0")
    for path, text in sources.items():
        data = text.encode()
        digest.update(f"{path}:{len(data)}:".encode() + data)
    return digest.hexdigest()[:40]


def _build_into(
    library: Path,
    cache: Path,
    sources: Mapping[str, str],
    compiler: Compiler,
    flags: Sequence[str],
    cancellation: Cancellation | None,
) -> None:
    try:
        with tempfile.TemporaryDirectory(dir=cache, prefix="build-") as name:
            folder = Path(name)
            for path, text in sources.items():
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_text(text, encoding="utf-8")
            call = _Call(compiler, folder, tuple(flags), cancellation)
            objects = [_object(call, cache, path, sources) for path in sources if path.endswith(".c")]
            link_shared(compiler, folder, [str(path) for path in objects], library.name)
            library.parent.mkdir(exist_ok=True)
            (folder / library.name).replace(library)
    except OSError as problem:
        raise failure("E0913", reason=str(problem)) from None


@record()
class _Call:
    compiler: Compiler
    folder: Path
    flags: tuple[str, ...]
    cancellation: Cancellation | None


def _object(call: _Call, cache: Path, path: str, sources: Mapping[str, str]) -> Path:
    """The object file of one C file; those of the runtime are the same for all models, and compiled once."""
    shared = path.startswith("lag/")
    read = {
        name: text for name, text in sources.items() if name == path or (name.startswith("lag/") and name[-1] == "h")
    }
    made = call.folder / f"{path.removesuffix('.c')}.o"
    kept = cache / f"{content_hash(read, call.compiler, call.flags)}.o" if shared else made
    if not shared:
        compile_object(call.compiler, call.folder, path, str(made), call.flags, call.cancellation)
    elif not kept.exists():
        with locked(lock_of(kept)):
            if not kept.exists():
                compile_object(call.compiler, call.folder, path, str(made), call.flags, call.cancellation)
                made.replace(kept)
    return kept
