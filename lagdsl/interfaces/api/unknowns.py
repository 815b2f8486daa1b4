"""A compiled model with coordinates of cut joints as unknowns, since their starts are set."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, Concatenate, ParamSpec, Protocol, Self, TypeVar

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.settings.unknowns import unknowns_of

if TYPE_CHECKING:
    from lagdsl.foundation.source import SourceFile
    from lagdsl.motion.pipeline import Compilation


class _Startable(Protocol):
    def _of_starts(self, start: Mapping[str, object] | None) -> Self: ...


M = TypeVar("M", bound=_Startable)
P = ParamSpec("P")
T = TypeVar("T")


def with_starts(method: Callable[Concatenate[M, P], T]) -> Callable[Concatenate[M, P], T]:
    """`method`, called of a model that has the starts that are given among its own."""

    @wraps(method)
    def called(self: M, /, *args: P.args, **kwargs: P.kwargs) -> T:
        start = kwargs.get("start")
        return method(self._of_starts(start) if isinstance(start, dict | Mapping) else self, *args, **kwargs)

    return called


def with_unknowns(compilation: Compilation, source: SourceFile | None, names: Iterable[str]) -> Compilation | None:
    """The model of `source` with these starts among its own. None where it has them, and for a model that is not that
    of its text any longer: with fixed parameters, or without a text."""
    names = list(names)
    if not names:
        return None
    from lagdsl.motion.pipeline import compile_flat, flatten_unit, parse_file

    flat = compilation.flat
    unknowns = unknowns_of(flat, [name for name in names if isinstance(name, str)])
    if not unknowns or source is None:
        return None
    sink = Sink()
    structural = {p.name: p.value for p in flat.parameters if p.structural}
    unit = parse_file(source, sink)
    found = flatten_unit(unit, sink, model=flat.name, structural=structural, unknowns=unknowns) if unit else None
    if found is None or found.parameters != flat.parameters:
        return None
    return compile_flat(found, sink, compilation.route)
