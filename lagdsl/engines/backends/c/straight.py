"""Straight-line code: one piece, or several that pass values on in the scratch array."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Op
from lagdsl.derivation.program.passes.chunk import Chunks, chunk
from lagdsl.engines.backends.c.dialect import SCRATCH, Dialect
from lagdsl.engines.backends.c.statement import Gather, Listing, Statement, reads
from lagdsl.engines.backends.expression import ExpressionPrinter


def pieces(listing: Listing, dialect: Dialect, largest: int, fused: Mapping[int, int]) -> tuple[list[list[str]], int]:
    """Bodies of at most `largest` statements each, and the length of the scratch array that they share."""
    statements = listing.statements
    position = {statement.node: index for index, statement in enumerate(statements) if statement.is_variable}

    def read_by(index: int) -> list[int]:
        return [position[node] for node in reads(listing.graph, statements[index], position, listing.given)]

    chunks = chunk(range(len(statements)), read_by, max(largest, 1))
    texts = [_piece(listing, dialect, position, chunks, which, fused) for which in range(len(chunks.pieces))]
    return texts, listing.gathered + chunks.size


def gathering(gather: Gather, dialect: Dialect) -> str:
    """The call that does it."""
    first, count = gather.first, gather.count
    arrays = ", ".join(f"{SCRATCH} + {start}" for start in (first, first + count, first + 2 * count))
    return f"lag{dialect.suffix}_sincos_many({count}, {arrays});"


def _piece(
    listing: Listing,
    dialect: Dialect,
    position: dict[int, int],
    chunks: Chunks,
    which: int,
    fused: Mapping[int, int],
) -> list[str]:
    graph = listing.graph
    inside = set(chunks.pieces[which])
    used: dict[str, str | None] = {}

    def leaf(node: int) -> str | None:
        place = listing.given.get(node)
        if place is not None:
            used.setdefault(place.array, dialect.declaration(place.array))
            return dialect.read(place.array, str(place.index))
        if graph.op[node] is Op.CONSTANT:
            return dialect.literal(graph.value[node])
        if graph.op[node] is Op.SYMBOL:
            array = ARGUMENT_NAMES[graph.group(node)]
            used.setdefault(array, dialect.declaration(array))
            return dialect.read(array, str(graph.b[node]))
        index = position.get(node)
        if index is None:
            return None
        return f"v{index}" if index in inside else f"{SCRATCH}[{listing.gathered + chunks.slot[index]}]"

    printer = ExpressionPrinter(graph, leaf, dialect.functions, fused=fused, fuse=dialect.fused)
    lines = [
        line
        for index in chunks.pieces[which]
        for line in _lines(listing, dialect, listing.statements[index], index, printer, chunks)
    ]
    return [*(line for line in used.values() if line is not None), *lines]


def _lines(
    listing: Listing, dialect: Dialect, statement: Statement, index: int, printer: ExpressionPrinter, chunks: Chunks
) -> list[str]:
    if statement.gather is not None:
        return [gathering(statement.gather, dialect)]
    if statement.store is not None:
        comment = f" /* {statement.store.comment} */" if statement.store.comment else ""
        target = statement.store.target
        return [f"{target.array}[{target.index}] = {printer.text(statement.node)};{comment}"]
    lines = [f"const {dialect.real} v{index} = {printer.definition(statement.node)};"]
    if index in chunks.slot:
        lines.append(f"{SCRATCH}[{listing.gathered + chunks.slot[index]}] = v{index};")
    return lines
