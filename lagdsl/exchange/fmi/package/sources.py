"""Everything that the library of an FMU is compiled from, by relative path: what any importer compiles, too."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping
from pathlib import Path

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import started_sources
from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.foundation.resources import fmi_folder, sources_in

_HEADERS = {
    2: ("fmi2FunctionTypes.h", "fmi2Functions.h", "fmi2TypesPlatform.h"),
    3: ("fmi3FunctionTypes.h", "fmi3Functions.h", "fmi3PlatformTypes.h"),
}
_BOTH = (2, 3)


def model_sources(program: Program, start: Start, version: int) -> dict[str, str]:
    """All but the table of the variables: the model, the runtime, the shell of this version of FMI with its headers.

    Raises CompilationFailed (E0904) without the package that brings the headers of the standard.
    """
    return {**started_sources(program, start), **_shell(version), **_standard_headers(version)}


def c_files(sources: Mapping[str, str]) -> tuple[str, ...]:
    """Files to compile, in a fixed order."""
    return tuple(sorted(path for path in sources if path.endswith(".c")))


def is_standard(path: str) -> bool:
    """True if this is a header of the standard."""
    return any(path in names for names in _HEADERS.values())


def require_fmpy() -> Path:
    """The folder of the package fmpy, which brings the headers of the standard and its validator. Raises E0904."""
    package = importlib.util.find_spec("fmpy")
    if package is None or package.origin is None:
        raise failure("E0904", package="fmpy")
    return Path(package.origin).parent


def _shell(version: int) -> dict[str, str]:
    others = tuple(f"lag/fmi{other}/" for other in _BOTH if other != version)
    files = sources_in(fmi_folder()).items()
    return {path: file.read_text(encoding="utf-8") for path, file in files if not path.startswith(others)}


def _standard_headers(version: int) -> dict[str, str]:
    folder = require_fmpy() / "c-code"
    return {name: (folder / name).read_text(encoding="utf-8") for name in _HEADERS[version]}
