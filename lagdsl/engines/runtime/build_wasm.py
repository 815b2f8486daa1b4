"""The runtime as a WebAssembly module: `python -m lagdsl.engines.runtime.build_wasm FOLDER`. For pages."""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

from lagdsl.engines.runtime.building.build_library import compile_runtime
from lagdsl.engines.runtime.building.compiler import Compiler, find_compiler
from lagdsl.engines.runtime.library import PROTOTYPES
from lagdsl.foundation.resources import c_folder, sources_in

# The system interface is there for its library of mathematics; nothing of it is imported. Pages carry the module, so
# the compiler prefers what is small: loops that are not unrolled save a fifth, functions that stand alone a tenth.
_SMALL = ("-Os", "-fno-unroll-loops", "-mllvm", "-inline-threshold=5")
_TARGET = ("-target", "wasm32-wasi", "-mexec-model=reactor", *_SMALL)


def build_wasm(folder: Path) -> Path:
    """Build `lag.wasm`, which has no import, into `folder`, and beside it the digest of its sources; returns its path.

    It exports its memory, of which everything from `__heap_base` on is the caller's, and the functions of lag/tape.h
    and lag/session.h. Raises CompilationFailed: E0911 without ziglang, E0912 where it fails.
    """
    folder = folder.resolve()
    zig = find_compiler(only_zig=True)
    exports = [f"-Wl,--export=lag_{name}" for name in PROTOTYPES if name.startswith(("tape_", "session_"))]
    link = ("-Wl,--no-entry", "-Wl,--export=__heap_base", "-Wl,--strip-all", *exports)
    path = compile_runtime(Compiler((*zig.command, *_TARGET), zig.identity), folder / "lag.wasm", link, ())
    (folder / "lag.wasm.sha256").write_text(f"{sources_digest()}\n", encoding="ascii")
    return path


def sources_digest() -> str:
    """Of all C that the module is compiled from."""
    digest = hashlib.sha256()
    for name, path in sources_in(c_folder()).items():
        digest.update(name.encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


if __name__ == "__main__":
    Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    print(build_wasm(Path(sys.argv[1])))
