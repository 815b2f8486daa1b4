"""Attributes in modifiers: which ones fit what, and their values."""

from __future__ import annotations

from dataclasses import replace
from math import prod

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog.modelica import class_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.record import record
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import each_help, without_each
from lagdsl.language.semantics.scope.prelude import BaseType
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.values import AnyDimension, Scalar, Text, is_structural, rank
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.types.prefixes import check_modifier
from lagdsl.language.syntax import nodes

_SHOWN = ("unit", "displayUnit", "symbol")
_BOUNDS = ("min", "max")
ALLOWED: dict[str, tuple[str, ...]] = {
    "constant": (*_BOUNDS, *_SHOWN),
    "structural": (*_BOUNDS, *_SHOWN),
    "parameter": ("start", "fixed", *_BOUNDS, "nominal", *_SHOWN),
    "input": ("start", "smooth", *_BOUNDS, "nominal", *_SHOWN),
    "output": (*_BOUNDS, "nominal", *_SHOWN),
    "algebraic": _SHOWN,
    "state": ("start", "fixed", *_BOUNDS, "nominal", *_SHOWN),
    "discrete": ("start", "fixed", *_BOUNDS, *_SHOWN),
    "coordinate": ("start", "fixed", *_BOUNDS, "nominal", *_SHOWN, "der.start", "der.fixed", "prefer"),
    "point": (),
    "frame": (),
}
QUATERNION = ("start", "fixed", "symbol", "der.start", "der.fixed", "omega.start", "omega.fixed", "prefer")
# Attributes of Modelica that exist but may not fit the thing they stand at.
KNOWN = ("start", "fixed", "min", "max", "nominal", "unit", "displayUnit", "symbol", "smooth", "der", "omega")
LATER = {"stateSelect": "joints whose coordinates are the unknowns are chosen by `prefer = always` or `prefer = never`"}


@record()
class Attribute:
    node: nodes.Modifier
    scope: Scope
    value: nodes.Expression

    @property
    def each(self) -> bool:
        return "each" in self.node.prefixes


def attributes(ctx: Context, symbol: Symbol) -> dict[str, Attribute]:
    """The attributes of a declared quantity by name (`der.start` for a nested one); what does not fit is reported."""
    found: dict[str, Attribute] = {}
    if symbol.kind == "unknown":
        return found
    if symbol.info is not None:
        for modifier, scope in symbol.info.modifiers:
            _read(ctx, symbol, modifier, scope, "", found, inherited=True)
    own: dict[str, Attribute] = {}
    for modifier in symbol.declarator.modifiers if symbol.declarator is not None else ():
        check_modifier(ctx, modifier)
        _read(ctx, symbol, modifier, symbol.scope, "", own, inherited=False)
    merged = {**found, **own}
    for modifiers, scope in symbol.given.overrides:
        outer: dict[str, Attribute] = {}
        for modifier in modifiers:
            _read(ctx, symbol, modifier, scope, "", outer, inherited=False)
        for name, attribute in outer.items():
            if name in merged and "final" in merged[name].node.prefixes:
                label = Label(merged[name].node.span, "given as `final` here")
                ctx.sink.report("E0224", attribute.node.span, label, name=f"{symbol.short}.{name}")
            else:
                merged[name] = attribute
    return merged


def _read(
    ctx: Context,
    symbol: Symbol,
    modifier: nodes.AnyModifier,
    scope: Scope,
    prefix: str,
    found: dict[str, Attribute],
    *,
    inherited: bool,
) -> None:
    if not isinstance(modifier, nodes.Modifier):
        ctx.sink.report("E0240", modifier.span, what="a quantity")
        return
    name = prefix + ".".join(modifier.name.parts)
    if not prefix and name in ("der", "omega") and modifier.modifiers and _fits(symbol, f"{name}.start"):
        for nested in modifier.modifiers:
            if isinstance(nested, nodes.Modifier) and "each" in modifier.prefixes and "each" not in nested.prefixes:
                nested = replace(nested, prefixes=("each", *nested.prefixes))  # noqa: PLW2901 `each` is for all inside
            _read(ctx, symbol, nested, scope, f"{name}.", found, inherited=inherited)
        return
    if not _fits(symbol, name):
        if not (inherited and name in KNOWN):
            _report_misfit(ctx, symbol, modifier, prefix)
    elif modifier.modifiers or modifier.subscripts or modifier.value is None:
        ctx.sink.report("E0220", modifier.span, name=name)
    elif name in found:
        ctx.sink.report("E0212", modifier.span, name=name)
    else:
        found[name] = Attribute(modifier, scope, modifier.value)


def _fits(symbol: Symbol, name: str) -> bool:
    quaternion = symbol.kind == "coordinate" and symbol.info is not None and symbol.info.quaternion
    return name in (QUATERNION if quaternion else ALLOWED.get(symbol.kind, ()))


