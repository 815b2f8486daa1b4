"""The C source with the variables of an exported model: a constant of type lag_fmu."""

from __future__ import annotations

import math
from collections.abc import Sequence

from lagdsl.derivation.program.passes.speeds import speeds
from lagdsl.engines.backends.c.literal import number, string
from lagdsl.exchange.fmi.variables.held_relations import held_relations
from lagdsl.exchange.fmi.variables.scalar import Role, Variable
from lagdsl.exchange.fmi.variables.variables import Kind, Table, Version
from lagdsl.language.flat.model import FlatModel

_KINDS: dict[Kind, str] = {"me": "LAG_MODEL_EXCHANGE", "cs": "LAG_CO_SIMULATION"}


def table_source(table: Table, stem: str, token: str) -> str:
    """Text of `<stem>_fmu.c`, which stands beside `<stem>.h` and `<stem>_start.c`."""
    settings, flat = table.settings, table.flat
    constants = [(v.attributes.type == "STRING", start) for _, v in table.of(Role.CONSTANT) for start in v.starts]
    tables = {
        "variables": ("lag_variable", [_row(variable, table.version) for variable in table.variables]),
        "constants.numbers": ("double", _numbers([float(start) for is_text, start in constants if not is_text])),
        "constants.texts": ("char *const", [string(str(start)) for is_text, start in constants if is_text]),
        "nominal": ("double", _numbers(settings.nominal)),
        "sizes.group": ("double", _numbers(settings.groups)),
        "sizes.natural": ("double", _numbers(settings.natural)),
        "sizes.cap": ("double", _numbers(settings.caps)),
        "sizes.row_sizes": ("double", _numbers(settings.row_sizes)),
        "row_factors": ("double", _numbers(table.program.layout.row_factors)),
        "lasting.rows": ("double", _numbers([float(flag) for flag in settings.lasting])),
        "parameter_range": ("lag_range", _ranges(table, len(settings.parameters), Role.PARAMETER, Role.FREE)),
        "inputs.range": ("lag_range", _ranges(table, len(flat.inputs), Role.INPUT)),
        "indicators.entries": ("size_t", _indicators(table)),
        "states.entries": ("size_t", _states(table)),
        "inputs.rates": ("size_t", _input_rates(flat)),
        "inputs.continuous": ("unsigned char", _continuous_inputs(table)),
        "invariant_limits": ("double", _numbers([invariant.tolerance or 0.0 for invariant in flat.invariants])),
    }
    if table.dependent:
        tables |= _dependent_coordinates(table)
    if table.version == 3:
        tables |= _dependencies(table)
    experiment = flat.experiment
    members = [
        f".model = &{stem}_model",
        f".token = {string(token)}",
        f".nvariable = {len(table.variables)}",
        *(f".{member} = {_name(member)}" for member, (_, rows) in tables.items() if rows),
        f".start = &{stem}_start",
        f".experiment.start = {number(experiment.start_time)}",
        f".experiment.stop = {number(experiment.stop_time)}",
        f".experiment.tolerance = {number(experiment.tolerance)}",
        f".lasting.general = {settings.general}",
        *(
            f".{member.partition('.')[0]}.count = {len(tables[member][1])}"
            for member in ("indicators.entries", "states.entries", "dependents.coordinates")
            if member in tables
        ),
        f".kinds = {' | '.join(_KINDS[kind] for kind in table.kinds)}",
    ]
    return "".join(
        [
            "/* Variables of the model as importers see them, generated: see lag/fmu.h for what is what. */\n",
            f'#include "{stem}.h"\n\n#include "lag/fmu.h"\n\n#include <math.h>\n\n',
            *(_array(kind, _name(member), rows) for member, (kind, rows) in tables.items()),
            "extern const lag_fmu lag_exported;\n\n",
            "const lag_fmu lag_exported = {\n" + "".join(f"    {member},\n" for member in members) + "};\n",
        ]
    )


def _row(variable: Variable, version: Version) -> str:
    """FMI 2 has enumerations as integers."""
    attributes = variable.attributes
    kind = "INTEGER" if attributes.type == "ENUMERATION" and version == 2 else attributes.type
    return (
        f"{{LAG_ROLE_{attributes.role}, LAG_TYPE_{kind}, LAG_SET_{attributes.setting}, "
        f"{variable.first}, {variable.count}, {string(variable.name)}}}"
    )


