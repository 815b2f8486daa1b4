"""Calls: built-in functions, methods of frames, functions of the user."""

from __future__ import annotations

from lagdsl.foundation.diagnostics.catalog.habits import function_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.language.semantics.events.event_functions import OF_EVENTS
from lagdsl.language.semantics.expressions.inline import inlined
from lagdsl.language.semantics.expressions.mechanics_functions import SPECIALS
from lagdsl.language.semantics.expressions.references import not_in_package, package_entry
from lagdsl.language.semantics.operators import builtin, geometry
from lagdsl.language.semantics.operators.application import Application
from lagdsl.language.semantics.operators.arithmetic import Operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import name_span, quantity
from lagdsl.language.semantics.scope.scope import FunctionSymbol, Scope, Symbol, lookup, visible
from lagdsl.language.semantics.scope.values import POISON, Array, FrameValue, Poison, Scalar, Value, Vector
from lagdsl.language.syntax import nodes


def call(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """The value of a call."""
    entry = package_entry(scope, node.function)
    if isinstance(entry, FunctionSymbol):
        return inlined(ctx, scope, node, entry, _arguments(ctx, scope, node))
    if isinstance(node.function, nodes.Member):
        if not_in_package(ctx, scope, node.function):
            return POISON
        return _method(ctx, scope, node, node.function)
    if not isinstance(node.function, nodes.Reference):
        ctx.sink.report("E0209", node.function.span, name=node.function.span.text, help=None)
        return POISON
    name = node.function.name
    special = SPECIALS.get(name) or OF_EVENTS.get(name)
    if special is not None:
        return special(ctx, scope, node)
    if name in builtin.BUILTINS:
        return _builtin(ctx, scope, node, name)
    return _no_function(ctx, scope, node, node.function)


def is_of_language(name: str) -> bool:
    """True for a function that needs no declaration."""
    return name in SPECIALS or name in OF_EVENTS or name in builtin.BUILTINS


def _arguments(ctx: Context, scope: Scope, node: nodes.Call) -> list[Operand]:
    found = []
    for argument in node.arguments:
        expression = argument.value if isinstance(argument, nodes.Named) else argument
        found.append(Operand(expression, ctx.elaborate(ctx, scope, expression, False)))
    return found


def _no_names(ctx: Context, node: nodes.Call) -> bool:
    for argument in node.arguments:
        if isinstance(argument, nodes.Named):
            ctx.sink.report("E0211", name_span(argument), name=argument.name, function=node.function.span.text)
            return False
    return True


def _builtin(ctx: Context, scope: Scope, node: nodes.Call, name: str) -> Value:
    if not _no_names(ctx, node):
        return POISON
    arguments = []
    for item in _arguments(ctx, scope, node):
        arguments.append(Operand(item.node, geometry.operand(ctx, item.value, item.node.span)))
    return builtin.apply(Application(ctx, scope, name, node, tuple(arguments)))


def _method(ctx: Context, scope: Scope, node: nodes.Call, function: nodes.Member) -> Value:
    target = ctx.elaborate(ctx, scope, function.target, False)
    if isinstance(target, Poison):
        return POISON
    if not isinstance(target, FrameValue):
        texts = tuple(argument.span.text for argument in node.arguments)
        way = function_help(function.name, (function.target.span.text, *texts)) or "only frames have methods"
        ctx.sink.report("E0209", function.name_span, name=function.name, help=way)
        return POISON
    if not _no_names(ctx, node):
        return POISON
    values = [item.value for item in _arguments(ctx, scope, node)]
    return geometry.method(ctx, scope, node, function, target, values)


def _no_function(ctx: Context, scope: Scope, node: nodes.Call, function: nodes.Reference) -> Value:
    """`l(1 - cos(x))` where `l` is a variable; a misspelt function."""
    name = function.name
    entry = lookup(scope, name)
    if isinstance(entry, Symbol | Scalar | Vector | Array):
        if isinstance(entry, Symbol):
            entry.made.used = True
        inside = node.span.text[len(name) :].strip()
        way = f"quantities depend on time by themselves: write `{name}`" if inside in ("(t)", "(time)") else None
        ctx.sink.report("E0327", function.span, name=name, what=_what(entry), arguments=inside, help=way)
    elif not ctx.reports.incomplete:
        functions = [found for found, each in visible(scope) if isinstance(each, FunctionSymbol)]
        texts = tuple(argument.span.text for argument in node.arguments)
        hint = function_help(name, texts) or did_you_mean(name, [*builtin.BUILTINS, *functions, *SPECIALS, *OF_EVENTS])
        ctx.sink.report("E0209", function.span, name=name, help=hint)
    return POISON


def _what(entry: Symbol | Scalar | Vector | Array) -> str:
    if isinstance(entry, Symbol):
        if entry.info is not None and entry.info.dimension is not None and not entry.info.dimension.is_dimensionless:
            return quantity(entry.info.dimension).partition(" [")[0]
        return entry.title.partition(" ")[2] or entry.title
    return "a number" if isinstance(entry, Scalar) else "an array"
