"""The model structure of FMI: which variables are computed, and what they depend on."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.fmi.scalar import Role
from lagdsl.fmi.variables import Table
from lagdsl.record import record


@record(kw_only=True)
class Unknown:
    """A computed variable, and the variables that it depends on with the kinds of dependence; None: not known."""

    variable: int
    dependencies: tuple[tuple[int, str], ...] | None = None


def outputs(table: Table) -> tuple[Unknown, ...]:
    return tuple(Unknown(variable=index) for index, _ in table.of(Role.OUTPUT))


def derivatives(table: Table) -> tuple[Unknown, ...]:
    """Time derivatives of all states, in the order of x."""
    return tuple(Unknown(variable=index) for index, v in enumerate(table.variables) if v.derivative_of is not None)


def indicators(table: Table) -> tuple[Unknown, ...]:
    return tuple(Unknown(variable=index) for index, _ in table.of(Role.INDICATOR))


def initial_unknowns(table: Table) -> tuple[Unknown, ...]:
    """What initialization computes, by value reference."""
    return tuple(Unknown(variable=index) for index in sorted(_initial_unknowns(table)))


def _initial_unknowns(table: Table) -> Iterator[int]:
    moving = {unknown.variable for unknown in derivatives(table)}
    moving |= {index for index, _ in table.of(Role.STATE)}
    for index, variable in enumerate(table.variables):
        causality = variable.attributes.causality
        if variable.initial == "exact" or variable.initial is None:
            continue
        if causality in ("output", "calculatedParameter") or index in moving:
            yield index
