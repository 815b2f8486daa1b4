"""From C sources to shared libraries, one for each platform; objects are kept by content."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.building.platforms import Platform, this_machine
from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.exchange.fmi.package.compile_objects import Job, c_files, compile_missing, object_name, work_folder
from lagdsl.exchange.fmi.package.installed_objects import installed_object
from lagdsl.exchange.fmi.package.libraries import without_timestamps
from lagdsl.exchange.fmi.package.toolchain import Toolchain, toolchain
from lagdsl.foundation.record import record


@record()
class Objects:
    """Object files: paths by platform, in the order of the sources."""

    stem: str
    tools: tuple[Toolchain, ...]
    paths: Mapping[str, list[str]]

    def libraries(self, progress: Callable[[float], None] | None = None) -> dict[str, bytes]:
        """The libraries `stem`.so and so on by the name of their platform, linked on all cores: the first one for a
        platform compiles its libraries of C. `progress` is called with the part of the work that is done.

        Raises CompilationFailed: E0906, E0913.
        """
        found = {}
        with work_folder(cache_folder()) as folder, ThreadPoolExecutor(cores()) as pool:
            for tool, library in zip(self.tools, pool.map(partial(self._linked, folder), self.tools), strict=True):
                found[tool.platform.name] = library
                if progress is not None:
                    progress(len(found) / len(self.tools))
        return found

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

    def _linked(self, folder: Path, tool: Toolchain) -> bytes:
        own = folder / tool.platform.name
        own.mkdir()
        target = self.stem + tool.platform.suffix
        tool.link(own, self.paths[tool.platform.name], target)
        return without_timestamps((own / target).read_bytes())


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
        Job(tool, path, installed_object(tool, path, sources) or kept / object_name(tool.flags(path), path, sources))
        for tool in tools
        for path in c_files(sources)
    ]
    with work_folder(kept) as folder:
        compile_missing(jobs, sources, folder, progress)
    found: dict[str, list[str]] = {}
    for job in jobs:
        found.setdefault(job.tool.platform.name, []).append(str(job.target))
    return Objects(stem, tools, found)
