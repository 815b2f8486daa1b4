"""Object files by content: names from all that a C file reads, and the compiler on all cores for those that miss."""

from __future__ import annotations

import hashlib
import re
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path

from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.engines.runtime.lock import lock_of, locked
from lagdsl.exchange.fmi.package.toolchain import Toolchain
from lagdsl.foundation.record import record

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


@record()
class Job:
    """The C file `source`, and the object file `target` that is there afterwards."""

    tool: Toolchain
    source: str
    target: Path


def compile_missing(
    jobs: Sequence[Job], sources: Mapping[str, str], folder: Path, progress: Callable[[float], None] | None = None
) -> None:
    """Compile what is missing, in `folder`: the file system of the targets. The first failure is raised.

    `progress` is called with the part of the work that is done. Raises CompilationFailed: E0906.
    """
    missing = [job for job in jobs if not job.target.exists()]
    _write(sources, dict.fromkeys(name for job in missing for name in files_read(job.source, sources)), folder)

    def compiled(number: int) -> None:
        job = missing[number]
        with locked(lock_of(job.target)):
            if not job.target.exists():
                draft = f"{number}.o"
                job.tool.compile(folder, job.source, draft)
                (folder / draft).replace(job.target)

    with ThreadPoolExecutor(cores()) as pool:
        for done, _ in enumerate(pool.map(compiled, range(len(missing))), 1):
            if progress is not None:
                progress(done / len(missing))
    if progress is not None:
        progress(1.0)


@contextmanager
def work_folder(beside: Path) -> Iterator[Path]:
    """A folder on the file system of `beside`. Raises CompilationFailed: E0913."""
    try:
        with tempfile.TemporaryDirectory(dir=beside, prefix="fmu-") as name:
            yield Path(name)
    except OSError as problem:
        raise failure("E0913", reason=str(problem)) from None


def object_name(flags: Iterable[str], path: str, sources: Mapping[str, str]) -> str:
    """The file name of an object: it follows from the flags and from names and texts of all that the C file reads, so
    that another model finds the runtime compiled."""
    texts = (part for name in files_read(path, sources) for part in (name, sources[name]))
    digest = hashlib.sha256()
    for part in (*flags, *texts):
        data = part.encode()
        digest.update(f"{len(data)}:".encode() + data)
    return f"{digest.hexdigest()[:40]}.o"


def c_files(sources: Mapping[str, str]) -> tuple[str, ...]:
    """Files to compile, in a fixed order: those that no other one includes."""
    files = [path for path in sources if path.endswith(".c")]
    parts = {name for path in files for name in included(sources[path])}
    return tuple(sorted(path for path in files if path not in parts))


def files_read(path: str, sources: Mapping[str, str]) -> list[str]:
    """Names of a C file and of all among `sources` that it includes."""
    names = [path]
    for name in names:
        names += [each for each in included(sources[name]) if each in sources and each not in names]
    return names


@lru_cache(maxsize=1024)
def included(text: str) -> tuple[str, ...]:
    """Names as the text writes them. Most files are those of the runtime, the same ones in each FMU."""
    return tuple(dict.fromkeys(_INCLUDE.findall(text)))


def _write(sources: Mapping[str, str], names: Iterable[str], folder: Path) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(sources[name], encoding="utf-8", newline="\n")
