"""Object files of the runtime that an installation brings for its own platform: its first FMU compiles the model only.

They are named by flags and texts, not by the version of the package ziglang: any version links them. Another text, such
as that of an edited runtime, has another name, and the folder of compiled models keeps its object. The build hook
(`hatch_build.py`) imports this module without any third-party package but ziglang.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from lagdsl.engines.runtime.building.platforms import Platform
from lagdsl.exchange.fmi.package.compile_objects import (
    Job,
    compile_missing,
    files_read,
    included,
    object_name,
    work_folder,
)
from lagdsl.exchange.fmi.package.toolchain import Toolchain, toolchain
from lagdsl.foundation.resources import c_folder, fmi_folder, fmi_objects_folder, sources_in


def installed_object(tool: Toolchain, path: str, sources: Mapping[str, str]) -> Path | None:
    """The object of the C file `path` if the installation brings it."""
    flags = tool.target_flags(path)
    if flags is None:
        return None
    found = fmi_objects_folder() / object_name(flags, path, sources)
    return found if found.exists() else None


def make_installed_objects(folder: Path, platform: Platform) -> list[Path]:
    """Objects of all C files that every model shares, in `folder`, which loses those of older texts; nothing where the
    package ziglang is missing.

    Raises CompilationFailed: E0905, E0906, E0911, E0913.
    """
    tool = toolchain(platform)
    if not tool.by_zig:
        return []
    folder.mkdir(parents=True, exist_ok=True)
    sources = {
        path: file.read_text(encoding="utf-8")
        for top in (c_folder(), fmi_folder())
        for path, file in sources_in(top).items()
    }
    jobs = [
        Job(tool, path, folder / object_name(flags, path, sources))
        for path in sources
        if _whole(path, sources) and (flags := tool.target_flags(path)) is not None
    ]
    with work_folder(folder) as work:
        compile_missing(jobs, sources, work)
    made = [job.target for job in jobs]
    for path in set(folder.glob("*.o")) - set(made):
        path.unlink(missing_ok=True)
    return made


def _whole(path: str, sources: Mapping[str, str]) -> bool:
    """True for a C file of which everything is here: headers of the standard come with the package fmpy."""
    read = files_read(path, sources) if path.endswith(".c") else []
    return bool(read) and all(name in sources for each in read for name in included(sources[each]))
