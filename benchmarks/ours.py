"""lagdsl's part: text to C, C to a library."""

import json
import os
import statistics
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from measure import children_cpu_seconds, in_fresh_process

from lagdsl.algebra.eliminate.count import flops
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import model_symbol, part_symbol, sources
from lagdsl.engines.runtime.building.build import build
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.fixed_parameters import fix_parameters, matching_values
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.motion.pipeline import compile_flat, flatten_file

MODELS = Path(__file__).with_name("models")


@dataclass(frozen=True)
class Made:
    """A model as a library, which has the constants `symbols`. CPU seconds from text to C (imports not counted) and of
    the C compiler; characters of C; coordinates; flops of one forward dynamics, None where the equations are solved at
    run time."""

    library: Path
    symbols: tuple[str, ...]
    python: float
    compiler: float
    size: int
    n: int
    flops: int | None


def program(name: str, n: int | None, *, fixed: bool = False) -> Program:
    """Text to program, with everything that `lag build` does; `fixed`: with `--fix '*'`, as peers hold numbers."""
    sink = Sink()
    source = read_source(MODELS / f"{name}.lag", sink)
    assert source is not None
    flat = flatten_file(source, sink, structural={} if n is None else {"N": float(n)})
    sink.raise_if_errors()
    assert flat is not None
    if fixed:
        flat = fix_parameters(flat, matching_values(flat, ["*"]))
    compilation = compile_flat(flat, sink)
    sink.raise_if_errors()
    assert compilation is not None
    return compilation.program


def make(name: str, n: int | None = None, *, parts: tuple[str, ...] = (), fixed: bool = False) -> Made:
    """A library as `engine="c"` makes it, afresh: nothing comes from the cache but the objects of the runtime.

    `parts` are the functions of several states, or of several directions, that engines build when first needed.
    """
    start = time.process_time()
    made = program(name, n, fixed=fixed)
    files = sources(made, parts)
    python = time.process_time() - start
    seconds, library = children_cpu_seconds(lambda: build(_fresh(files), fresh=True))
    size = max(map(len, files.values()))
    coordinates = len(made.layout.coordinates)
    symbols = (model_symbol(made), part_symbol(made, "states"), part_symbol(made, "tangents"))
    return Made(library, symbols, python, seconds, size, coordinates, _flops(made))


def in_processes(name: str, n: int | None = None, *, parts: tuple[str, ...] = (), runs: int = 1) -> Made:
    """The same in fresh processes: medians of the times."""
    code = f"import ours; ours.tell({name!r}, {n!r}, {parts!r})"
    found = []
    for _ in range(runs):
        answer = in_fresh_process(code)
        assert isinstance(answer, dict)
        found.append(Made(**{**answer, "library": Path(answer["library"]), "symbols": tuple(answer["symbols"])}))
    python, compiler = (statistics.median(getattr(made, what) for made in found) for what in ("python", "compiler"))
    return Made(**{**asdict(found[-1]), "python": python, "compiler": compiler})


def tell(name: str, n: int | None, parts: tuple[str, ...]) -> None:
    """Print `make` as JSON, the objects of the runtime being there already."""
    made = make(name, n, parts=parts)
    print(json.dumps({**asdict(made), "library": str(made.library)}))


def _flops(made: Program) -> int | None:
    """Of qdd, where all multipliers are solved for while they are expressions."""
    if not made.has("elimination") or made.kept_rows:
        return None
    (block,) = [each for each in made.function("elimination").results if each.name in ("a", "qdd")]
    return flops(made.graph, block.elements)


def _fresh(files: Mapping[str, str]) -> dict[str, str]:
    """The same sources with a comment that no earlier run had, so that no object of them is in the cache."""
    stamp = f"/* {os.getpid()} {time.time_ns()} */\n"
    return {path: text if path.startswith("lag/") else stamp + text for path, text in files.items()}
