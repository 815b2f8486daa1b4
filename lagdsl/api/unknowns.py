"""A compiled model with coordinates of cut joints as unknowns, since their starts are set."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from lagdsl.diagnostics import Sink
from lagdsl.settings.unknowns import unknowns_of

if TYPE_CHECKING:
    from lagdsl.pipeline import Compilation
    from lagdsl.source import SourceFile


def with_unknowns(compilation: Compilation, source: SourceFile | None, names: Iterable[str]) -> Compilation | None:
    """The model of `source` with these starts among its own. None where it has them, and for a model that is not that
    of its text any longer: with fixed parameters, or without a text."""
    names = list(names)
    if not names:
        return None
    from lagdsl.pipeline import compile_flat, flatten_unit, parse_file

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
