"""C sources that build with their own Makefile: the generated model and, copied beside it, the runtime."""

from __future__ import annotations

from lagdsl.backends.backend import Artifact
from lagdsl.backends.c.source import header, source, symbol
from lagdsl.backends.identifier import identifier
from lagdsl.program.program import Program
from lagdsl.resources import c_folder

# Names that the Makefile, the runtime or the example have taken.
_RESERVED = frozenset({"main", "realtime", "makefile", "lag", "all", "clean"})
_EXAMPLES = ("main.c", "realtime.c")


class CBackend:
    """Target `c`."""

    name = "c"

    def emit(self, program: Program) -> Artifact:
        stem = identifier(program.name, _RESERVED)
        folder = c_folder() / "example"
        head = f'#include "{stem}.h"\n#define MODEL {symbol(stem)}\n\n'
        makefile = (folder / "Makefile").read_text(encoding="utf-8")
        return Artifact(
            {
                **sources(program),
                **{name: head + (folder / name).read_text(encoding="utf-8") for name in _EXAMPLES},
                "Makefile": f"MODEL := {stem}\n{makefile}",
            }
        )


def model_symbol(program: Program) -> str:
    """Name of the constant of type lag_model that the sources define."""
    return symbol(identifier(program.name, _RESERVED))


def sources(program: Program, lanes: bool = False) -> dict[str, str]:
    """What a library of the model is compiled from, by relative path; with `lanes` for many states at once too."""
    stem = identifier(program.name, _RESERVED)
    return {f"{stem}.c": source(program, stem, lanes), f"{stem}.h": header(stem), **runtime_sources()}


def runtime_sources() -> dict[str, str]:
    """The runtime's own files, all in one folder `lag`."""
    files = sorted(
        [*(c_folder() / "include" / "lag").glob("*.h"), *(c_folder() / "src").glob("*.c")], key=lambda f: f.name
    )
    return {f"lag/{file.name}": file.read_text(encoding="utf-8") for file in files}
