"""Checks, before anything is compiled, for models that the standards cannot express; notes that an importer must
know."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping

from lagdsl.exchange.fmi.variables.names import named
from lagdsl.exchange.fmi.variables.variables import Kind
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.evaluate import Values, evaluate
from lagdsl.language.flat.events import Discrete
from lagdsl.language.flat.model import FlatModel, Input, Parameter
from lagdsl.language.flat.spans import around, place

# Of Integer of FMI 2 and of Int32 of FMI 3.
_LEAST, _MOST = -(2**31), 2**31 - 1


def refuse(flat: FlatModel, version: int, kinds: Collection[Kind], values: Mapping[str, float], sink: Sink) -> None:
    """Report what an FMU of this `version` (2 or 3) of the standard cannot hold (E0902), delays for model exchange
    (E0917), and which inputs belong together (N0903). `values` replace defaults of parameters, by name, in SI units."""
    if flat.events.delays and "me" in kinds:
        first = flat.events.delays[0]
        sink.report("E0917", place(first), *around(first), name=first.name)
    counted: tuple[Parameter | Discrete | Input, ...] = (*flat.parameters, *flat.events.discretes, *flat.inputs)
    for item in counted:
        for what, value in _integers(flat, item, values):
            if not _LEAST <= value <= _MOST:
                sink.report(
                    "E0902",
                    place(item),
                    *around(item),
                    what=what,
                    name=item.name,
                    value=f"{value:.17g}",
                    version=version,
                    least=_LEAST,
                    most=_MOST,
                )
    for driven in flat.inputs:
        if driven.smooth:
            derivatives = ", ".join(f"`{named(name).text}`" for name in _derivatives(flat, driven))
            sink.report("N0903", place(driven), *around(driven), name=named(driven.name).text, derivatives=derivatives)


def _integers(
    flat: FlatModel, item: Parameter | Discrete | Input, values: Mapping[str, float]
) -> Iterator[tuple[str, float]]:
    """Values that an FMU writes as integers; bounds at infinity are no bounds."""
    if item.base not in ("Integer", "Enumeration"):
        return
    if isinstance(item, Parameter):
        yield "the value", values.get(item.name, item.value)
    else:
        start = item.start if isinstance(item, Discrete) else item.default
        yield "the start", evaluate(flat, start, Values(variables=values))
    for what, bound in (("the min", item.minimum), ("the max", item.maximum)):
        if bound is not None and math.isfinite(bound):
            yield what, bound


def _derivatives(flat: FlatModel, item: Input) -> Iterator[str]:
    """Names of the inputs that are time derivatives of `item`, in their order."""
    name = item.name
    for other in flat.inputs:
        if other.derivative_of == name:
            yield other.name
            name = other.name
