"""lagdsl's part: text to C, C to a library, the library in a C loop."""

import os
import resource
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from lagdsl.backends.c.emit import model_symbol, sources
from lagdsl.diagnostics import Sink
from lagdsl.pipeline import front, middle
from lagdsl.program.program import Program
from lagdsl.runtime.build import build
from lagdsl.semantics.library import read_source

MODELS = Path(__file__).with_name("models")


@dataclass(frozen=True)
class Made:
    """A model as a library; CPU seconds of the compiler (text to C) and of the C compiler, characters of C."""

    library: Path
    symbol: str
    program: Program
    python: float
    compiler: float
    size: int


def program(name: str, n: int | None) -> Program:
    """Text to program, with everything that `lag build` does."""
    sink = Sink()
    source = read_source(MODELS / f"{name}.lag", sink)
    assert source is not None
    flat = front(source, sink, structural={} if n is None else {"N": float(n)})
    sink.raise_if_errors()
    assert flat is not None
    compilation = middle(flat, sink)
    sink.raise_if_errors()
    assert compilation is not None
    return compilation.program


def text(name: str, n: int | None) -> tuple[Program, Mapping[str, str], float]:
    """The C sources, and the CPU seconds they took."""
    start = time.process_time()
    made = program(name, n)
    files = sources(made)
    return made, files, time.process_time() - start


def make(name: str, n: int | None, *compilers: str) -> list[Made]:
    """A library by each compiler, afresh: nothing comes from the cache but the objects of the runtime."""
    made, files, python = text(name, n)
    result = []
    for compiler in compilers:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        library = _built(files, compiler)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        size = max(map(len, files.values()))
        result.append(Made(library, model_symbol(made), made, python, seconds, size))
    return result


def _built(files: Mapping[str, str], compiler: str) -> Path:
    before = os.environ.get("CC")
    os.environ["CC"] = compiler
    try:
        return build(_fresh(files), fresh=True)
    finally:
        if before is None:
            del os.environ["CC"]
        else:
            os.environ["CC"] = before


def _fresh(files: Mapping[str, str]) -> dict[str, str]:
    """The same sources with a comment that no earlier run had, so that no object of them is in the cache."""
    stamp = f"/* {os.getpid()} {time.time_ns()} */\n"
    return {path: text if path.startswith("lag/") else stamp + text for path, text in files.items()}
