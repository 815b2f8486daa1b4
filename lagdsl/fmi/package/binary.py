"""From C sources to shared libraries, one for each platform; objects are kept by content and made on all cores."""

from __future__ import annotations

import hashlib
import re
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path

from lagdsl.fmi.package.libraries import without_timestamps
from lagdsl.fmi.package.toolchain import Toolchain, toolchain
from lagdsl.record import record
from lagdsl.runtime.building.cache import cache_folder
from lagdsl.runtime.building.compiler import failure
from lagdsl.runtime.building.platforms import Platform, this_machine
from lagdsl.runtime.engines.cores import cores
from lagdsl.runtime.lock import lock_of, locked

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


@record()
class Objects:
    """Object files: paths by platform, in the order of the sources."""

    stem: str
    tools: tuple[Toolchain, ...]
    paths: Mapping[str, list[str]]

    def libraries(self) -> dict[str, bytes]:
        """The libraries `stem`.so and so on by the name of their platform. Raises CompilationFailed: E0906, E0913."""
        with _folder() as folder:
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
        with _folder() as folder:
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
    jobs = [(tool, path) for tool in tools for path in sorted(sources) if path.endswith(".c")]
    with _folder() as folder:
        return Objects(stem, tools, _objects(jobs, sources, folder, folder.parent, progress))


@contextmanager
def _folder() -> Iterator[Path]:
    """A folder beside what is kept. Raises CompilationFailed: E0913."""
    try:
        with tempfile.TemporaryDirectory(dir=cache_folder(), prefix="fmu-") as name:
            yield Path(name)
    except OSError as problem:
        raise failure("E0913", reason=str(problem)) from None


def _write(sources: Mapping[str, str], names: Iterable[str], folder: Path) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(sources[name], encoding="utf-8", newline="\n")


def _objects(
    jobs: Sequence[tuple[Toolchain, str]],
    sources: Mapping[str, str],
    folder: Path,
    kept: Path,
    progress: Callable[[float], None] | None,
) -> dict[str, list[str]]:
    """Paths of the object files by platform, in the order of the sources. The first failure is raised."""
    found: dict[str, list[str]] = {}
    read = {path: _read(path, sources) for path in dict.fromkeys(path for _, path in jobs)}
    parts = {path: [part for name in names for part in (name, sources[name])] for path, names in read.items()}
    targets = [kept / f"{_digest(*tool.flags, *parts[path])}.o" for tool, path in jobs]
    missing = (path for target, (_, path) in zip(targets, jobs, strict=True) if not target.exists())
    _write(sources, dict.fromkeys(name for path in missing for name in read[path]), folder)

    def compiled(number: int) -> str:
        tool, path = jobs[number]
        target = targets[number]
        if not target.exists():
            with locked(lock_of(target)):
                if not target.exists():
                    draft = f"{number}.o"
                    tool.compile(folder, path, draft)
                    (folder / draft).replace(target)
        return str(target)

    with ThreadPoolExecutor(cores()) as pool:
        for number, target in enumerate(pool.map(compiled, range(len(jobs)))):
            found.setdefault(jobs[number][0].platform.name, []).append(target)
            if progress is not None:
                progress((number + 1) / len(jobs))
    return found


def _read(path: str, sources: Mapping[str, str]) -> list[str]:
    """Names of a C file and all that it includes: another model finds the runtime compiled by names and texts."""
    names = [path]
    for name in names:
        included = (each for each in _included(sources[name]) if each in sources)
        names += [each for each in included if each not in names]
    return names


@lru_cache(maxsize=1024)
def _included(text: str) -> tuple[str, ...]:
    """Most files are those of the runtime, the same ones in each FMU."""
    return tuple(dict.fromkeys(_INCLUDE.findall(text)))


def _digest(*parts: str) -> str:
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode()
        digest.update(f"{len(data)}:".encode() + data)
    return digest.hexdigest()[:40]
