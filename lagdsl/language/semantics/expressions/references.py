"""Names in expressions: plain, with subscripts, with members."""

from __future__ import annotations

import re
from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog.habits import name_help, rate_of
from lagdsl.foundation.diagnostics.catalog.modelica import class_help
from lagdsl.foundation.diagnostics.suggest import Proposal, did_you_mean, nearest, proposal
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.written import literal_around, literal_of, literal_with
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.expressions import slices
from lagdsl.language.semantics.operators import arrays, geometry
from lagdsl.language.semantics.operators.builtin import BUILTINS
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.imports import import_hint
from lagdsl.language.semantics.scope.naming import an, kind_of
from lagdsl.language.semantics.scope.scope import (
    ClassSymbol,
    Entry,
    FunctionSymbol,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    TypeSymbol,
    is_guess,
    lookup,
    visible,
)
from lagdsl.language.semantics.scope.values import (
    POISON,
    AnyValue,
    Array,
    Component,
    Order,
    Poison,
    Scalar,
    Value,
    Vector,
    components,
)
from lagdsl.language.semantics.types import enumerations
from lagdsl.language.syntax import nodes


def reference(ctx: Context, scope: Scope, node: nodes.Reference) -> Value:
    """The value of a plain name."""
    entry = lookup(scope, node.name, node.span)
    if entry is None:
        found = _prelude(ctx, node.name)
        if found is None:
            report_unknown(ctx, scope, node)
        return found or POISON
    return _value(ctx, entry, node)


def _value(ctx: Context, entry: Entry, node: nodes.Expression) -> Value:
    match entry:
        case Symbol():
            entry.made.used = True
            return ctx.resolver.whole(ctx, entry, node.span)
        case FunctionSymbol():
            ctx.sink.report("E0219", node.span, name=node.span.text, what="a function", help="call it: `f(...)`")
            return POISON
        case TypeSymbol():
            ctx.sink.report("E0219", node.span, name=node.span.text, what="a type")
            return POISON
        case ClassSymbol():
            ctx.sink.report("E0219", node.span, name=node.span.text, what="a class")
            return POISON
        case Instance() if not entry.present:
            label = Label(entry.span, "declared here")
            ctx.sink.report("E0230", node.span, label, name=entry.name)
            return POISON
        case Instance() | InstanceArray():
            return Component(entry)
        case AnyValue():
            return entry
        case _:
            assert_never(entry)


def _prelude(ctx: Context, name: str) -> Value | None:
    if name == "time":
        return Scalar(flat.TIME, ctx.conventions.dimension(TIME), Variability.CONTINUOUS, Order.STILL)
    if name == "world":
        return geometry.WORLD
    constant = prelude.CONSTANTS.get(name)
    if constant is None:
        return None
    dimension = None if name == "inf" else ctx.conventions.dimension(constant.dimension)
    return Scalar(flat.Number(constant.value), dimension)


def report_unknown(ctx: Context, scope: Scope, node: nodes.Reference) -> None:
    """E0201, once for each name, with the nearest declared one."""
    key = f"{scope.title}.{node.name}"
    if key in ctx.reports.reported or ctx.reports.incomplete or is_guess(scope):
        ctx.reports.withheld = node.span
        return
    ctx.reports.reported.add(key)
    absent = ctx.reports.absent.get(scope.owner.qualify(node.name))
    if absent is not None:
        ctx.sink.report("E0230", node.span, Label(absent, "declared here"), name=node.name)
        return
    if node.name in BUILTINS or node.name == "der":
        ctx.sink.report("E0219", node.span, name=node.name, what="a function", help=f"call it: `{node.name}(...)`")
        return
    outside = next((found for step in scope.chain() if isinstance(found := step.entries.get(node.name), Symbol)), None)
    if outside is not None:
        outside.made.used = True
        label = Label(outside.span, f"{an(outside.word)}, declared here")
        function = scope.owner.text is None
        way = f"a function knows its arguments and constants only: give it `{node.name}` as an argument"
        if not function:
            way = f"a class inside another sees its constants only: give `{node.name}` by a modifier"
        title = "the function" if function else scope.title
        ctx.sink.report("E0201", node.span, label, name=node.name, scope=title, help=way)
        return
    if len(ctx.reports.reported) > _SEARCHED:
        ctx.sink.report("E0201", node.span, name=node.name, scope=scope.title)
        return
    names = dict(visible(scope))
    rate = next(((quantity, text) for quantity, text in rate_of(node.name) if quantity in names), None)
    if rate is not None and isinstance(found := names[rate[0]], Symbol):
        found.made.used = True
        label = Label(found.span, f"{an(found.word)}, declared here")
        way = Proposal(f"write `{rate[1]}`", node.name, rate[1])
        ctx.sink.report("E0201", node.span, label, name=node.name, scope=scope.title, help=way)
        return
    habit = _habit(node)
    if habit is not None:
        ctx.sink.report("E0201", node.span, name=node.name, scope=scope.title, help=habit)
        return
    meant = nearest(node.name, [*names, *prelude.CONSTANTS, "time", "world"])
    entry = names.get(meant) if meant is not None else None
    labels: tuple[Label, ...] = ()
    if isinstance(entry, Symbol):
        entry.made.used = True
        labels = (Label(entry.span, f"{an(entry.word)} with a similar name is declared here"),)
    hint = proposal(node.name, meant) if meant is not None else import_hint(scope, node.name)
    if hint is None and node.name in prelude.TYPES:
        hint = f"`{node.name}` is a type; a value needs a name of its own"
    ctx.sink.report("E0201", node.span, *labels, name=node.name, scope=scope.title, help=hint)