def _report_misfit(ctx: Context, symbol: Symbol, modifier: nodes.Modifier, prefix: str) -> None:
    name = ".".join(modifier.name.parts)
    span = modifier.name.span
    quaternion = symbol.kind == "coordinate" and symbol.info is not None and symbol.info.quaternion
    allowed = QUATERNION if quaternion else ALLOWED.get(symbol.kind, ())
    if prefix:
        names = [each.removeprefix(prefix) for each in allowed if each.startswith(prefix)]
    else:
        names = list(dict.fromkeys(each.partition(".")[0] for each in allowed))
    if name in LATER:
        ctx.sink.report("E0311", span, what=f"`{name}`", hint=LATER[name])
    elif name in KNOWN and not prefix:
        ctx.sink.report("E0213", span, *_declared(symbol, modifier), name=name, what=symbol.title)
    else:
        type_name = symbol.info.name if symbol.info is not None else symbol.kind
        hint = did_you_mean(name, names) or class_help(type_name)
        listed = ", ".join(names) if names else "none"
        place = _declared(symbol, modifier)
        ctx.sink.report("E0202", span, *place, name=name, type=type_name, attributes=listed, help=hint)


def _declared(symbol: Symbol, modifier: nodes.Modifier) -> tuple[Label, ...]:
    """Label at the declaration of the quantity, for a modifier elsewhere."""
    if symbol.declarator is None or modifier in symbol.declarator.modifiers:
        return ()
    return (Label(symbol.span, f"`{symbol.short}` is declared here as {symbol.title}"),)


# ---- values of attributes --------------------------------------------------------------------------------------------


def expressions(
    ctx: Context,
    attribute: Attribute,
    what: str,
    dimension: AnyDimension,
    shape: tuple[int, ...],
    *,
    unit: str = "1",
    base: BaseType = "Real",
) -> list[FlatExpression] | None:
    """One expression for each element, of parameters at most; None after a diagnostic."""
    value = ctx.elaborate(ctx, attribute.scope, attribute.value, True)
    wanted = () if attribute.each else shape
    _check_each(ctx, attribute, what, shape)
    if shape and not attribute.each and isinstance(value, Scalar):
        text = attribute.node.span.text
        ctx.sink.report("E0335", attribute.node.span, text=text, help=each_help(text))
        return None
    expected = Expected(what, dimension, wanted, base, unit, "E0415")
    found = conform(ctx, attribute.scope, attribute.value, value, expected)
    if found is None:
        return None
    if rank(found.variability) > rank(Variability.PARAMETER):
        ctx.sink.report("E0317", attribute.value.span, what=what, allowed="parameters and constants")
        return None
    return [found.expression] * prod(shape) if isinstance(found, Scalar) else list(found.elements)


def numbers(
    ctx: Context,
    attribute: Attribute | None,
    what: str,
    dimension: AnyDimension,
    shape: tuple[int, ...],
    base: BaseType = "Real",
    unit: str = "1",
) -> list[float | None]:
    """One number for each element, known while compiling; None where there is none."""
    count = prod(shape)
    if attribute is None:
        return [None] * count
    # A bound or nominal value is most often one number for the whole array.
    _check_each(ctx, attribute, what, shape)
    value = ctx.elaborate(ctx, attribute.scope, attribute.value, base == "Real")
    wanted = () if attribute.each or isinstance(value, Scalar) else shape
    expected = Expected(what, dimension, wanted, base, unit, "E0415")
    found = conform(ctx, attribute.scope, attribute.value, value, expected)
    if found is None:
        return [None] * count
    if not is_structural(found):
        ctx.sink.report("E0317", attribute.value.span, what=what, allowed="constants and structural parameters")
        return [None] * count
    parts = [found.expression] * count if isinstance(found, Scalar) else list(found.elements)
    try:
        return [evaluate(part) for part in parts]
    except NoValue as fault:
        ctx.sink.report("E0323", attribute.value.span, reason=str(fault))
        return [None] * count


def flags(ctx: Context, attribute: Attribute | None, what: str, shape: tuple[int, ...]) -> list[bool]:
    """`fixed` for each element: known while compiling."""
    return [bool(number) for number in numbers(ctx, attribute, what, None, shape, "Boolean")]


def _check_each(ctx: Context, attribute: Attribute, what: str, shape: tuple[int, ...]) -> None:
    if attribute.each and not shape:
        ctx.sink.report("E0344", attribute.node.span, edit=without_each(attribute.node.span), what=what)


def text(ctx: Context, attribute: Attribute | None) -> str | None:
    """`symbol`: a text."""
    if attribute is None:
        return None
    value = ctx.elaborate(ctx, attribute.scope, attribute.value, False)
    if isinstance(value, Text):
        return value.value
    ctx.sink.report("E0312", attribute.value.span, expected="a text in quotes", found="something else")
    return None


def sign_of(ctx: Context, symbol: Symbol) -> str | None:
    """The `symbol` attribute of a declared quantity."""
    return text(ctx, attributes(ctx, symbol).get("symbol"))
