"""Stores of the results of a function, and the frame around its code."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.derivation.program.program import Block, Function, Layout, Program, Slot
from lagdsl.engines.backends.c.dialect import SCRATCH, SINGLE, Dialect, Place
from lagdsl.engines.backends.c.function import Code, Head, braced
from lagdsl.engines.backends.c.statement import Store
from lagdsl.engines.backends.identifier import comment_text
from lagdsl.foundation.record import record

_FEWEST_ZEROS = 8


def names_of(function: str) -> list[str]:
    """The names of its result arrays in C."""
    return [result.name for result in BY_NAME[function].results]


@record()
class Results:
    """Code that fills the results of a function: lines before and after everything, and the stores between."""

    first: tuple[str, ...] = ()
    stores: tuple[Store, ...] = ()
    last: tuple[str, ...] = ()


def results(program: Program, function: Function, dialect: Dialect) -> Results:
    """Clears arrays that are mostly zero first, and copies one half of symmetric ones. Matrices in what the model
    alone writes (lag/model.h) are clear."""
    named = enumerate(zip(names_of(function.name), function.results, strict=True))
    arrays = [(name, block, _places(program.layout, function.name, position)) for position, (name, block) in named]
    return filled(arrays, dialect)


def filled(arrays: Iterable[tuple[str, Block, Sequence[Slot]]], dialect: Dialect) -> Results:
    """The same for arrays by their names in C, with the slots whose declarations their rows come from."""
    first: list[str] = []
    last: list[str] = []
    stores: list[Store] = []
    for name, block, places in arrays:
        mirrored = _is_symmetric(block)
        if _is_sparse(block):
            count, zero = block.size, dialect.literal(0.0)
            where = f"lag_is_kept(at, {name}) ? 0 : {count}" if dialect is SINGLE and len(block.shape) == 2 else count
            first.append(f"for (size_t i = 0, count = {where}; i < count; ++i) {{ {name}[i] = {zero}; }}")
        if mirrored:
            last.append(_MIRROR.format(name=name, n=block.shape[0]))
        stores += _stores(block, name, places, mirrored)
    return Results(tuple(first), tuple(stores), tuple(last))


_MIRROR = (
    "for (size_t i = 0; i < {n}; ++i) {{ for (size_t j = 0; j < i; ++j) {{ "
    "{name}[j * {n} + i] = {name}[i * {n} + j]; }} }}"
)


def _is_symmetric(block: Block) -> bool:
    if len(block.shape) != 2 or block.shape[0] != block.shape[1] or block.shape[0] < 3:
        return False
    n, found = block.shape[0], dict(block.entries)
    return all(found.get(place % n * n + place // n) == node for place, node in found.items())


def _is_sparse(block: Block) -> bool:
    return block.size - sum(1 for _ in block.entries) >= _FEWEST_ZEROS


def _stores(block: Block, name: str, places: Sequence[Slot], mirrored: bool) -> list[Store]:
    sparse = _is_sparse(block)
    width = block.shape[1] if len(block.shape) == 2 else 1
    stores = []
    commented = set[int]()
    for index, node in block.entries if sparse else enumerate(block.elements):
        row, column = divmod(index, max(width, 1))
        if mirrored and column > row:
            continue
        place = place_of(places[row]) if row < len(places) and row not in commented else None
        commented.add(row)
        stores.append(Store(Place(name, index), node, comment_text(place) if place else ""))
    return stores


def place_of(slot: Slot) -> str | None:
    """file:line without the folder: the same text gives the same bytes wherever it lies."""
    return None if slot.place is None else slot.place.replace("\\", "/").rpartition("/")[2]


def _places(layout: Layout, function: str, position: int) -> Sequence[Slot]:
    """The slots whose declarations the rows of a result come from."""
    shape = BY_NAME[function].results[position].shape
    tables = {
        "nq": layout.coordinates,
        "nz": layout.states,
        "nu": layout.inputs,
        "nc": layout.constraints,
        "ny": layout.outputs,
        "ni": layout.invariants,
        "nd": layout.definitions,
    }
    return tables.get(shape[0], ()) if shape else ()


def definition(head: Head, made: Code, contents: Results, dialect: Dialect, scratch: str) -> str:
    """A static function after the definitions that it needs; `scratch` is where its scratch array starts."""
    unused = [f"(void){argument};" for argument in head.arguments]
    memory = dialect.memory
    cast = "" if dialect is SINGLE else f"({memory} *)"
    own = [f"{memory} *const {SCRATCH} = {cast}({scratch});"] if made.scratch or made.definitions else []
    signature = f"static {made.attribute}lag_status {head.name}({', '.join(head.parameters)})"
    body = [*unused, *own, *contents.first, *made.body, *contents.last, "return LAG_OK;"]
    return made.definitions + braced(signature, body)
