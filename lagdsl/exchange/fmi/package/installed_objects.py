"""Object files of the runtime that an installation brings for all platforms: its first FMU compiles the model only.

They are named by flags and texts, not by the version of the package ziglang: any version links them. Another text, such
as that of an edited runtime, has another name, and the folder of compiled models keeps its object. The build hook
(`hatch_build.py`) imports this module without any third-party package but ziglang.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from lagdsl.engines.runtime.building.linking import zig_program
from lagdsl.engines.runtime.building.platforms import Platform
from lagdsl.exchange.fmi.package.compile_objects import (
    Job,
    c_files,
    compile_missing,
    files_read,
    included,
    object_name,
    work_folder,
)
from lagdsl.exchange.fmi.package.toolchain import Toolchain, target_flags, toolchain
from lagdsl.foundation.resources import (
    c_folder,
    compiled_runtime,
    fmi_folder,
    fmi_objects_folder,
    sources_in,
    units_in,
)


def installed_object(tool: Toolchain, path: str, sources: Mapping[str, str]) -> Path | None:
    """The object of the C file `path` if the installation brings it."""
    return _brought(tool.platform, path, sources) if tool.by_zig else None


def installed_runtime(platform: Platform) -> dict[str, Path]:
    """Objects of the whole runtime for a platform, by names of files; none where the installation lacks one."""
    sources = _texts({**compiled_runtime(), **units_in(c_folder())})
    found = {f"{Path(path).stem}.o": _brought(platform, path, sources) for path in c_files(sources)}
    there = {name: file for name, file in found.items() if file is not None}
    return there if len(there) == len(found) else {}


def _brought(platform: Platform, path: str, sources: Mapping[str, str]) -> Path | None:
    found = fmi_objects_folder() / object_name(target_flags(platform, path), path, sources)
    return found if found.exists() else None


def make_installed_objects(folder: Path, platforms: Sequence[Platform]) -> list[Path]:
    """Objects of all C files that every model shares, in `folder`, which loses those of older texts; nothing where the
    package ziglang is missing.

    Raises CompilationFailed: E0905, E0906, E0911, E0913.
    """
    if zig_program() is None:
        return []
    folder.mkdir(parents=True, exist_ok=True)
    shells = {**sources_in(fmi_folder()), **units_in(fmi_folder())}
    sources = _texts({**compiled_runtime(), **units_in(c_folder()), **shells})
    jobs = [
        Job(tool, path, folder / object_name(target_flags(tool.platform, path), path, sources))
        for tool in map(toolchain, platforms)
        for path in c_files(sources)
        if _whole(path, sources)
    ]
    with work_folder(folder) as work:
        compile_missing(jobs, sources, work)
    made = [job.target for job in jobs]
    for path in set(folder.glob("*.o")) - set(made):
        path.unlink(missing_ok=True)
    return made


def _texts(files: Mapping[str, Path]) -> dict[str, str]:
    return {path: file.read_text(encoding="utf-8") for path, file in files.items()}


def _whole(path: str, sources: Mapping[str, str]) -> bool:
    """True for a C file of which everything is here: headers of the standard come with the package fmpy."""
    return all(name in sources for each in files_read(path, sources) for name in included(sources[each]))