def _dependencies(table: Table) -> dict[str, tuple[str, list[str]]]:
    firsts, rows = [0], []
    for own in table.structure.elements:
        rows += [f"{{{d.element}, {d.other}, {d.other_element}, LAG_DEPENDENCE_{d.kind.upper()}}}" for d in own]
        firsts.append(len(rows))
    return {"dependencies.first": ("size_t", _counts(firsts)), "dependencies.entries": ("lag_dependency", rows)}


def _dependent_coordinates(table: Table) -> dict[str, tuple[str, list[str]]]:
    """Entries of x that are no states, and the terms by which they follow."""
    firsts, terms = [0], list[tuple[int, float]]()
    for each in table.dependent:
        terms += each.terms
        firsts.append(len(terms))
    return {
        "dependents.coordinates": ("size_t", _counts([each.place for each in table.dependent])),
        "dependents.term_first": ("size_t", _counts(firsts)),
        "dependents.term_of": ("size_t", _counts([other for other, _ in terms])),
        "dependents.term_weight": ("double", _numbers([weight for _, weight in terms])),
    }


def _counts(values: Sequence[int]) -> list[str]:
    return [str(value) for value in values]


def _ranges(table: Table, count: int, *roles: Role) -> list[str]:
    """Of all `count` parameters or inputs, where one of them has bounds. The motion may lead a real input anywhere."""
    ranges = [(-math.inf, math.inf)] * count
    for variable in (found for role in roles for _, found in table.of(role)):
        attributes = variable.attributes
        if attributes.role is Role.INPUT and attributes.type == "REAL":
            continue
        low, high = attributes.minimum, attributes.maximum
        if attributes.literals:
            low, high = 1.0, float(len(attributes.literals))
        for entry in variable.entries:
            ranges[entry] = (-math.inf if low is None else low, math.inf if high is None else high)
    bounded = any(math.isfinite(bound) for both in ranges for bound in both)
    return [f"{{{number(low)}, {number(high)}}}" for low, high in ranges] if bounded else []


def _states(table: Table) -> list[str]:
    """Entries of x that importers integrate."""
    n = len(table.flat.coordinates)
    follow = {each.place + first for each in table.dependent for first in (0, n)}
    return _counts([entry for entry in range(2 * n + len(table.flat.states)) if entry not in follow])


def _indicators(table: Table) -> list[str]:
    """Guards that are event indicators; behind relations stand contacts and dry friction."""
    events = table.flat.events
    held = (*held_relations(table.flat, table.program), *[False] * (len(events.contacts) + len(events.frictions)))
    return _counts([guard for guard, is_held in enumerate(held) if not is_held])


def _input_rates(flat: FlatModel) -> list[str]:
    """By input, the index of the one that is its time derivative; none where no input has one."""
    rates = {item.derivative_of: index for index, item in enumerate(flat.inputs) if item.derivative_of is not None}
    return [str(rates.get(item.name, len(flat.inputs))) for item in flat.inputs] if rates else []


def _continuous_inputs(table: Table) -> list[str]:
    """Flags of inputs with derivatives that may not jump: all but those that prescribe a speed."""
    inputs = table.flat.inputs
    followed = {item.derivative_of for item in inputs}
    if followed == {None}:
        return []
    may_jump = speeds(table.flat, table.program)
    return _flags([item.name in followed and not jumps for item, jumps in zip(inputs, may_jump, strict=True)])


def _numbers(values: Sequence[float]) -> list[str]:
    return [number(value) for value in values]


def _flags(values: Sequence[bool]) -> list[str]:
    return [str(int(value)) for value in values]


def _name(member: str) -> str:
    """Of the table that `member` of lag_fmu points at."""
    return "fmu_" + member.replace(".", "_")


def _array(kind: str, name: str, rows: Sequence[str]) -> str:
    """A table; none where it has no rows, since C has no empty arrays."""
    if not rows:
        return ""
    return f"static const {kind} {name}[] = {{\n" + "".join(f"    {row},\n" for row in rows) + "};\n\n"
