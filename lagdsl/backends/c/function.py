"""One function of a program as C: a straight line while short, loops where a long one repeats itself, else pieces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from lagdsl.backends.c.dialect import SCRATCH, Dialect, Place
from lagdsl.backends.c.kernel import rolled_code
from lagdsl.backends.c.roll import roll
from lagdsl.backends.c.statement import Store, listing
from lagdsl.backends.c.straight import pieces
from lagdsl.graph.graph import Graph

# Compilers need superlinear time for long functions: above the first number of statements they are rolled, where that
# leaves less than this part of the text, or cut into pieces of the second number.
LONGEST_FUNCTION = 600
_PIECE = 150
_ROLLED_PART = 0.5


@dataclass(frozen=True, slots=True)
class Head:
    """Name, declared parameters and their names."""

    name: str
    parameters: Sequence[str]
    arguments: Sequence[str]


@dataclass(frozen=True, slots=True)
class Code:
    """`body` is to be put between braces, `definitions` before; they use a scratch array `s` of `scratch` values."""

    definitions: str
    body: tuple[str, ...]
    scratch: int


def code(graph: Graph, stores: tuple[Store, ...], given: Mapping[int, Place], dialect: Dialect, head: Head) -> Code:
    """Statements that do all `stores`. `given` are the places of values that are at hand already."""
    made = listing(graph, stores, given)
    if len(made.statements) <= LONGEST_FUNCTION:
        bodies, scratch = pieces(made, dialect, len(made.statements))
        return Code("", tuple(line for body in bodies for line in body), scratch)
    rolled = roll(made)
    if rolled.length <= _ROLLED_PART * len(made.statements):
        definitions, calls = rolled_code(rolled, dialect, head.name, head.parameters, head.arguments)
        return Code(definitions, tuple(calls), rolled.scratch)
    bodies, scratch = pieces(made, dialect, _PIECE)
    return Code(
        "".join(_piece(head, dialect, index, body) for index, body in enumerate(bodies)),
        tuple(f"{head.name}_{index}({', '.join([*head.arguments, SCRATCH])});" for index in range(len(bodies))),
        scratch,
    )


def _piece(head: Head, dialect: Dialect, index: int, body: Sequence[str]) -> str:
    parameters = ", ".join([*head.parameters, f"{dialect.memory} *{SCRATCH}"])
    unused = [f"(void){argument};" for argument in (*head.arguments, SCRATCH)]
    return braced(f"static LAG_APART void {head.name}_{index}({parameters})", [*unused, *body])


def braced(head: str, lines: Sequence[str]) -> str:
    """A function."""
    return "\n".join([head, "{", *(f"    {line}" for line in lines), "}", ""]) + "\n"
