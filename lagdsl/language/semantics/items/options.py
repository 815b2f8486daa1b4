"""Options behind `with` of contacts, frictions and measurements: their names, and values that are not negative."""

from __future__ import annotations

import math

from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.units import Dimension
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.event_limits import require
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import name_span
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Scalar, rank
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.types.dimensions import require as require_dimension
from lagdsl.language.syntax import nodes


def options_of(
    ctx: Context, node: nodes.Contact | nodes.Friction | nodes.Measure, statement: str, known: tuple[str, ...]
) -> dict[str, nodes.Named] | None:
    """The options by name; None after E0202 for one that is not among `known`, E0212 for one that stands twice."""
    found: dict[str, nodes.Named] = {}
    for option in node.options:
        if option.name not in known:
            hint = did_you_mean(option.name, known)
            listed = ", ".join(known)
            ctx.sink.report("E0202", name_span(option), name=option.name, type=statement, attributes=listed, help=hint)
            return None
        if option.name in found:
            ctx.sink.report("E0212", name_span(option), name=option.name)
            return None
        found[option.name] = option
    return found


def option_value(
    ctx: Context,
    scope: Scope,
    option: nodes.Named | None,
    what: str,
    dimension: Dimension,
    latest: Variability = Variability.CONTINUOUS,
    *,
    most: float = math.inf,
    strict: bool = False,
    named: str | None = None,
) -> Scalar | None:
    """The value of an option, of the dimension, which diagnostics may name, that varies no more than `latest`; it is
    not negative. None without the option, or after a diagnostic."""
    if option is None:
        return None
    value = ctx.elaborate(ctx, scope, option.value, True)
    if named is not None and isinstance(value, Scalar):
        fits = require_dimension(
            ctx, scope, option.value, value.dimension, dimension, "E0415", what=what, expected=named
        )
        if not fits:
            return None
    found = conform(ctx, scope, option.value, value, Expected(what, dimension, (), code="E0415"))
    if not isinstance(found, Scalar):
        return None
    if rank(found.variability) > rank(latest):
        allowed = "parameters and constants" if latest == Variability.PARAMETER else "what is known at an event"
        ctx.sink.report("E0317", option.value.span, what=what, allowed=allowed)
        return None
    known = rank(found.variability) <= rank(Variability.PARAMETER)
    if known and not require(ctx, scope, option.value, what, found, most=most, strict=strict):
        return None
    return found
