"""One function of a program as C: a straight line while short, loops where a long one repeats itself, else pieces."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.derivation.program.passes.fuse import exact, fused
from lagdsl.engines.backends.c.dialect import SCRATCH, SINGLE, Dialect, Place
from lagdsl.engines.backends.c.kernel import rolled_code
from lagdsl.engines.backends.c.reroll import reroll
from lagdsl.engines.backends.c.statement import Listing, Store, listing
from lagdsl.engines.backends.c.straight import pieces
from lagdsl.foundation.record import record

# Compilers need superlinear time for long functions: above the first number of statements they are rolled, where that
# leaves less than this part of the text, or cut into pieces of the second number.
LONGEST_FUNCTION = 600
_PIECE = 150
# Accelerations of one state in more statements than this are more instructions than processors keep decoded (LAG_LONG).
_LONG = 450
_ROLLED_PART = 0.5
# Functions of inertia, in which sums are fused with their products: accelerations wait for a chain of these.
FUSED = ("elimination",)
# The result whose comparisons are with thresholds, not with what is nothing when exact.
_CHECK = "pivot"


@record()
class Head:
    """Name, declared parameters and their names; whether sums are fused with their products."""

    name: str
    parameters: Sequence[str]
    arguments: Sequence[str]
    fused: bool = False


@record()
class Code:
    """`body` is to be put between braces, `definitions` before; they use a scratch array `s` of `scratch` values.
    `attribute` stands in front of the function."""

    definitions: str
    body: tuple[str, ...]
    scratch: int
    attribute: str = ""


def code(graph: Graph, stores: tuple[Store, ...], given: Mapping[int, Place], dialect: Dialect, head: Head) -> Code:
    """Statements that do all `stores`. `given` are the places of values that are at hand already."""
    kept = exact(graph, [store.node for store in stores if store.target.array != _CHECK]) if head.fused else None
    made = listing(graph, stores, given, kept)
    sums = {} if kept is None else _fused(made, stores, kept)
    if len(made.statements) <= LONGEST_FUNCTION:
        bodies, scratch = pieces(made, dialect, len(made.statements), sums)
        attribute = "LAG_LONG " if head.fused and dialect is SINGLE and len(made.statements) > _LONG else ""
        return Code("", tuple(line for body in bodies for line in body), scratch, attribute)
    rolled = reroll(made, sums)
    if rolled.length <= _ROLLED_PART * len(made.statements):
        definitions, calls = rolled_code(rolled, dialect, head.name, head.parameters, head.arguments)
        return Code(definitions, tuple(calls), rolled.scratch)
    bodies, scratch = pieces(made, dialect, _PIECE, sums)
    return Code(
        "".join(_piece(head, dialect, index, body) for index, body in enumerate(bodies)),
        tuple(f"{head.name}_{index}({', '.join([*head.arguments, SCRATCH])});" for index in range(len(bodies))),
        scratch,
    )


def _fused(made: Listing, stores: tuple[Store, ...], kept: Collection[int]) -> dict[int, int]:
    named = {statement.node for statement in made.statements if statement.is_variable}
    live = made.graph.live([store.node for store in stores], made.given)
    return fused(made.graph, live, named, made.given, kept)


def _piece(head: Head, dialect: Dialect, index: int, body: Sequence[str]) -> str:
    parameters = ", ".join([*head.parameters, f"{dialect.memory} *{SCRATCH}"])
    unused = [f"(void){argument};" for argument in (*head.arguments, SCRATCH)]
    return braced(f"static LAG_APART void {head.name}_{index}({parameters})", [*unused, *body])


def braced(head: str, lines: Sequence[str]) -> str:
    """A function."""
    return "\n".join([head, "{", *(f"    {line}" for line in lines), "}", ""]) + "\n"
