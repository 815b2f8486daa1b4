"""E0507, W0510, W0511: gravity forgotten, out of place, or counted twice."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.flat.probe import probes
from lagdsl.flat.quantity import Item
from lagdsl.flat.spans import around, place
from lagdsl.record import record

_MOST_TERMS = 40  # additive terms of a potential that are told apart
_TOLERANCE = 1e-9


def check_gravity(flat: fm.FlatModel, dependence: Dependence, sink: Sink, *, sampled: bool = True) -> None:
    """One `gravity` statement, depending on time and parameters, and, where `sampled`, no weight written twice."""
    if flat.gravity is None:
        _check_forgotten(flat, sink)
        return
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    positions = [name for name in dependence.of(flat.gravity) if name in moving]
    if positions:
        sink.report("E0507", flat.gravity_span, name=positions[0])
    elif sampled and any(term.kind == "potential" for term in flat.energies):
        _check_twice(flat, sink)
    if not _heavy(flat) and flat.gravity not in (fx.ZERO, fx.ZERO_VECTOR):
        reason = "it acts on `mass` and `body`; energies written by hand are taken as they stand"
        sink.report("W0514", flat.gravity_span, keyword="gravity", reason=reason)


def _check_forgotten(flat: fm.FlatModel, sink: Sink) -> None:
    heavy = _heavy(flat)
    if heavy and not any(term.kind in ("potential", "lagrangian") for term in flat.energies):
        sink.report("W0510", place(heavy[0]), *around(heavy[0]))


def _heavy(flat: fm.FlatModel) -> list[Item]:
    masses: list[Item] = [mass for mass in flat.masses if mass.mass != fx.ZERO]
    return masses + [body for body in flat.bodies if body.mass != fx.ZERO]


# ---- the comparison of a hand-written potential with the automatic terms ---------------------------------------------


@record()
class _Weight:
    """-m g.r of one mass or body at the probed moments, up to a constant."""

    item: Item
    values: NDArray[np.float64]


def _check_twice(flat: fm.FlatModel, sink: Sink) -> None:
    """W0511 where additive terms of a potential sum up to the weight of a mass, or of all masses.

    Terms and weights are sampled at random moments and compared as functions up to a constant: a least-squares fit of
    the weight by the terms must leave nothing and use each term either once or not at all.
    """
    terms = [
        (energy, value) for energy in flat.energies if energy.kind == "potential" for value in _terms(energy.value)
    ]
    terms = terms[:_MOST_TERMS]
    evaluators = [
        Evaluator(flat, Values(variables=moment.variables, rates=moment.rates))
        for moment in probes(flat, 2 * len(terms) + 8)
    ]
    try:
        columns = np.array([[evaluator.scalar(value) for _, value in terms] for evaluator in evaluators])
        weights = _weights(flat, evaluators)
    except NotEvaluable:
        return
    sound = np.all(np.isfinite(columns), axis=1)
    if np.count_nonzero(sound) < len(terms) + 4:
        return
    columns = _centered(columns[sound])
    for weight in weights:
        used = _sum_of(columns, _centered(weight.values[sound]))
        if used:
            energy = terms[used[0]][0]
            others = [Label(span) for span in (flat.gravity_span,) if span is not None]
            sink.report("W0511", place(energy), *around(energy), *others, item=_statement(weight.item))


def _statement(item: Item) -> str:
    """The text of an item, cut to a length that fits a label."""
    span = place(item)
    text = "mass" if span is None else " ".join(span.text.rstrip(";").split())
    return text if len(text) <= 40 else f"{text[:37]}..."


def _sum_of(columns: NDArray[np.float64], target: NDArray[np.float64]) -> list[int]:
    """The columns whose sum the target is; empty where it is no such sum."""
    size = float(np.max(np.abs(target), initial=0.0))
    if size == 0.0 or not np.all(np.isfinite(target)):
        return []
    scales = np.max(np.abs(columns), axis=0)
    factors = np.linalg.lstsq(columns / np.where(scales > 0, scales, 1.0), target, rcond=None)[0]
    factors = np.where(scales > 0, factors / np.where(scales > 0, scales, 1.0), 0.0)
    chosen = np.abs(factors) > 0.5
    left = target - columns @ chosen.astype(float)
    return [int(i) for i in np.flatnonzero(chosen)] if float(np.max(np.abs(left))) < _TOLERANCE * size else []


def _terms(expression: fx.FlatExpression, sign: int = 1) -> list[fx.FlatExpression]:
    """The additive terms of an expression, signs applied."""
    if isinstance(expression, fx.Binary) and expression.operator in ("+", "-"):
        right = _terms(expression.right, sign if expression.operator == "+" else -sign)
        return _terms(expression.left, sign) + right
    if isinstance(expression, fx.Unary) and expression.operator == "-":
        return _terms(expression.operand, -sign)
    return [expression if sign > 0 else fx.Unary("-", expression)]


def _weights(flat: fm.FlatModel, evaluators: list[Evaluator]) -> list[_Weight]:
    """Of each mass and body, and of all of them together where there are several."""
    assert flat.gravity is not None
    items: list[tuple[Item, list[float]]] = [(item, []) for item in (*flat.masses, *flat.bodies)]
    for evaluator in evaluators:
        gravity = evaluator.vector(flat.gravity)
        for item, values in items:
            values.append(-float(gravity @ _moment_of_mass(evaluator, item)))
    weights = [_Weight(item, np.array(values)) for item, values in items]
    if len(weights) > 1:
        weights.append(_Weight(weights[0].item, np.sum([weight.values for weight in weights], axis=0)))
    return weights


def _moment_of_mass(evaluator: Evaluator, item: Item) -> NDArray[np.float64]:
    """m r of a mass or body, shape (3,)."""
    if isinstance(item, fm.PointMass):
        return evaluator.scalar(item.mass) * evaluator.vector(item.position)
    assert isinstance(item, fm.RigidBody)
    origin, axes = evaluator.frame(item.frame)
    com = np.array([evaluator.scalar(component) for component in item.com])
    return np.asarray(evaluator.scalar(item.mass) * (origin + axes @ com))


def _centered(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(values - np.mean(values, axis=0))
