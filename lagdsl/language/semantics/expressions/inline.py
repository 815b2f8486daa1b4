"""Functions of the user: one expression each, expanded where they are called."""

from __future__ import annotations

from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.arithmetic import Operand
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.limits import another_call
from lagdsl.language.semantics.scope.naming import arguments_text, kind_of, name_span
from lagdsl.language.semantics.scope.scope import Entry, FunctionSymbol, Scope, TypeInfo
from lagdsl.language.semantics.scope.values import POISON, Array, Poison, Scalar, Text, Value, Vector
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.types.types import resolve_type
from lagdsl.language.syntax import nodes


def inlined(ctx: Context, scope: Scope, node: nodes.Call, symbol: FunctionSymbol, arguments: list[Operand]) -> Value:
    """The body of the function with the arguments in place of its parameters."""
    function = symbol.node
    if any(active is function for active in ctx.current.functions):
        if not any(f"{active.name}()" in ctx.reports.reported for active in ctx.current.functions):
            ctx.sink.report("E0314", node.span, name=function.name)
        ctx.reports.reported.update(f"{active.name}()" for active in ctx.current.functions)
        return POISON
    bound = _bind(ctx, symbol, node, arguments)
    if bound is None or not another_call(ctx, node.span):
        return POISON
    ctx.current.functions.append(function)
    try:
        value = ctx.elaborate(ctx, symbol.scope.of_function(bound), function.value, True)
    finally:
        ctx.current.functions.pop()
    return _result(ctx, symbol, bound, value)


def _bind(ctx: Context, symbol: FunctionSymbol, node: nodes.Call, arguments: list[Operand]) -> dict[str, Entry] | None:
    """Each parameter with its argument or default; None after a diagnostic."""
    function = symbol.node
    given: dict[str, Operand] = {}
    names = [parameter.name for parameter in function.parameters]
    for position, (argument, operand) in enumerate(zip(node.arguments, arguments, strict=True)):
        if isinstance(argument, nodes.Named) and argument.name not in names:
            hint = did_you_mean(argument.name, names)
            ctx.sink.report("E0211", name_span(argument), name=argument.name, function=function.name, help=hint)
            return None
        if position < len(names) or isinstance(argument, nodes.Named):
            given[argument.name if isinstance(argument, nodes.Named) else names[position]] = operand
    needed = sum(parameter.default is None for parameter in function.parameters)
    missing = any(p.default is None and p.name not in given for p in function.parameters)
    if missing or len(arguments) > len(names) or len(given) < len(arguments):
        expected = str(needed) if needed == len(names) else f"{needed} to {len(names)}"
        ctx.sink.report(
            "E0315", node.span, function=function.name, expected=arguments_text(expected), found=len(arguments)
        )
        return None
    bound: dict[str, Entry] = {}
    for parameter in function.parameters:
        value = _argument(ctx, symbol, parameter, given.get(parameter.name), bound)
        bound[parameter.name] = value
    return None if any(isinstance(value, Poison) for value in bound.values()) else bound


def _argument(
    ctx: Context,
    symbol: FunctionSymbol,
    parameter: nodes.FunctionParameter,
    operand: Operand | None,
    bound: dict[str, Entry],
) -> Value:
    scope = symbol.scope.of_function(dict(bound))
    if operand is None:
        assert parameter.default is not None
        operand = Operand(parameter.default, ctx.elaborate(ctx, scope, parameter.default, True))
    info = resolve_type(ctx, parameter.type_name, symbol.scope)
    if info is None:
        return POISON
    if info.base == "String":
        if not isinstance(operand.value, Text | Poison):
            what, found = f"argument `{parameter.name}`", kind_of(operand.value)
            ctx.sink.report("E0334", operand.node.span, what=what, expected="a String", found=found)
        return operand.value if isinstance(operand.value, Text) else POISON
    shape = _shape(ctx, scope, parameter.subscripts, info, operand.value)
    if shape is None:
        return POISON
    expected = Expected(f"argument `{parameter.name}`", info.dimension or DIMENSIONLESS, shape, info.base, info.unit)
    return conform(ctx, scope, operand.node, operand.value, expected) or POISON


def _shape(
    ctx: Context, scope: Scope, subscripts: tuple[nodes.Subscript, ...], info: TypeInfo, value: Value
) -> tuple[int, ...] | None:
    """The declared shape; `:` takes the size of the argument."""
    found = value.shape if isinstance(value, Array) else (3,) if isinstance(value, Vector) else ()
    shape: list[int] = []
    declared = [(subscript, scope) for subscript in subscripts]
    for position, part in enumerate([*declared, *info.shape]):
        if isinstance(part, int):
            shape.append(part)
            continue
        subscript, where = part
        if isinstance(subscript, nodes.All):
            shape.append(found[position] if position < len(found) else 0)
            continue
        if isinstance(subscript, nodes.Range):
            ctx.sink.report("E0312", subscript.span, expected="an array size", found="a range")
            return None
        number = structural_integer(
            ctx, ctx.elaborate(ctx, where, subscript, False), subscript, "E0301", name=subscript.span.text
        )
        if number is None:
            return None
        shape.append(number)
    return tuple(shape)


def _result(ctx: Context, symbol: FunctionSymbol, bound: dict[str, Entry], value: Value) -> Value:
    function = symbol.node
    if function.result is None or isinstance(value, Poison):
        return value
    info = resolve_type(ctx, function.result, symbol.scope)
    if info is None:
        return POISON
    shape = _shape(ctx, symbol.scope.of_function(bound), function.result_subscripts, info, value)
    if shape is None:
        return POISON
    expected = Expected(
        f"the result of `{function.name}`", info.dimension or DIMENSIONLESS, shape, info.base, info.unit
    )
    return conform(ctx, symbol.scope, function.value, value, expected) or POISON


def check_function(ctx: Context, symbol: FunctionSymbol) -> None:
    """Check the body once with symbols of the declared types, whether the function is called or not."""
    bound: dict[str, Entry] = {}
    for parameter in symbol.node.parameters:
        info = resolve_type(ctx, parameter.type_name, symbol.scope)
        subscripts = [*parameter.subscripts, *(info.shape if info is not None else ())]
        bound[parameter.name] = POISON
        if info is not None and info.base == "Real" and not subscripts:
            dimension = info.dimension or DIMENSIONLESS
            bound[parameter.name] = Scalar(flat.Variable(parameter.name), dimension, Variability.CONTINUOUS)
    with ctx.current.without_relations():
        ctx.current.functions.append(symbol.node)
        value = ctx.elaborate(ctx, symbol.scope.of_function(bound), symbol.node.value, True)
        ctx.current.functions.pop()
    _result(ctx, symbol, bound, value)
