"""Quantities that the parameters alone decide have finite values, whatever the parameters are.

The constant `inf` is a bound that is none; what is made of it may be infinite, but no mass, inertia or gravity is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Set

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.quantity import Item, Variability
from lagdsl.language.flat.spans import around, place
from lagdsl.language.flat.traversal import operands, postorder

_STEADY = (Variability.CONSTANT, Variability.STRUCTURAL, Variability.PARAMETER)
_MOST_SHOWN = 4
_LEAVES = (fx.Variable, fx.Number)
_WEIGHTS = {"mass": "kg", "moment of inertia": "kg.m2", "product of inertia": "kg.m2"}
_MOMENTS = 3


def is_unbounded(value: fx.FlatExpression) -> bool:
    """True if the constant `inf` stands in it."""
    return any(isinstance(node, fx.Number) and math.isinf(node.value) for node in postorder(value, {}))


@record()
class Decided:
    """A value that parameters alone determine: `names` stand in it, `parameters` (all of them) decide it."""

    item: Item
    subject: str
    value: fx.FlatExpression
    names: tuple[str, ...]
    unbounded: bool
    parameters: frozenset[str]


@remembered
def decided(flat: FlatModel) -> tuple[Decided, ...]:
    """Definitions first, each after those that it needs."""
    reach = {parameter.name: frozenset({parameter.name}) for parameter in flat.parameters}
    found = []
    for item, subject, value in _steady(flat, set(reach)):
        names = names_in(value)
        deciding = frozenset[str]().union(*(reach[name] for name in names if name in reach))
        found.append(Decided(item, subject, value, names, is_unbounded(value), deciding))
        if isinstance(item, Definition):
            reach[item.name] = deciding
    return tuple(found)


def names_in(value: fx.FlatExpression) -> tuple[str, ...]:
    """Names of variables, in the order of their first occurrence."""
    return tuple(dict.fromkeys(node.name for node in postorder(value, {}) if isinstance(node, fx.Variable)))


def check_finite(
    flat: FlatModel,
    parameters: Mapping[str, float],
    evaluator: Evaluator,
    sink: Sink,
    changed: Set[str] | None = None,
) -> None:
    """E0329 for each dependent parameter, start of a discrete variable, mass, inertia and gravity that is infinite or
    no number, E0506 for a mass that values other than the defaults make negative.

    Where all was well before parameters `changed`, only what these decide is computed.
    """
    values = {parameter.name: parameter.value for parameter in flat.parameters} | dict(parameters)
    told: set[str] = set()
    unbounded = {name for name, value in values.items() if math.isinf(value)}
    if not parameters:  # those that are found with the start have guesses only
        unbounded |= {parameter.name for parameter in flat.parameters if parameter.free}
    for each in decided(flat):
        known = told if not told.isdisjoint(each.names) else None
        if each.subject not in _WEIGHTS and (not unbounded.isdisjoint(each.names) or each.unbounded):
            known = unbounded
        if known is None and (changed is None or not changed.isdisjoint(each.parameters)):
            number = _number(evaluator, each.value, values)
            if not math.isfinite(number):
                units = {parameter.name: parameter.unit for parameter in flat.parameters if parameter.unit != "1"}
                shown = [
                    f"{name} = {values[name]:g} {units.get(name, '')}".rstrip() for name in each.names if name in values
                ]
                conditions = _conditions(shown)
                sink.report("E0329", place(each.item), *around(each.item), subject=each.subject, conditions=conditions)
                known = told
            elif parameters and number < 0.0 and each.subject in _WEIGHTS and not each.subject.startswith("product"):
                told_value, unit = f"{number:.6g}", _WEIGHTS[each.subject]
                sink.report(
                    "E0506", place(each.item), *around(each.item), what=each.subject, value=told_value, unit=unit
                )
        if known is not None and isinstance(each.item, Definition):
            known.add(each.item.name)
    _check_gravity(flat, values, evaluator, sink, changed)


def certainly_finite(flat: FlatModel, changed: Mapping[str, NDArray[np.float64]]) -> NDArray[np.bool_] | bool:
    """True of those values (runs,) of parameters with which `check_finite` has nothing to tell: where all was well
    before they changed, and each value that they decide is a parameter itself. Of others nothing is known."""
    certain: NDArray[np.bool_] | bool = not changed.keys() & set(_deciding_gravity(flat) or ())
    for each in decided(flat):
        if not each.parameters.isdisjoint(changed):
            values = changed.get(each.value.name) if isinstance(each.value, fx.Variable) else None
            if values is None:
                return False
            certain = certain & np.isfinite(values) & (values >= (0.0 if each.subject in _WEIGHTS else -np.inf))
    return certain


def _number(evaluator: Evaluator, value: fx.FlatExpression, values: Mapping[str, float]) -> float:
    if isinstance(value, fx.Variable) and value.name in values:
        return values[value.name]
    try:
        return evaluator.scalar(value)
    except NotEvaluable:
        return 0.0


def _conditions(shown: list[str]) -> str:
    return f" with {' and '.join(shown[:_MOST_SHOWN])}" if shown else ""


def _steady(flat: FlatModel, steady: set[str]) -> Iterator[tuple[Item, str, fx.FlatExpression]]:
    """Values that parameters alone determine; `steady` are the names of these."""
    for item in flat.named:
        if isinstance(item, Definition) and item.variability in _STEADY:
            steady.add(item.name)
            yield item, f"`{item.name}`", item.value
    for discrete in flat.events.discretes:
        if _is_steady(discrete.start, steady):
            yield discrete, f"the start of `{discrete.name}`", discrete.start
    for mass in flat.masses:
        if _is_steady(mass.mass, steady):
            yield mass, "mass", mass.mass
    for body in flat.bodies:
        if _is_steady(body.mass, steady):
            yield body, "mass", body.mass
        for index, moment in enumerate(body.inertia):
            if _is_steady(moment, steady):
                yield body, "moment of inertia" if index < _MOMENTS else "product of inertia", moment


def _is_steady(value: fx.FlatExpression, steady: set[str]) -> bool:
    leaves = (node for node in postorder(value, {}) if not operands(node))
    return all(
        isinstance(node, fx.Number) or (isinstance(node, fx.Variable) and node.name in steady) for node in leaves
    )


@remembered
def _deciding_gravity(flat: FlatModel) -> tuple[str, ...] | None:
    """Variables that gravity consists of beside axes; None where something else decides it."""
    if flat.gravity is None:
        return None
    leaves = [node for node in postorder(flat.gravity, {}) if not operands(node)]
    others = [leaf for leaf in leaves if not isinstance(leaf, (*_LEAVES, fx.FrameAxis))]
    return None if others else tuple(dict.fromkeys(leaf.name for leaf in leaves if isinstance(leaf, fx.Variable)))


def _check_gravity(
    flat: FlatModel, values: Mapping[str, float], evaluator: Evaluator, sink: Sink, changed: Set[str] | None
) -> None:
    """Checks the vector of gravity if it consists of independent parameters and axes."""
    names = _deciding_gravity(flat)
    if flat.gravity is None or names is None or sink.has_errors:
        return
    if changed is not None and changed.isdisjoint(names):
        return
    if not values.keys() >= set(names) or np.all(np.isfinite(evaluator.vector(flat.gravity))):
        return
    shown = [f"{name} = {values[name]:g}" for name in names]
    sink.report("E0329", flat.gravity_span, subject="gravity", conditions=_conditions(shown))
