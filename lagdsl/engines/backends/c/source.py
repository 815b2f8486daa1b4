"""The generated C file: tables, one static function per function of the program, and the constant with all of them."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping, Sequence

from lagdsl.derivation.program.functions import ALONG_MANY, WRITTEN_OUT
from lagdsl.derivation.program.lengths import counted, sizes
from lagdsl.derivation.program.passes.hoist import hoisted
from lagdsl.derivation.program.passes.pattern import Pattern, equations_pattern, patterns
from lagdsl.derivation.program.program import Function, Layout, Program, Slot
from lagdsl.engines.backends.c.dialect import PREPARED, SINGLE, Place
from lagdsl.engines.backends.c.function import FUSED, Head, braced, code
from lagdsl.engines.backends.c.literal import number, string
from lagdsl.engines.backends.c.results import Results, definition, names_of, place_of, results
from lagdsl.engines.backends.c.statement import Store
from lagdsl.engines.backends.identifier import comment_text
from lagdsl.language.flat.events import INITIAL


def source(program: Program, stem: str) -> str:
    """Text of `stem`.c."""
    prepared = {node: Place(PREPARED, index) for index, node in enumerate(hoisted(program))}
    made = {function.name: _function(program, function, prepared) for function in _single(program)}
    often = [name for name in made if name in _often(program)]
    preparation, size = _prepare(program, prepared)
    memory = len(prepared) + max(size, *(scratch for _, scratch in made.values()))
    return "\n".join(
        [
            f"/* Equations of motion of {comment_text(program.name)}, generated: see lag/model.h for what is what. */",
            *_names_of_kinematics(program.layout),
            f'#include "{stem}.h"\n',
            "#define LAG_LANES_AMONG_SINGLES",
            '#include <math.h>\n\n#include "lag/columns.h"\n#include "lag/trigonometry.h"\n',
            _tables(program),
            *(made[name][0] for name in often),
            '#include "lag/cold.h"\n',
            preparation,
            *(text for name, (text, _) in made.items() if name not in often),
            *_by_columns(program, stem, memory),
            _model(program, stem, len(prepared), memory),
        ]
    )


def header(stem: str, parts: Sequence[str] = (), *, start: bool = False) -> str:
    """Text of `stem`.h, which declares the model and, where they are there, what comes in lanes and the start."""
    guard = f"{stem.upper()}_GENERATED_H"
    read = ["model", "parallel"] if parts else ["model"]
    lines = [
        *(f'#include "lag/{name}.h"' for name in read),
        f"\nextern const lag_model {symbol(stem)};",
        *([f"extern const lag_start {stem}_start;"] if start else []),
        *(f"extern const lag_{part.removeprefix('parameter_')} {stem}_{part};" for part in parts),
    ]
    return "\n".join([f"#ifndef {guard}", f"#define {guard}\n", *lines, "\n#endif\n"])


def symbol(stem: str) -> str:
    """Name of the constant that holds the model."""
    return f"{stem}_model"


def _names_of_kinematics(layout: Layout) -> list[str]:
    """The order of the results of kinematics() and regressor()."""
    rows = {
        "Frames of kinematics()": layout.frames,
        "Points of kinematics()": layout.points,
        "Inertial parameters": [slot.name for slot in layout.inertial],
    }
    return [f"/* {title}: {comment_text(', '.join(names))} */" for title, names in rows.items() if names]


# ---- functions -------------------------------------------------------------------------------------------------------


def _single(program: Program) -> list[Function]:
    return [function for function in program.functions if function.name not in ALONG_MANY]


def _often(program: Program) -> tuple[str, ...]:
    """Functions that every evaluation of the equations of motion calls."""
    return ("elimination" if program.has("elimination") else "dynamics", "state_derivative")


def _function(program: Program, function: Function, prepared: Mapping[int, Place]) -> tuple[str, int]:
    names = names_of(function.name)
    parameters = ["const lag_arguments *at", *(f"double *{name}" for name in names)]
    if function.name == "residual" and _is_inverse_dynamics(program, function):
        signature = f"static lag_status model_residual({', '.join(parameters)})"
        return braced(signature, ["(void)rows;", "return model_inverse_dynamics(at, motion);"]), 0
    head = Head(f"model_{function.name}", parameters, ["at", *names], function.name in FUSED)
    contents = results(program, function, SINGLE)
    made = code(program.graph, contents.stores, prepared, SINGLE, head)
    return definition(head, made, contents, SINGLE, f"at->workspace + {len(prepared)}"), made.scratch


def _is_inverse_dynamics(program: Program, residual: Function) -> bool:
    """Without constraints they are the same, and need not be there twice."""
    motion, rows = residual.results
    (force,) = program.function("inverse_dynamics").results
    return not rows.elements and motion.elements == force.elements


def _prepare(program: Program, prepared: Mapping[int, Place]) -> tuple[str, int]:
    stores = tuple(Store(Place("result", place.index), node) for node, place in prepared.items())
    head = Head("model_prepare_from", ["const lag_arguments *at", "double *result"], ["at", "result"])
    made = code(program.graph, stores, {}, SINGLE, head)
    body = definition(head, made, Results(), SINGLE, f"at->workspace + {len(prepared)}")
    prepare = "static lag_status model_prepare(const lag_arguments *at)"
    return body + braced(prepare, ["return model_prepare_from(at, at->workspace);"]), made.scratch


def _by_columns(program: Program, stem: str, memory: int) -> list[str]:
    """The functions that are formed from others, whose memory is beyond that of all the others."""
    formed = [name for name in WRITTEN_OUT if not program.has(name)]
    return [_formed(name, stem, memory) for name in formed]


def _formed(name: str, stem: str, memory: int) -> str:
    parameters = ", ".join(["const lag_arguments *at", *(f"double *{result}" for result in names_of(name))])
    arguments = ", ".join([f"&{symbol(stem)}", "at", f"at->workspace + {memory}", *names_of(name)])
    helper = {"mass_matrix": "lag_mass_by_columns", "dynamics": "lag_dynamics_by_columns"}[name]
    return braced(f"static lag_status model_{name}({parameters})", [f"return {helper}({arguments});"])


# ---- tables ----------------------------------------------------------------------------------------------------------


def _tables(program: Program) -> str:
    layout = program.layout
    flags = {"position_level": layout.position_level, "redundant": layout.redundant}
    texts = [_slots(name, slots) for name, slots in _slot_tables(layout).items()]
    texts += [_array("unsigned char", name, [str(int(flag)) for flag in values]) for name, values in flags.items()]
    texts.append(_array("size_t", "kept_rows", [str(row) for row in program.kept_rows]))
    texts.append(_array("size_t", "components", [str(component) for component in layout.components]))
    texts.append(_array("double", "defaults", [number(value) for value in layout.defaults]))
    texts.append(_array("char *const", "assertions", [string(text) for text in layout.assertions]))
    texts += [_array(kind, name, rows) for name, (kind, rows) in _instant_tables(layout).items()]
    return "".join([*texts, _patterns(program)])


def _patterns(program: Program) -> str:
    """Patterns of the matrices; NULL for those that are not told."""
    told, found = patterns(program), equations_pattern(program)
    told["equations"] = (len(found.places), len(found.groups) + len(found.value_groups)), found.entries
    orders = {"place": found.places, "group": found.groups, "value_group": found.value_groups}
    members = [f"&model_{name}_pattern" if entries[0] else "NULL" for name, (_, entries) in told.items()]
    members += [f"model_equations_{name}" if numbers else "NULL" for name, numbers in orders.items()]
    return (
        "".join(_pattern(name, shape, entries) for name, (shape, entries) in told.items())
        + "".join(_array("size_t", f"equations_{name}", list(map(str, numbers))) for name, numbers in orders.items())
        + f"static const lag_patterns model_patterns = {{{', '.join(members)}}};\n\n"
    )


def _pattern(name: str, shape: tuple[int, int], entries: Pattern) -> str:
    """The entries of a matrix that can be nonzero; no text where they are not told."""
    rows, columns = entries
    if not rows:
        return ""
    first = [bisect_left(rows, row) for row in range(shape[0] + 1)]
    tables = {"rows": rows, "columns": columns, "first": first}
    return (
        "".join(_array("size_t", f"{name}_{table}", list(map(str, numbers))) for table, numbers in tables.items())
        + f"static const lag_pattern model_{name}_pattern = "
        + f"{{{shape[0]}, {shape[1]}, {len(rows)}, model_{name}_rows, model_{name}_columns, model_{name}_first}};\n\n"
    )


def _instant_tables(layout: Layout) -> dict[str, tuple[str, list[str]]]:
    """Type and rows by member of lag_model."""
    instants = layout.instants
    return {
        "kinds": ("unsigned char", [_kind(layout, index) for index in range(len(layout.kinds))]),
        "strict": ("unsigned char", [str(int(flag)) for flag in instants.strict]),
        "jumping": ("unsigned char", [str(int(flag)) for flag in instants.jumping]),
        "whole_inputs": ("unsigned char", [str(int(flag)) for flag in instants.whole_inputs]),
        "contact_rows": ("size_t", [str(row) for row in instants.contact_rows]),
        "one_way": ("unsigned char", [str(int(flag)) for flag in instants.one_way]),
        "frictions": ("char *const", [string(name) for name in instants.frictions]),
        "friction_rows": ("size_t", [str(row) for row in instants.friction_rows]),
        "friction_slips": ("size_t", [str(count) for count in instants.friction_slips]),
        "friction_contacts": ("size_t", [str(contact) for contact in instants.friction_contacts]),
        "switched_rows": ("size_t", [str(row) for row in instants.switched_rows]),
        "reset_places": ("size_t", [str(place) for place in instants.reset_places]),
        "resets": ("char *const", [string(name) for name in instants.resets]),
        "stops": ("char *const", [string(text) for text in instants.stops]),
        "failures": ("char *const", [string(text) for text in instants.failures]),
    }


def _kind(layout: Layout, index: int) -> str:
    """The lag_kind of an entry of w."""
    if layout.kinds[index] == "instant":
        return "LAG_KIND_INITIAL" if layout.discretes[index].name == INITIAL else "LAG_KIND_TERMINAL"
    return f"LAG_KIND_{layout.kinds[index].upper()}"


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
        "definitions": layout.definitions,
    }


def _slots(name: str, slots: Sequence[Slot]) -> str:
    rows = []
    for slot in slots:
        place = place_of(slot)
        rows.append(f"{{{string(slot.name)}, {string(slot.unit)}, {'NULL' if place is None else string(place)}}}")
    return _array("lag_slot", name, rows)


def _array(kind: str, name: str, rows: Sequence[str]) -> str:
    """A table; none where it has no rows, since C has no empty arrays."""
    if not rows:
        return ""
    return f"static const {kind} model_{name}[] = {{\n" + "".join(f"    {row},\n" for row in rows) + "};\n\n"


def _model(program: Program, stem: str, prepared: int, memory: int) -> str:
    layout = program.layout
    formed = [name for name in WRITTEN_OUT if not program.has(name)]
    beyond = 5 * len(layout.coordinates) + len(layout.constraints) if formed else 0
    counts: dict[str, object] = {
        **sizes(layout),
        "rank": len(layout.constraints) - sum(layout.redundant),
        "workspace": memory + beyond,
        "prepared": prepared,
        **counted(program),
        "nk": len(program.kept_rows),
        "nswitched": len(layout.instants.switched_rows),
    }
    tables: dict[str, Sequence[object]] = {
        **_slot_tables(layout),
        "assertions": layout.assertions,
        "defaults": layout.defaults,
        "position_level": layout.position_level,
        "redundant": layout.redundant,
        "kept_rows": program.kept_rows,
        "components": layout.components,
        **{name: rows for name, (_, rows) in _instant_tables(layout).items()},
    }
    members = [
        ".version = LAG_MODEL_VERSION",
        ".size = sizeof(lag_model)",
        f".name = {string(program.name)}",
        *(f".{name} = {count}" for name, count in counts.items()),
        *(f".{name} = model_{name}" for name, rows in tables.items() if rows),
        ".patterns = &model_patterns",
        ".prepare = model_prepare",
        *(f".{name} = model_{name}" for name in (*(f.name for f in _single(program)), *formed)),
    ]
    return f"const lag_model {symbol(stem)} = {{\n" + "".join(f"    {member},\n" for member in members) + "};\n"
