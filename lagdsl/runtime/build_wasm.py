"""The runtime as a WebAssembly module: `python -m lagdsl.runtime.build_wasm FOLDER`."""

from __future__ import annotations

import sys
from pathlib import Path

from lagdsl.runtime.building.build_library import compile_runtime
from lagdsl.runtime.building.compiler import Compiler, find_compiler
from lagdsl.runtime.library import PROTOTYPES

# The system interface is there for its library of mathematics; nothing of it is imported.
_TARGET = ("-target", "wasm32-wasi", "-mexec-model=reactor")


def build_wasm(folder: Path) -> Path:
    """Build `lag.wasm`, which has no import, into `folder`; returns its path.

    It exports its memory, of which everything from `__heap_base` on is the caller's, and the functions of lag/tape.h
    and lag/session.h. Raises CompilationFailed: E0911 without ziglang, E0912 where it fails.
    """
    zig = find_compiler(only_zig=True)
    exports = [f"-Wl,--export=lag_{name}" for name in PROTOTYPES if name.startswith(("tape_", "session_"))]
    link = ("-Wl,--no-entry", "-Wl,--export=__heap_base", "-Wl,--strip-all", *exports)
    return compile_runtime(Compiler((*zig.command, *_TARGET), zig.identity), folder / "lag.wasm", link, ())


if __name__ == "__main__":
    Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    print(build_wasm(Path(sys.argv[1])))
