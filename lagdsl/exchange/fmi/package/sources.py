"""Everything that the library of an FMU is compiled from, by relative path: what any importer compiles, too."""

from __future__ import annotations

import importlib.util
from pathlib import Path

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import started_sources
from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.engines.runtime.units import ALONE, SESSIONS
from lagdsl.exchange.fmi.package.compile_objects import included
from lagdsl.foundation.resources import c_folder, fmi_folder, sources_in, units_in

_HEADERS = {
    2: ("fmi2FunctionTypes.h", "fmi2Functions.h", "fmi2TypesPlatform.h"),
    3: ("fmi3FunctionTypes.h", "fmi3Functions.h", "fmi3PlatformTypes.h"),
}
_BOTH = (2, 3)


def model_sources(program: Program, start: Start, version: int) -> dict[str, str]:
    """All but the table of the variables: the model, the runtime, the shell of this version of FMI with its headers,
    and the units in which they are compiled.

    Raises CompilationFailed (E0904) without the package that brings the headers of the standard.
    """
    units = _units(version)
    whole = {**started_sources(program, start), **_shell(version), **units, **_standard_headers(version)}
    unread = {*ALONE, *included(_text(units_in(c_folder())[SESSIONS]))}
    return {path: text for path, text in whole.items() if not (path.endswith(".c") and path in unread)}


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
    return {path: _text(file) for path, file in files if not path.startswith(others)}


def _units(version: int) -> dict[str, str]:
    """Without those of other versions, and without sessions, which no FMU has."""
    left = {SESSIONS, *(f"units/fmi{other}.c" for other in _BOTH if other != version)}
    files = {**units_in(c_folder()), **units_in(fmi_folder())}
    return {path: _text(file) for path, file in files.items() if path not in left}


def _text(file: Path) -> str:
    return file.read_text(encoding="utf-8")


def _standard_headers(version: int) -> dict[str, str]:
    folder = require_fmpy() / "c-code"
    return {name: (folder / name).read_text(encoding="utf-8") for name in _HEADERS[version]}
