"""Documentation of an FMU, kept in the cache by all that it follows from: a repeated export loads neither SymPy nor
Matplotlib."""

from __future__ import annotations

import hashlib
import zipfile
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.exchange.fmi.export_model import ExportModel
from lagdsl.exchange.fmi.model_texts import files_of
from lagdsl.exchange.fmi.package.archive import write_archive
from lagdsl.exchange.fmi.reference import Reference
from lagdsl.foundation.resources import is_checkout, license_file
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.foundation.version import __version__

_PACKAGE = Path(__file__).resolve().parents[1]
_WRITERS = ("sympy", "matplotlib")


def kept_documentation(
    export_model: ExportModel, description: str, known: Reference | None, header: str
) -> dict[str, bytes]:
    """`documentation_files`. `description` is that of the FMU, with the token of its sources.

    Raises CompilationFailed (E0913).
    """
    kept = cache_folder() / f"{_name(export_model, description, known, header)}.documentation"
    try:
        if kept.exists():
            with zipfile.ZipFile(kept) as archive:
                return {name: archive.read(name) for name in archive.namelist()}
        from lagdsl.exchange.fmi.documentation import documentation_files

        files = documentation_files(export_model, known, header)
        with whole_file(kept) as draft:
            write_archive(draft, files)
    except OSError as problem:
        raise failure("E0913", reason=str(problem)) from None
    return files


def _name(export_model: ExportModel, description: str, known: Reference | None, header: str) -> str:
    """The model by its values and by its texts, which the documentation quotes."""
    flat = export_model.compilation.flat
    texts = [part for file in files_of(flat) for part in (file.name, file.text)]
    motion = [] if known is None else [str(known.ended), repr(known.tolerance), *known.files().values()]
    license_text = license_file().read_text(encoding="utf-8")
    digest = hashlib.sha256()
    for part in (*_writers(), repr(flat), description, header, license_text, *texts, "\0", *motion):
        data = part.encode()
        digest.update(f"{len(data)}:".encode() + data)
    return digest.hexdigest()[:40]


def _writers() -> list[str]:
    """Versions of all that writes; in a checkout the time of the newest module, too."""
    found = [__version__]
    for package in _WRITERS:
        try:
            found.append(version(package))
        except PackageNotFoundError:
            found.append("")
    if is_checkout():
        found.append(str(max(path.stat().st_mtime_ns for path in _PACKAGE.rglob("*.py"))))
    return found
