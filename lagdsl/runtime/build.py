"""Compiled models: sources to a shared library, kept in a cache by content.

The name of a library is the hash of everything it was made from, so a rebuilt model never meets an older one under its
path, and processes that build the same one at the same time write the same bytes; the last rename wins.
"""

from __future__ import annotations

import hashlib
import os
import platform
import stat
import tempfile
from collections.abc import Mapping
from pathlib import Path

from lagdsl.runtime.compiler import (
    FLAGS,
    Compiler,
    compile_object,
    failure,
    find_compiler,
    link_shared,
    native_flags,
    processor,
)


def build(sources: Mapping[str, str], *, fresh: bool = False) -> Path:
    """The shared library of C `sources` (text by relative path), from the cache unless `fresh`.

    Raises CompilationFailed: E0911 no compiler, E0912 it failed, E0913 nowhere to write.
    """
    compiler = find_compiler()
    folder = cache_folder()
    library = folder / f"{content_hash(sources, compiler)}.so"
    if fresh or not library.exists():
        _build_into(library, sources, compiler)
    return library


def content_hash(sources: Mapping[str, str], compiler: Compiler) -> str:
    """Hexadecimal digest of sources, flags, compiler and machine, its processor too: the folder may be shared."""
    digest = hashlib.sha256()
    machine = (platform.platform(), platform.machine(), processor())
    for part in (*compiler.command, compiler.identity, *FLAGS, *native_flags(compiler), *machine):
        digest.update(part.encode() + b"\0")
    for path, text in sources.items():
        data = text.encode()
        digest.update(f"{path}:{len(data)}:".encode() + data)
    return digest.hexdigest()[:40]


def cache_folder() -> Path:
    """A folder that nobody else can write to: code is loaded from it. Raises CompilationFailed (E0913)."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    try:
        folder = (Path(base) if base else Path.home() / ".cache") / "lagdsl"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = folder.stat()
    except (OSError, RuntimeError) as problem:
        raise failure("E0913", reason=str(problem)) from None
    if hasattr(os, "getuid") and status.st_uid != os.getuid():
        raise failure("E0913", reason=f"{folder} belongs to somebody else")
    if status.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise failure("E0913", reason=f"{folder} can be written by others")
    return folder


def _build_into(library: Path, sources: Mapping[str, str], compiler: Compiler) -> None:
    try:
        with tempfile.TemporaryDirectory(dir=library.parent, prefix="build-") as name:
            folder = Path(name)
            for path, text in sources.items():
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_text(text, encoding="utf-8")
            objects = [
                _object(path, library.parent, folder, sources, compiler) for path in sources if path.endswith(".c")
            ]
            link_shared(compiler, folder, [str(path) for path in objects], library.name)
            (folder / library.name).replace(library)
    except OSError as problem:
        raise failure("E0913", reason=str(problem)) from None


def _object(path: str, cache: Path, folder: Path, sources: Mapping[str, str], compiler: Compiler) -> Path:
    """The object file of one C file; those of the runtime are the same for all models, and compiled once."""
    headers = [name for name in sources if name.startswith("lag/") or name == path.removesuffix(".c") + ".h"]
    read = {name: sources[name] for name in (path, *(name for name in headers if name.endswith(".h")))}
    kept = cache / f"{content_hash(read, compiler)}.o"
    if not kept.exists():
        compile_object(compiler, folder, path, "one.o")
        (folder / "one.o").replace(kept)
    return kept
