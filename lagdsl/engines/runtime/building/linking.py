"""Arguments with which ziglang or another compiler links shared libraries, by system of
`lagdsl.engines.runtime.building.platforms`."""

from __future__ import annotations

import importlib.util
from functools import cache
from pathlib import Path

# Calls within a library stay within it where two are loaded; its only identity is its content; nothing is missing.
_LINK = {
    "linux": (
        "-shared",
        "-s",
        *("-Wl," + word for word in ("-Bsymbolic", "--build-id=none", "-z,defs", "--gc-sections")),
    ),
    "windows": ("-shared", "-s", "-Wl,--gc-sections"),
    "macos": ("-dynamiclib", "-Wl,-dead_strip", "-Wl,-x"),
}
_LIBRARIES = {"linux": ("-lm",), "windows": (), "macos": ("-lm",)}
# The package ziglang compiles libraries of its own for what processors and Windows lack, of which little is needed: for
# Windows in two minutes. The Universal C Runtime is part of Windows; what it lacks is in WINDOWS_LIBRARY of
# `lagdsl.exchange.fmi.package.toolchain`.
_BARE = {
    "linux": ("-nostdlib", "-lc"),
    "windows": ("-nostdlib", *(f"-lapi-ms-win-crt-{part}-l1-1-0" for part in ("heap", "math", "stdio", "string"))),
    "macos": ("-nostdlib", "-lc"),
}


def link_flags(system: str, name: str) -> tuple[str, ...]:
    """Arguments before the objects of the library `name` on "linux", "windows", "macos" or a system like Linux."""
    named = (f"-Wl,-install_name,@rpath/{name}",) if system == "macos" else ()
    return (*_LINK.get(system, _LINK["linux"]), *named)


def libraries(system: str, *, by_zig: bool) -> tuple[str, ...]:
    """Arguments after the objects."""
    return (*(_BARE[system] if by_zig else ()), *_LIBRARIES.get(system, _LIBRARIES["linux"]))


@cache
def zig_program() -> Path | None:
    """The program of the package ziglang: called directly, it starts without another Python."""
    package = importlib.util.find_spec("ziglang")
    if package is None or package.origin is None:
        return None
    folder = Path(package.origin).parent
    return next((program for program in (folder / "zig", folder / "zig.exe") if program.is_file()), None)
