"""One function of a program as C: straight-line code, in one piece or several."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from lagdsl.backends.c.literal import number
from lagdsl.backends.expression import ExpressionPrinter
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import ARGUMENT_NAMES, ELEMENTARY_NAMES, Group, Op
from lagdsl.program.passes.chunk import Chunks, chunk
from lagdsl.program.passes.schedule import schedule

FUNCTIONS: dict[Op, str] = {
    **ELEMENTARY_NAMES,
    Op.ABS: "fabs",
    Op.SIGN: "lag_sign",
    Op.NOT: "lag_not",
    Op.POWER: "pow",
    Op.MOD: "lag_mod",
    Op.MIN: "lag_min",
    Op.MAX: "lag_max",
    Op.LESS: "lag_less",
    Op.LESS_EQUAL: "lag_less_equal",
    Op.EQUAL: "lag_equal",
    Op.AND: "lag_and",
    Op.OR: "lag_or",
    Op.SELECT: "lag_select",
}

# Compilers need superlinear time for long functions: above the first length they are cut into pieces of the second.
LONGEST_FUNCTION = 600
_PIECE = 150


@dataclass(frozen=True, slots=True)
class Store:
    """`target` (an lvalue) receives the value of `node`; `comment` tells where in the user's text it comes from."""

    target: str
    node: int
    comment: str = ""


@dataclass(frozen=True, slots=True)
class Statement:
    """A store or, where `store` is None, the variable of `node`."""

    node: int
    store: Store | None
    reads: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Code:
    """Bodies, to be put between braces: one, or several that share a scratch array of `scratch` numbers."""

    pieces: tuple[tuple[str, ...], ...]
    scratch: int


def code(graph: Graph, stores: tuple[Store, ...], prepared: Mapping[int, int]) -> Code:
    """Statements that do all `stores`. `prepared` are the places of values that are in the workspace already."""
    statements = _statements(graph, stores, prepared)
    position = {statement.node: index for index, statement in enumerate(statements) if statement.store is None}

    def reads(index: int) -> list[int]:
        return [position[node] for node in statements[index].reads]

    size = len(statements) if len(statements) <= LONGEST_FUNCTION else _PIECE
    chunks = chunk(range(len(statements)), reads, max(size, 1))
    pieces = tuple(_piece(graph, statements, position, prepared, chunks, index) for index in range(len(chunks.pieces)))
    return Code(pieces, chunks.size)


def _statements(graph: Graph, stores: tuple[Store, ...], prepared: Mapping[int, int]) -> list[Statement]:
    """Variables in topological order, every store as soon as it can be done."""
    named = schedule(graph, [store.node for store in stores], prepared).named
    position = {node: index for index, node in enumerate(named)}
    due: list[list[Statement]] = [[] for _ in range(len(named) + 1)]
    for store in stores:
        reads = (store.node,) if store.node in position else _reads(graph, store.node, position, prepared)
        due[1 + max((position[node] for node in reads), default=-1)].append(Statement(store.node, store, reads))
    statements = list(due[0])
    for index, node in enumerate(named):
        statements.append(Statement(node, None, _reads(graph, node, position, prepared)))
        statements.extend(due[index + 1])
    return statements


def _reads(graph: Graph, node: int, named: Mapping[int, int], prepared: Mapping[int, int]) -> tuple[int, ...]:
    """The variables that the expression of `node` reads."""
    found: dict[int, None] = {}
    stack = [] if node in prepared else list(graph.arguments(node))
    while stack:
        argument = stack.pop()
        if argument in named:
            found[argument] = None
        elif argument not in prepared:
            stack.extend(graph.arguments(argument))
    return tuple(found)


def _piece(
    graph: Graph,
    statements: list[Statement],
    position: Mapping[int, int],
    prepared: Mapping[int, int],
    chunks: Chunks,
    which: int,
) -> tuple[str, ...]:
    piece = chunks.pieces[which]
    inside = set(piece)
    used: dict[str, str] = {}

    def leaf(node: int) -> str | None:
        if node in prepared:
            used["c"] = "const double *const c = at->workspace;"
            return f"c[{prepared[node]}]"
        if graph.op[node] is Op.CONSTANT:
            return number(graph.value[node])
        if graph.op[node] is Op.SYMBOL:
            return _symbol(graph, node, used)
        index = position.get(node)
        if index is None:
            return None
        return f"v{index}" if index in inside else f"s[{chunks.slot[index]}]"

    printer = ExpressionPrinter(graph, leaf, FUNCTIONS)
    lines = [line for index in piece for line in _lines(statements[index], index, printer, chunks)]
    return (*used.values(), *lines)


def _symbol(graph: Graph, node: int, used: dict[str, str]) -> str:
    group = graph.group(node)
    array = ARGUMENT_NAMES[group]
    if group is Group.TIME:
        used[array] = "const double t = at->t;"
        return array
    used[array] = f"const double *const {array} = at->{array};"
    return f"{array}[{graph.b[node]}]"


def _lines(statement: Statement, index: int, printer: ExpressionPrinter, chunks: Chunks) -> list[str]:
    if statement.store is not None:
        comment = f" /* {statement.store.comment} */" if statement.store.comment else ""
        return [f"{statement.store.target} = {printer.text(statement.node)};{comment}"]
    lines = [f"const double v{index} = {printer.definition(statement.node)};"]
    if index in chunks.slot:
        lines.append(f"s[{chunks.slot[index]}] = v{index};")
    return lines
