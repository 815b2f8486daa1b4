"""The files of an FMU by their paths in it."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from uuid import UUID

from lagdsl.engines.runtime.building.platforms import Platform, platform_of
from lagdsl.exchange.fmi.description.build_description import build_description
from lagdsl.exchange.fmi.description.fmi2_description import fmi2_description
from lagdsl.exchange.fmi.description.fmi3_description import fmi3_description
from lagdsl.exchange.fmi.description.table import table_source
from lagdsl.exchange.fmi.description.terminals import terminals
from lagdsl.exchange.fmi.export_model import ExportModel
from lagdsl.exchange.fmi.package.compile_objects import c_files
from lagdsl.exchange.fmi.package.libraries import universal
from lagdsl.exchange.fmi.package.sources import is_standard, model_sources
from lagdsl.exchange.fmi.variables.variables import Version

_FMI2_FOLDERS = {"x86_64-linux": "linux64", "x86_64-windows": "win64", "x86_64-darwin": "darwin64"}


def texts(export_model: ExportModel) -> tuple[str, dict[str, str]]:
    """The description and the sources. Both hold a token: the hash of all of them without it."""
    version = export_model.table.version
    sources = model_sources(export_model.program, export_model.start, version)
    table = f"{export_model.stem}_fmu.c"
    files = c_files({**sources, table: ""})

    def with_token(token: str) -> tuple[str, dict[str, str]]:
        all_sources = {**sources, table: table_source(export_model.table, export_model.stem, token)}
        return _description(export_model, files, token), all_sources

    return with_token(_token(*with_token("")))


def source_files(export_model: ExportModel, sources: Mapping[str, str]) -> dict[str, bytes]:
    """The folder `sources`, with what tells importers how to compile it.

    Headers of the standard are not in it: importers have their own (FMI 2.0.5, section 2.3; FMI 3.0, section 2.5.1).
    """
    own = {path: text for path, text in sources.items() if not is_standard(path)}
    named = {**own, "buildDescription.xml": build_description(export_model.stem, c_files(sources))}
    return {f"sources/{path}": text.encode() for path, text in named.items()}


def terminal_files(export_model: ExportModel) -> dict[str, bytes]:
    """Ports as terminals, which FMI 3 has."""
    text = terminals(export_model.table) if export_model.table.version == 3 else None
    return {} if text is None else {"terminalsAndIcons/terminalsAndIcons.xml": text.encode()}


def _description(export_model: ExportModel, files: Sequence[str], token: str) -> str:
    table, stem, attribution = export_model.table, export_model.stem, export_model.attribution
    if table.version == 2:
        return fmi2_description(table, identifier=stem, source_files=files, token=token, attribution=attribution)
    return fmi3_description(table, identifier=stem, token=token, attribution=attribution)


def _token(description: str, sources: Mapping[str, str]) -> str:
    digest = hashlib.sha256()
    for part in (description, *(part for path in sorted(sources) for part in (path, sources[path]))):
        data = part.encode()
        digest.update(f"{len(data)}:".encode() + data)
    return f"{{{UUID(bytes=digest.digest()[:16])}}}"


def library_files(libraries: Mapping[str, bytes], stem: str, version: Version) -> dict[str, bytes]:
    """Libraries by platform in the folders where importers look for them.

    FMI 2.0.5 names folders for x86 and takes those of FMI 3 for the rest. Importers that know no others look into
    `linux64` and `darwin64` on any processor: there goes what no other library claims, and on macOS one for both.
    """
    platforms = [platform_of(name) for name in libraries]
    if version == 3:
        return {_place(each.tuple, stem, each): libraries[each.name] for each in platforms}
    found: dict[str, bytes] = {}
    for each in platforms:
        found[_place(_FMI2_FOLDERS.get(each.tuple, each.tuple), stem, each)] = libraries[each.name]
    return found | _for_any_processor(libraries, stem, platforms)


def _for_any_processor(libraries: Mapping[str, bytes], stem: str, platforms: Sequence[Platform]) -> dict[str, bytes]:
    found = {}
    apples = [each for each in platforms if each.system == "macos"]
    if any(each.tuple not in _FMI2_FOLDERS for each in apples):
        found[_place("darwin64", stem, apples[0])] = universal([libraries[each.name] for each in apples])
    linux = [each for each in platforms if each.system == "linux"]
    if len(linux) == 1:
        found[_place("linux64", stem, linux[0])] = libraries[linux[0].name]
    return found


def _place(folder: str, stem: str, platform: Platform) -> str:
    return f"binaries/{folder}/{stem}{platform.suffix}"
