"""The body of one function as Python text: straight-line code on plain numbers or on arrays, whatever it is given."""

from __future__ import annotations

import math

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, ELEMENTARY_NAMES, Op
from lagdsl.derivation.program.passes.schedule import schedule
from lagdsl.derivation.program.program import Function, Program
from lagdsl.engines.backends.expression import ExpressionPrinter

# Names in the table of elementary functions that a body is given as its first argument.
ELEMENTARY: dict[Op, str] = {
    **ELEMENTARY_NAMES,
    Op.ABS: "absolute",
    Op.SIGN: "sign",
    Op.NOT: "negation",
    Op.DIVIDE: "divide",
    Op.POWER: "power",
    Op.MOD: "modulo",
    Op.MIN: "minimum",
    Op.MAX: "maximum",
    Op.LESS: "less",
    Op.LESS_EQUAL: "less_equal",
    Op.EQUAL: "equal",
    Op.AND: "both",
    Op.OR: "either",
    Op.SELECT: "select",
}

_RESULTS_PER_LINE = 8


def body_name(function: str) -> str:
    return f"_{function}"


def body(program: Program, function: Function) -> str:
    """`def _name(F, t, q, ...)` that returns the elements of all results in one flat tuple; numbers, arrays and symbols
    of other packages pass, so the types are `Any`, of `typing`."""
    graph = program.graph
    roots = [node for block in function.results for node in block.elements]
    plan = schedule(graph, roots)
    variable = {node: f"v{index}" for index, node in enumerate(plan.named)}

    def leaf(node: int) -> str | None:
        if graph.op[node] is Op.CONSTANT:
            return number(graph.value[node])
        if graph.op[node] is Op.SYMBOL:
            array = ARGUMENT_NAMES[graph.group(node)]
            return array if array == "t" else f"{array}[{graph.b[node]}]"
        return variable.get(node)

    printer = ExpressionPrinter(graph, leaf, ELEMENTARY, divide="divide")
    statements = [f"{variable[node]} = {printer.definition(node)}" for node in plan.named]
    used = sorted({graph.op[node] for node in graph.live(roots)} & ELEMENTARY.keys())
    table = [f"{ELEMENTARY[op]} = F.{ELEMENTARY[op]}" for op in used]
    arguments = ", ".join(f"{name}: Any" for name in ("F", *(ARGUMENT_NAMES[group] for group in function.arguments)))
    head = f"def {body_name(function.name)}({arguments}) -> tuple[Any, ...]:"
    lines = [head, *(f"    {line}" for line in (*table, *statements))]
    return "\n".join([*lines, *_returned([printer.text(root) for root in roots])]) + "\n"


def number(value: float) -> str:
    """A Python literal; `inf` is a name of the module."""
    text = repr(value) if math.isfinite(value) else ("inf" if value > 0 else "-inf")
    return f"({text})" if text.startswith("-") else text


def _returned(values: list[str]) -> list[str]:
    if not values:
        return ["    return ()"]
    rows = [values[start : start + _RESULTS_PER_LINE] for start in range(0, len(values), _RESULTS_PER_LINE)]
    return ["    return (", *(f"        {', '.join(row)}," for row in rows), "    )"]
