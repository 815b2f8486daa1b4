"""Types of declared quantities: prelude types, types of the file, `unit` and `displayUnit` attributes."""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog.habits import quantity_help, word_help
from lagdsl.foundation.diagnostics.catalog.modelica import class_help, import_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean, nearest, proposal
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.naming import describe, unit_text
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.imports import import_hint
from lagdsl.language.semantics.scope.naming import an
from lagdsl.language.semantics.scope.scope import (
    ClassSymbol,
    FunctionSymbol,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    TypeInfo,
    TypeSymbol,
    is_guess,
    lookup_path,
    reachable,
    visible,
)
from lagdsl.language.semantics.scope.values import AnyValue, Poison
from lagdsl.language.semantics.types import enumerations
from lagdsl.language.syntax import nodes

STATEMENTS = (
    "kinetic",
    "potential",
    "lagrangian",
    "dissipation",
    "force",
    "torque",
    "mass",
    "body",
    "gravity",
    "constraint",
    "invariant",
    "coordinate",
    "parameter",
    "constant",
    "input",
    "output",
    "state",
    "point",
    "frame",
    "draw",
)


def resolve_type(ctx: Context, name: nodes.Name, scope: Scope, depth: int = 0) -> TypeInfo | None:
    """The type that `name` means, or None after a diagnostic."""
    entry = lookup_path(scope, name.parts, name.span)
    text = ".".join(name.parts)
    match entry:
        case TypeSymbol() if depth < 50:
            return _defined(ctx, entry, depth)
        case TypeSymbol():
            ctx.sink.report("E0305", name.span, path=f"type `{text}` is defined by itself")
        case ClassSymbol() if entry.inner is None:
            ctx.sink.report("E0233", name.span, name=text)
        case None if text in prelude.TYPES:
            return _prelude(ctx, prelude.TYPES[text])
        case Poison():
            pass
        case Symbol() | Instance() | InstanceArray() | FunctionSymbol() | ClassSymbol() | AnyValue() | None:
            report_unknown_type(ctx, name, scope)
        case _:
            assert_never(entry)
    return None


def _prelude(ctx: Context, row: prelude.PreludeType) -> TypeInfo:
    plain = row.base == "Real" and row.unit == "1" and row.name == "Real"
    dimension = None if plain else ctx.conventions.dimension(row.dimension)
    unit = row.unit if ctx.conventions.units else "1"
    display = row.display_unit if ctx.conventions.units else None
    return TypeInfo(
        row.name,
        row.base,
        dimension,
        unit,
        display,
        row.minimum,
        row.shape,
        quaternion=row.name == "Quaternion",
        is_difference=row.name == "TemperatureDifference",
    )


def _defined(ctx: Context, entry: TypeSymbol, depth: int) -> TypeInfo | None:
    definition = entry.node
    if isinstance(definition, nodes.ShortClass):
        name = definition.span
        ctx.sink.report("E0311", name, what="a short class definition used as a type", hint="use `type X = ...;`")
        return None
    if definition.base is None:
        return enumerations.type_of(ctx, entry)
    around = lookup_path(entry.scope, definition.base.parts, definition.base.span)
    if isinstance(around, ClassSymbol) and around.inner is None:
        rest = definition.span.text.partition("=")[2].strip()
        ctx.sink.report(
            "E0233",
            definition.base.span,
            name=".".join(definition.base.parts),
            help=f"write `model {definition.name} = {rest}`",
        )
        return None
    base = resolve_type(ctx, definition.base, entry.scope, depth + 1)
    if base is None:
        return None
    shape = (*((subscript, entry.scope) for subscript in definition.subscripts), *base.shape)
    modifiers = (*base.modifiers, *((modifier, entry.scope) for modifier in definition.modifiers))
    doc = base.doc if definition.doc is None else definition.doc
    named = replace(base, name=definition.name, shape=shape, modifiers=modifiers, quaternion=False, doc=doc)
    return with_unit(ctx, named, definition.modifiers)


