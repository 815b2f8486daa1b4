"""The places of the files that are not Python: grammar, component library, models, pages of diagnostics, C sources.

A checkout or an editable install has them beside the package; a wheel carries them in `lagdsl/_data`. C sources are
part of the package in every case.
"""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]


def grammar_file() -> Path:
    """The grammar of the language, in Lark's notation."""
    return _folder("grammar", "grammar") / "lagdsl.lark"


def library_folder() -> Path:
    """Root of the component library: `.lag` files."""
    return _folder("stdlib", "stdlib")


def diagnostics_folder() -> Path:
    """The manual pages of the diagnostics: `E0401.md` and so on."""
    return _folder("diagnostics", "docs/diagnostics")


def language_reference() -> Path:
    """The manual of the language, as Markdown."""
    return _folder("reference", "docs/reference") / "language.md"


def models_folder() -> Path:
    """The models to start from: `four_bar.lag` and so on."""
    return _folder("models", "models")


def c_folder() -> Path:
    """The written C of the runtime: `lag/*.h` for who calls it, and one folder for each of its parts."""
    return _PACKAGE / "engines" / "runtime" / "c"


def runtime_library_folder() -> Path:
    """Folder of the C runtime as a shared library."""
    return _PACKAGE / "engines" / "runtime" / "lib"


def is_checkout() -> bool:
    """True if this is the source tree, not a package that was installed from a wheel."""
    return not (_PACKAGE / "_data").is_dir()


def fmi_folder() -> Path:
    """The written C of FMUs: `lag/fmu.h`, and one folder for each of its parts."""
    return _PACKAGE / "exchange" / "fmi" / "c"


def fmi_objects_folder() -> Path:
    """Object files of the runtime and of the shells of FMUs, for the platform of this installation."""
    return _PACKAGE / "exchange" / "fmi" / "lib"


def page_folder() -> Path:
    """The living page: TypeScript in `src`, the bundle that the page carries in `dist`."""
    return _PACKAGE / "documents" / "page" / "web"


def sources_in(folder: Path) -> dict[str, Path]:
    """C sources and headers of the runtime or of FMUs, by their paths as sources include them: `lag/model.h`."""
    files = [file for suffix in ("h", "c") for file in (folder / "lag").rglob(f"*.{suffix}")]
    return {file.relative_to(folder).as_posix(): file for file in sorted(files)}


def compiled_runtime() -> dict[str, Path]:
    """`sources_in` of the runtime without the interpreter of tapes: a model that is compiled needs none."""
    return {path: file for path, file in sources_in(c_folder()).items() if "/tape" not in path}


def units_in(folder: Path) -> dict[str, Path]:
    """Translation units of the runtime or of FMUs, each of many of these files, by the paths `units/NAME.c`."""
    return {file.relative_to(folder).as_posix(): file for file in sorted((folder / "units").glob("*.c"))}


def license_file() -> Path:
    """The license of lagdsl, which what it generates with parts of it carries along."""
    inside = _PACKAGE / "_data" / "LICENSE"
    return inside if inside.is_file() else _PACKAGE.parent / "LICENSE"


def _folder(packed: str, checked_out: str) -> Path:
    """The folder inside the wheel if there is one, else the one of the checkout."""
    inside = _PACKAGE / "_data" / packed
    return inside if inside.is_dir() else _PACKAGE.parent / checked_out
