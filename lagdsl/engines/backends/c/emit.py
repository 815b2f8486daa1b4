"""C sources that build with their own Makefile: the generated model and, copied beside it, the runtime."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.c.include_files import included
from lagdsl.engines.backends.c.jacobian import jacobian_source
from lagdsl.engines.backends.c.lanes import states_source, tangents_source
from lagdsl.engines.backends.c.literal import number
from lagdsl.engines.backends.c.source import header, source, symbol
from lagdsl.engines.backends.identifier import identifier
from lagdsl.engines.backends.reserved import C_NAMES
from lagdsl.engines.backends.start import Start
from lagdsl.foundation.resources import c_folder, compiled_runtime

PARTS: dict[str, Callable[[Program, str], str]] = {
    "states": states_source,
    "tangents": partial(tangents_source, parameters=False),
    "parameter_tangents": partial(tangents_source, parameters=True),
    "jacobian": jacobian_source,
}
# Of these, what files for others have: functions of many states, and of many directions.
_BATCH = ("states", "tangents", "parameter_tangents")

_EXAMPLES = ("main.c", "realtime.c")


class CBackend:
    """Target `c`. `batch`: with the functions of many states and of many directions at once."""

    name = "c"

    def __init__(self, *, batch: bool = False, start: Start | None = None) -> None:
        self._parts = _BATCH if batch else ()
        self._start = start

    def emit(self, program: Program) -> Artifact:
        stem = stem_of(program)
        constants = {"MODEL": symbol(stem), "START": f"{stem}_start"}
        defined = "".join(f"#define {name} {value}\n" for name, value in constants.items())
        head = f'#include "{stem}.h"\n{defined}\n'
        return Artifact(
            {
                **started_sources(program, self._start, self._parts),
                **_headers_of_no_library(),
                **{name: head + _example(name) for name in _EXAMPLES},
                "Makefile": f"MODEL := {stem}\n{_example('Makefile')}",
                "README.md": _example("README.md").replace("MODEL", stem),
            }
        )


def stem_of(program: Program) -> str:
    """Stem of the names of files and constants of the model: an identifier, and a file name everywhere."""
    return identifier(program.name, C_NAMES)


def model_symbol(program: Program) -> str:
    """Name of the constant of type lag_model that the sources define."""
    return symbol(stem_of(program))


def part_symbol(program: Program, part: str) -> str:
    """Name of the constant, of type lag_states or lag_tangents, that the sources with this part define."""
    return f"{stem_of(program)}_{part}"


def sources(program: Program, parts: Sequence[str] = ()) -> dict[str, str]:
    """Sources of a library that stands alone, by relative path: the model and the runtime. `parts` of PARTS
    are the functions of several states, or of several directions of derivatives, at once."""
    return {**_own_sources(program, parts), **runtime_sources()}


def engine_sources(program: Program, parts: Sequence[str] = ()) -> dict[str, str]:
    """Sources of a library of the model alone, for the runtime of the package: generated files, the headers
    that they include, and what generated functions call."""
    own = _own_sources(program, parts)
    if program.has("momentum_tangent"):
        own["lag/equations/columns.c"] = (c_folder() / "lag/equations/columns.c").read_text(encoding="utf-8")
    return {**own, **included(own.values(), _header)}


def _own_sources(program: Program, parts: Sequence[str]) -> dict[str, str]:
    stem = stem_of(program)
    own = {f"{stem}.c": source(program, stem), f"{stem}.h": header(stem)}
    return own | {f"{stem}_{part}.c": PARTS[part](program, stem) for part in parts}


def _header(name: str) -> str | None:
    """A header of the runtime; others are generated."""
    path = c_folder() / name
    return path.read_text(encoding="utf-8") if path.is_file() else None


def started_sources(program: Program, start: Start | None, parts: Sequence[str] = ()) -> dict[str, str]:
    """The same with the constant, of type lag_start, that tells where the motion starts."""
    stem = stem_of(program)
    return {
        **sources(program, parts),
        f"{stem}.h": header(stem, parts, start=True),
        f"{stem}_start.c": _start(stem, start),
    }


def runtime_sources() -> dict[str, str]:
    """The runtime's own files, in the folder `lag`."""
    return {path: file.read_text(encoding="utf-8") for path, file in compiled_runtime().items()}


_NUMBERS = ("x", "nominal", "minimum", "maximum", "parameter_nominal", "parameter_minimum", "parameter_maximum")


def _start(stem: str, start: Start | None) -> str:
    told = start or Start(0.0, ())
    flags = {name: [str(int(flag)) for flag in getattr(told, name)] for name in ("fixed", "written", "free")}
    numbers = {name: [number(v) for v in getattr(told, name)] for name in _NUMBERS}
    tables = [*(("unsigned char", item) for item in flags.items()), *(("double", item) for item in numbers.items())]
    arrays = [
        "".join([f"static const {kind} start_{name}[] = {{\n", *(f"    {row},\n" for row in rows), "};\n"])
        for kind, (name, rows) in tables
        if rows
    ]
    members = "".join(f"    .{name} = start_{name},\n" for _, (name, rows) in tables if rows)
    return (
        f'/* Where the motion starts. */\n#include "{stem}.h"\n\n{"".join(arrays)}\n'
        f"const lag_start {stem}_start = {{\n    .t = {number(told.t)},\n{members}}};\n"
    )


def _example(name: str) -> str:
    return (c_folder() / "example" / name).read_text(encoding="utf-8")


def _headers_of_no_library() -> dict[str, str]:
    """Headers for compilers that come without a C library."""
    folder = c_folder() / "freestanding"
    return {f"freestanding/{file.name}": file.read_text(encoding="utf-8") for file in sorted(folder.glob("*.h"))}
