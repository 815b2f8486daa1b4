"""How the results of a function are filled, and the frame around its code."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from lagdsl.backends.c.dialect import SCRATCH, SINGLE, Dialect, Place
from lagdsl.backends.c.function import Code, Head, braced
from lagdsl.backends.c.statement import Store
from lagdsl.backends.identifier import comment_text
from lagdsl.graph.graph import Graph
from lagdsl.program.program import Block, Function, Layout, Program, Slot
from lagdsl.program.verify import RESULT_SHAPES

# Names of the result arrays, as in lag/model.h.
RESULTS: dict[str, tuple[str, ...]] = {
    "start": ("q0", "qd0", "z0", "u0"),
    "position_constraint": ("phi", "jacobian"),
    "velocity_constraint": ("residual", "jacobian"),
    "constraint_tangent": ("phi", "residual"),
    "mass_matrix": ("mass",),
    "dynamics": ("mass", "force", "jacobian", "gamma"),
    "inverse_dynamics": ("force",),
    "residual": ("motion", "rows"),
    "residual_tangent": ("motion", "rows"),
    "state_derivative": ("rates",),
    "state_derivative_tangent": ("rates",),
    "output": ("y",),
    "output_tangent": ("y",),
    "energies": ("total", "kinetic", "potential", "jacobi"),
    "momenta": ("momentum",),
    "power": ("load", "dissipated"),
    "monitor": ("invariant", "scale", "assertion"),
    "initial_equation": ("residual",),
    "momentum_tangent": ("momentum",),
    "elimination": ("qdd", "lam", "response", "lam_response", "jacobian", "gamma", "pivot"),
    "acceleration_tangent": ("change", "lam_change", "rows", "pivot"),
    "discrete_start": ("w0",),
    "indicator": ("g",),
    "standing": ("next",),
    "contact": ("gap", "speed", "jacobian", "restitution", "stick", "rest"),
    "clock": ("first", "period"),
    "event": ("next", "reset", "value", "collision", "restitution", "stop", "fail"),
    "time_event": ("value", "told", "distance", "rate", "affine", "entry", "change"),
    "definition": ("d",),
    "definition_tangent": ("d",),
    "start_tangent": ("q", "qd", "z", "u"),
    "energies_tangent": ("total", "kinetic", "potential", "jacobi"),
    "initial_equation_tangent": ("residual",),
    "time_tangent": (
        *("motion", "rows", "phi", "residual", "rates", "y"),
        *("total", "kinetic", "potential", "jacobi", "d"),
    ),
}
_FEWEST_ZEROS = 8


@dataclass(frozen=True, slots=True)
class Results:
    """How the results of a function are filled: lines before and after everything, and the stores between."""

    first: tuple[str, ...] = ()
    stores: tuple[Store, ...] = ()
    last: tuple[str, ...] = ()


def results(program: Program, function: Function, dialect: Dialect) -> Results:
    """What is mostly zero is cleared before, and of what is symmetric one half is copied."""
    graph = program.graph
    first: list[str] = []
    last: list[str] = []
    stores: list[Store] = []
    for position, (name, block) in enumerate(zip(RESULTS[function.name], function.results, strict=True)):
        mirrored = _is_symmetric(block)
        places = _places(program.layout, function.name, position)
        if _is_sparse(graph, block):
            zero = dialect.literal(0.0)
            first.append(f"for (size_t i = 0; i < {len(block.elements)}; ++i) {{ {name}[i] = {zero}; }}")
        if mirrored:
            last.append(_MIRROR.format(name=name, n=block.shape[0]))
        stores += _stores(graph, block, name, places, mirrored)
    return Results(tuple(first), tuple(stores), tuple(last))


_MIRROR = (
    "for (size_t i = 0; i < {n}; ++i) {{ for (size_t j = 0; j < i; ++j) {{ "
    "{name}[j * {n} + i] = {name}[i * {n} + j]; }} }}"
)


def _is_symmetric(block: Block) -> bool:
    if len(block.shape) != 2 or block.shape[0] != block.shape[1] or block.shape[0] < 3:
        return False
    n = block.shape[0]
    return all(block.elements[i * n + j] == block.elements[j * n + i] for i in range(n) for j in range(i))


def _is_sparse(graph: Graph, block: Block) -> bool:
    return sum(node == graph.zero for node in block.elements) >= _FEWEST_ZEROS


def _stores(graph: Graph, block: Block, name: str, places: Sequence[Slot], mirrored: bool) -> list[Store]:
    sparse = _is_sparse(graph, block)
    width = block.shape[1] if len(block.shape) == 2 else 1
    stores = []
    commented = set[int]()
    for index, node in enumerate(block.elements):
        row, column = divmod(index, max(width, 1))
        if (mirrored and column > row) or (sparse and node == graph.zero):
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
    shape = RESULT_SHAPES[function][position]
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
    signature = f"static lag_status {head.name}({', '.join(head.parameters)})"
    body = [*unused, *own, *contents.first, *made.body, *contents.last, "return LAG_OK;"]
    return made.definitions + braced(signature, body)
