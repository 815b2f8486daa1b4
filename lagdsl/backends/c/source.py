"""The generated C file: tables, one static function per function of the program, and the constant with all of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.backends.c.dialect import PREPARED, SCRATCH, SINGLE, Place
from lagdsl.backends.c.function import Code, Head, braced, code
from lagdsl.backends.c.literal import number, string
from lagdsl.backends.c.statement import Store
from lagdsl.backends.identifier import comment_text
from lagdsl.graph.graph import Graph
from lagdsl.program.passes.hoist import hoisted
from lagdsl.program.program import Block, Function, Layout, Program, Slot
from lagdsl.program.verify import RESULT_SHAPES, sizes

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
    "elimination": ("qdd", "response", "jacobian", "gamma", "pivot"),
}
_FEWEST_ZEROS = 8


def source(program: Program, stem: str) -> str:
    """Text of `stem`.c."""
    prepared = {node: Place(PREPARED, index) for index, node in enumerate(hoisted(program))}
    scratch = 0
    functions: list[str] = []
    for function in program.functions:
        text, size = _function(program, function, prepared)
        functions.append(text)
        scratch = max(scratch, size)
    preparation, size = _prepare(program, prepared)
    scratch = max(scratch, size)
    return "\n".join(
        [
            f"/* Equations of motion of {comment_text(program.name)}, generated: see lag/model.h for what is what. */",
            f'#include "{stem}.h"\n',
            '#include <math.h>\n\n#include "lag/trigonometry.h"\n',
            _tables(program.layout),
            preparation,
            *functions,
            _model(program, stem, len(prepared), scratch),
        ]
    )


def header(stem: str) -> str:
    """Text of `stem`.h."""
    guard = f"{stem.upper()}_GENERATED_H"
    declaration = f'#include "lag/model.h"\n\nextern const lag_model {symbol(stem)};'
    return f"#ifndef {guard}\n#define {guard}\n\n{declaration}\n\n#endif\n"


def symbol(stem: str) -> str:
    """Name of the constant that holds the model."""
    return f"{stem}_model"


# ---- functions -------------------------------------------------------------------------------------------------------


def _function(program: Program, function: Function, prepared: Mapping[int, Place]) -> tuple[str, int]:
    names = RESULTS[function.name]
    graph = program.graph
    first: list[str] = []
    last: list[str] = []
    stores: list[Store] = []
    for position, (name, block) in enumerate(zip(names, function.results, strict=True)):
        mirrored = _is_symmetric(block)
        places = _places(program.layout, function.name, position)
        if _is_sparse(graph, block):
            first.append(f"for (size_t i = 0; i < {len(block.elements)}; ++i) {{ {name}[i] = 0.0; }}")
        if mirrored:
            last.append(_MIRROR.format(name=name, n=block.shape[0]))
        stores += _stores(graph, block, name, places, mirrored)
    parameters = ["const lag_arguments *at", *(f"double *{name}" for name in names)]
    head = Head(f"model_{function.name}", parameters, ["at", *names])
    made = code(graph, tuple(stores), prepared, SINGLE, head)
    return _definition(head, made, first, last, len(prepared)), made.scratch


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
        place = _place(places[row]) if row < len(places) and row not in commented else None
        commented.add(row)
        stores.append(Store(Place(name, index), node, comment_text(place) if place else ""))
    return stores


def _place(slot: Slot) -> str | None:
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
    }
    return tables.get(shape[0], ()) if shape else ()


def _prepare(program: Program, prepared: Mapping[int, Place]) -> tuple[str, int]:
    stores = tuple(Store(Place("result", place.index), node) for node, place in prepared.items())
    head = Head("model_prepare_from", ["const lag_arguments *at", "double *result"], ["at", "result"])
    made = code(program.graph, stores, {}, SINGLE, head)
    lines = ["lag_arguments given = {0};", "given.p = p;", "given.workspace = workspace;"]
    body = _definition(head, made, [], [], len(prepared))
    prepare = "static lag_status model_prepare(const double *p, double *workspace)"
    return body + braced(prepare, [*lines, "return model_prepare_from(&given, workspace);"]), made.scratch


def _definition(head: Head, made: Code, first: list[str], last: list[str], prepared: int) -> str:
    """A static function after the definitions that it needs."""
    unused = [f"(void){argument};" for argument in head.arguments]
    scratch = [f"double *const {SCRATCH} = at->workspace + {prepared};"] if made.scratch or made.definitions else []
    signature = f"static lag_status {head.name}({', '.join(head.parameters)})"
    body = [*unused, *scratch, *first, *made.body, *last, "return LAG_OK;"]
    return made.definitions + braced(signature, body)


# ---- tables ----------------------------------------------------------------------------------------------------------


def _tables(layout: Layout) -> str:
    flags = {"position_level": layout.position_level, "redundant": layout.redundant}
    texts = [_slots(name, slots) for name, slots in _slot_tables(layout).items()]
    texts += [_array("unsigned char", name, [str(int(flag)) for flag in values]) for name, values in flags.items()]
    texts.append(_array("double", "defaults", [number(value) for value in layout.defaults]))
    texts.append(_array("char *const", "assertions", [string(text) for text in layout.assertions]))
    return "".join(texts)


def _slot_tables(layout: Layout) -> dict[str, tuple[Slot, ...]]:
    return {
        "coordinates": layout.coordinates,
        "states": layout.states,
        "inputs": layout.inputs,
        "discretes": layout.discretes,
        "parameters": layout.parameters,
        "constraints": layout.constraints,
        "outputs": layout.outputs,
        "invariants": layout.invariants,
    }


def _slots(name: str, slots: Sequence[Slot]) -> str:
    rows = []
    for slot in slots:
        place = _place(slot)
        rows.append(f"{{{string(slot.name)}, {string(slot.unit)}, {'NULL' if place is None else string(place)}}}")
    return _array("lag_slot", name, rows)


def _array(kind: str, name: str, rows: Sequence[str]) -> str:
    """A table; none where it has no rows, since C has no empty arrays."""
    if not rows:
        return ""
    return f"static const {kind} model_{name}[] = {{\n" + "".join(f"    {row},\n" for row in rows) + "};\n\n"


def _model(program: Program, stem: str, prepared: int, scratch: int) -> str:
    layout = program.layout
    counts = {
        **sizes(layout),
        "ne": len(program.function("initial_equation").results[0].elements),
        "rank": len(layout.constraints) - sum(layout.redundant),
        "workspace": prepared + scratch,
        "prepared": prepared,
    }
    tables: dict[str, Sequence[object]] = {
        **_slot_tables(layout),
        "assertions": layout.assertions,
        "defaults": layout.defaults,
        "position_level": layout.position_level,
        "redundant": layout.redundant,
    }
    members = [
        ".version = LAG_MODEL_VERSION",
        ".size = sizeof(lag_model)",
        f".name = {string(program.name)}",
        *(f".{name} = {count}" for name, count in counts.items()),
        *(f".{name} = model_{name}" for name, rows in tables.items() if rows),
        ".prepare = model_prepare",
        *(f".{function.name} = model_{function.name}" for function in program.functions),
    ]
    return f"const lag_model {symbol(stem)} = {{\n" + "".join(f"    {member},\n" for member in members) + "};\n"