def _habit(node: nodes.Reference) -> str | None:
    """Help: the text to write for a unit in a product, for a name of another language."""
    text, span = node.span.file.text, node.span
    literal = literal_around(text, span.start, span.end)
    if literal is not None:
        return f"a unit stands behind its number: `{literal}`"
    literal = literal_with(text, span.start, span.end)
    if literal is not None:
        return f"the unit is one word: `{literal}`"
    behind = _PATH.match(text, span.end)
    assert behind is not None
    if node.name == "Modelica" and behind[0]:
        return class_help(node.name + behind[0]) or f"functions and constants have no package: write `{behind[1]}`"
    return name_help(node.name, behind[0])


# Behind so many faults no names are compared: a text of unknown names must not cost the square of its length.
_SEARCHED = 50
_PATH = re.compile(r"(?:\.([A-Za-z_][A-Za-z0-9_]*))*")


def member(ctx: Context, scope: Scope, node: nodes.Member) -> Value:
    several = slices.of_several(ctx, scope, node, _value)
    if several is not None:
        return several
    entry = designated(ctx, scope, node)
    if entry is not None:
        return _value(ctx, entry, node)
    if not_in_package(ctx, scope, node):
        return POISON
    kind = designated(ctx, scope, node.target)
    if isinstance(kind, TypeSymbol):
        return enumerations.literal(ctx, kind, node)
    return geometry.member(ctx, node, ctx.elaborate(ctx, scope, node.target, False))


def package_entry(scope: Scope, node: nodes.Expression) -> Entry | None:
    """The entry that `Package.name` means, if the text is one."""
    if isinstance(node, nodes.Reference):
        return lookup(scope, node.name, node.span)
    if not isinstance(node, nodes.Member):
        return None
    around = package_entry(scope, node.target)
    if isinstance(around, ClassSymbol) and around.inner is not None:
        return around.inner.find(node.name, node.span)
    return None


def not_in_package(ctx: Context, scope: Scope, node: nodes.Member) -> bool:
    """E0210 for a name that a package does not hold."""
    around = package_entry(scope, node.target)
    if not isinstance(around, ClassSymbol) or around.inner is None:
        return False
    what = f"package `{node.target.span.text}`"
    hint = did_you_mean(node.name, around.inner.names())
    ctx.sink.report("E0210", node.name_span, name=node.name, what=what, help=hint)
    return True


def index(ctx: Context, scope: Scope, node: nodes.Index) -> Value:
    """`a[i]`, `a[2:3]`, `P[k]`: one element of a declared array is read without its neighbours."""
    split = ctx.splits.values.get((scope, id(node.target)))
    if split is not None:
        return _indexed(ctx, scope, node, split)
    entry = designated(ctx, scope, node)
    if entry is not None:
        return _value(ctx, entry, node)
    symbol = designated(ctx, scope, node.target)
    if isinstance(symbol, Poison):
        return POISON
    if isinstance(symbol, Symbol):
        symbol.made.used = True
        shape = ctx.resolver.shape(ctx, symbol)
        if shape is None:
            return POISON
        if shape:
            return _element(ctx, scope, node, symbol, shape)
    return _indexed(ctx, scope, node, ctx.elaborate(ctx, scope, node.target, False))


def _element(ctx: Context, scope: Scope, node: nodes.Index, symbol: Symbol, shape: tuple[int, ...]) -> Value:
    given, rest = node.subscripts[: len(shape)], node.subscripts[len(shape) :]
    found = arrays.subscript_indices(ctx, scope, given, shape, node)
    if found is None:
        return POISON
    indices = tuple(item for item in found if isinstance(item, int))
    if len(indices) < len(shape):
        return ctx.resolver.part(ctx, symbol, found, node.span)
    value = ctx.resolver.element(ctx, symbol, indices, node.span)
    if not rest:
        return value
    if isinstance(value, Scalar):
        ctx.sink.report("E0341", node.span, index=len(node.subscripts), extent=len(shape))
        return POISON
    inner = nodes.Index(span=node.span, target=node.target, subscripts=rest)
    return _indexed(ctx, scope, inner, value)


def _no_slice(ctx: Context, node: nodes.Index, value: Value) -> Value:
    if not isinstance(value, Poison):
        ctx.sink.report("E0312", node.span, expected="an array", found=kind_of(value), help=_one_value(node, value))
    return POISON


def _one_value(node: nodes.Index, value: Value) -> str | None:
    """Help for subscripts of what has one value; `1 [kg]` is a number with its unit."""
    if not isinstance(value, Scalar):
        return None
    text = node.target.span.text
    unit = literal_of(f"{text}*{node.span.text[len(text) :].strip(' []')}")
    return (
        f"a unit stands behind its number without brackets: `{unit}`" if unit else f"it has one value: write `{text}`"
    )


def _indexed(ctx: Context, scope: Scope, node: nodes.Index, value: Value) -> Value:
    """Subscripts of a value; for a geometric vector they choose world components."""
    if isinstance(value, Poison):
        return POISON
    array = components(value) if isinstance(value, Vector) else value
    if not isinstance(array, Array):
        return _no_slice(ctx, node, value)
    found = arrays.subscript_indices(ctx, scope, node.subscripts, array.shape, node)
    return POISON if found is None else arrays.select(array, found)