def with_unit(ctx: Context, base: TypeInfo, modifiers: tuple[nodes.AnyModifier, ...]) -> TypeInfo:
    """The type with the `unit` and `displayUnit` among `modifiers` applied."""
    for modifier in modifiers:
        if isinstance(modifier, nodes.Modifier) and modifier.name.parts in (("unit",), ("displayUnit",)):
            if isinstance(modifier.value, nodes.String):
                change = _unit if modifier.name.parts == ("unit",) else _display
                base = change(ctx, base, modifier.value.value, modifier.value.span)
            elif modifier.value is not None:
                found = f"`{modifier.value.span.text}`"
                ctx.sink.report("E0312", modifier.value.span, expected='a unit in quotes such as "m/s"', found=found)
    return base


def _unit(ctx: Context, base: TypeInfo, text: str, span: Span) -> TypeInfo:
    if not ctx.conventions.units:
        ctx.sink.report("E0409", span)
        return base
    try:
        unit = parse_unit(text)
    except UnknownUnit as fault:
        _unknown_unit(ctx, fault, span)
        return base
    if unit.factor != 1.0 or unit.offset != 0.0:
        ctx.sink.report("E0406", span, unit=text, coherent=unit_text(unit.dimension))
    elif base.base != "Real":
        ctx.sink.report("E0312", span, expected="a Real with a unit", found=f"{an(base.base)}")
    elif base.dimension is not None and base.dimension != unit.dimension:
        ctx.sink.report("E0410", span, unit=text, type=base.name, words=describe(base.dimension), own=base.unit)
    else:
        display = base.display_unit if base.dimension is not None else None
        return replace(base, dimension=unit.dimension, unit=text, display_unit=display)
    return replace(base, dimension=base.dimension or unit.dimension)


def _display(ctx: Context, base: TypeInfo, text: str, span: Span) -> TypeInfo:
    try:
        unit = parse_unit(text)
    except UnknownUnit as fault:
        _unknown_unit(ctx, fault, span)
        return base
    if unit.shift and base.is_difference:
        label = Label(span, "a scale with a zero of its own")
        words = "a difference of temperatures"
        ctx.sink.report("E0410", label, unit=text, type=base.name, words=words, own=base.unit, help='write "K"')
        return base
    if ctx.conventions.units and unit.dimension != (base.dimension or DIMENSIONLESS):
        words = describe(base.dimension or DIMENSIONLESS)
        ctx.sink.report("E0410", span, unit=text, type=base.name, words=words, own=base.unit)
        return base
    return replace(base, display_unit=text)


def _unknown_unit(ctx: Context, fault: UnknownUnit, span: Span) -> None:
    meant = f"did you mean `{fault.suggestion}`?" if fault.suggestion else None
    ctx.sink.report("E0413", span, unit=fault.text, help=meant)


def report_unknown_type(ctx: Context, name: nodes.Name, scope: Scope) -> None:
    text = ".".join(name.parts)
    if ctx.reports.incomplete or is_guess(scope):
        return
    if name.parts[0] in ("Modelica", "SI"):
        ctx.sink.report("E0208", name.span, name=text, help=class_help(text) or import_help(text))
        return
    if len(name.parts) > 1 and _not_in_package(ctx, name, scope):
        return
    types = [found for found, entry in visible(scope) if isinstance(entry, TypeSymbol | ClassSymbol)]
    meant = nearest(text, [*types, *reachable(scope), *prelude.TYPES, *STATEMENTS])
    near = proposal(text, meant) if meant else import_hint(scope, name.parts[0])
    if meant in STATEMENTS:
        near = f"did you mean the statement `{meant}`?"
    hint = word_help(text) or quantity_help(text) or class_help(text) or near
    ctx.sink.report("E0208", name.span, name=text, help=hint)


def _not_in_package(ctx: Context, name: nodes.Name, scope: Scope) -> bool:
    """E0210 where the name begins with a package that does not hold what follows."""
    for length in range(len(name.parts) - 1, 0, -1):
        around = lookup_path(scope, name.parts[:length], name.span)
        if isinstance(around, ClassSymbol) and around.inner is not None:
            part = name.parts[length]
            hint = did_you_mean(part, around.inner.names())
            what = f"package `{'.'.join(name.parts[:length])}`"
            ctx.sink.report("E0210", name.span, name=part, what=what, help=hint)
            return True
    return False
