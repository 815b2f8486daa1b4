"""From C sources to shared libraries, one for each platform; objects are kept by content."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from lagdsl.fmi.package.compile_objects import Job, compile_missing, object_name, work_folder
from lagdsl.fmi.package.installed_objects import installed_object
from lagdsl.fmi.package.libraries import without_timestamps
from lagdsl.fmi.package.toolchain import Toolchain, toolchain
from lagdsl.record import record
from lagdsl.runtime.building.cache import cache_folder
from lagdsl.runtime.building.platforms import Platform, this_machine


@record()
class Objects:
    """Object files: paths by platform, in the order of the sources."""

    stem: str
    tools: tuple[Toolchain, ...]
    paths: Mapping[str, list[str]]

    def libraries(self) -> dict[str, bytes]:
        """The libraries `stem`.so and so on by the name of their platform. Raises CompilationFailed: E0906, E0913."""
        with work_folder(cache_folder()) as folder:
            return {tool.platform.name: self._linked(tool, folder) for tool in self.tools}

    @contextmanager
    def open_library(self) -> Iterator[Path | None]:
        """The library for this machine with all functions to be seen, if that can be made of the objects: it is there
        for as long as it takes to load it.

        Raises CompilationFailed: E0906, E0913.
        """
        own = next((tool for tool in self.tools if tool.opens and tool.platform.name == this_machine()), None)
        if own is None:
            yield None
            return
        with work_folder(cache_folder()) as folder:
            own.link(folder, self.paths[own.platform.name], self.stem, opened=True)
            yield folder / self.stem

    def _linked(self, tool: Toolchain, folder: Path) -> bytes:
        target = self.stem + tool.platform.suffix
        tool.link(folder, self.paths[tool.platform.name], target)
        library = folder / target
        content = without_timestamps(library.read_bytes())
        library.unlink()
        return content


def objects_of(
    sources: Mapping[str, str],
    stem: str,
    platforms: Sequence[Platform],
    progress: Callable[[float], None] | None = None,
) -> Objects:
    """The same sources, the same bytes, in any folder. `progress` is called with the part of the work that is done.

    Raises CompilationFailed: E0905, E0906, E0911, E0913.
    """
    tools = tuple(toolchain(platform) for platform in platforms)
    kept = cache_folder()
    jobs = [
        Job(tool, path, installed_object(tool, path, sources) or kept / object_name(tool.flags, path, sources))
        for tool in tools
        for path in sorted(sources)
        if path.endswith(".c")
    ]
    with work_folder(kept) as folder:
        compile_missing(jobs, sources, folder, progress)
    found: dict[str, list[str]] = {}
    for job in jobs:
        found.setdefault(job.tool.platform.name, []).append(str(job.target))
    return Objects(stem, tools, found)
