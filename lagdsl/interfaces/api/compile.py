"""From a path or a text to a Model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.collection import without_collection
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.api.model import Model
from lagdsl.interfaces.api.names import Value, known
from lagdsl.language.flat.fixed_parameters import fix_parameters, matching_values
from lagdsl.language.flat.limits import check_limits
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.target import targets
from lagdsl.motion.pipeline import Route, compile_flat, flatten_file, read


def compile(
    source: Path | str,
    *,
    model: str | None = None,
    engine: EngineName = "auto",
    derivation: Route = "graph",
    structural: Mapping[str, float] | None = None,
    fix: bool | Iterable[str] | Mapping[str, Value] = False,
) -> Model:
    """The model in `source`: a path, or a text (a string with a line end or a semicolon).

    `engine` computes the functions: `auto` begins with the tape, at once and without a compiler, and takes C where the
    work that is foreseen pays for it; `tape`, `c`; `numpy` to compare with. `model` names one of several; the default
    is the last complete one that no other uses. `structural` replaces structural parameters. `fix` makes parameters
    numbers of the model, which then has shorter equations and no such entry of `p`: all of them (True), those that
    names and patterns such as `arm.*` choose, or those of a mapping, with its values (numbers in SI units, texts such
    as `2 kg`). Raises CompilationFailed with everything that was found wrong; KeyError and ValueError for a parameter
    that cannot be fixed so."""
    sink = Sink()
    file = read(source, sink)
    return compile_file(file, sink, model=model, engine=engine, derivation=derivation, structural=structural, fix=fix)


@without_collection()
def compile_file(
    file: SourceFile | None,
    sink: Sink,
    *,
    model: str | None = None,
    engine: EngineName = "auto",
    derivation: Route = "graph",
    structural: Mapping[str, float] | None = None,
    fix: bool | Iterable[str] | Mapping[str, Value] = False,
) -> Model:
    """The model in a text that was read; None stands for one that could not be, which is in `sink`. See `compile`."""
    flat = flatten_file(file, sink, model=model, structural=structural) if file is not None else None
    if flat is not None and fix:
        flat = _with_fixed(flat, fix, sink)
    compilation = compile_flat(flat, sink, derivation) if flat is not None else None
    sink.raise_if_errors()
    assert compilation is not None, "internal error: a stage gave up without saying why"
    return Model(compilation, engine_of(compilation.program, engine), file)


def _with_fixed(flat: FlatModel, fix: bool | Iterable[str] | Mapping[str, Value], sink: Sink) -> FlatModel:
    if isinstance(fix, Mapping):
        values = known("parameter", fix, targets(flat, ("parameter", "structural")))
    elif isinstance(fix, str):
        raise TypeError(f"fix takes a list of names: fix=[{fix!r}]")
    elif isinstance(fix, bool):
        values = {parameter.name: parameter.value for parameter in flat.parameters if not parameter.structural}
    else:
        values = matching_values(flat, fix)
    check_limits(flat, values, sink)
    return fix_parameters(flat, values)
