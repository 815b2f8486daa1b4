"""Contributions of gravity, masses and bodies that are written by hand once more (W0511, W0526).

Terms written by hand and automatic contributions are sampled at random moments and compared as functions up to a
constant: a least-squares fit of the contribution by the terms must leave nothing and use each term either once or not
at all. Loads are compared by their power.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from random import Random

import numpy as np

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Floats, ManyEvaluator, NotEvaluable, Values
from lagdsl.language.flat.probe import probes
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place
from lagdsl.language.semantics.wellformed.moments import kinetic_energies, power_of, weight

_MOST_TERMS = 40  # additive terms that are told apart
_MOST_PLACES = 2000  # evaluations of one mass or body
_FEWEST = 6  # moments
_TOLERANCE = 1e-9
_LONGEST = 40  # characters of a statement in a label


def check_doubled(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """W0511 for potentials and loads that are the weight of a mass, W0526 for its kinetic energy."""
    if flat.gravity is not None and (flat.masses or flat.bodies):
        _compare(flat, _Comparison("W0511", _energies(flat, "potential"), _potentials), sink)
        _compare(flat, _Comparison("W0511", list(_loads(flat, dependence)), _powers), sink)
    if flat.masses or flat.bodies:
        _compare(flat, _Comparison("W0526", _energies(flat, "kinetic"), _kinetics, vary=True), sink)


@record()
class _Term:
    """A term written by hand: its statement, and its values at moments, shape (k,)."""

    item: Item
    value: Callable[[ManyEvaluator], Floats]


@record()
class _Automatic:
    """Contributions of one mass or body at moments, each of shape (k,)."""

    item: Item
    values: tuple[Floats, ...]


@record()
class _Comparison:
    """`vary`: with other parameters, too, so that equal numbers of different things are not taken for one."""

    code: str
    terms: list[_Term]
    automatic: Callable[[fm.FlatModel, ManyEvaluator], list[_Automatic]]
    vary: bool = False


def _compare(flat: fm.FlatModel, comparison: _Comparison, sink: Sink) -> None:
    terms = comparison.terms[:_MOST_TERMS]
    if not terms:
        return
    random, moments = Random(20240229), []
    for moment in probes(flat, min(2 * len(terms) + 8, max(_MOST_PLACES // len(_heavy(flat)), _FEWEST))):
        other = {p.name: p.value * random.uniform(1.0, 1.5) for p in flat.parameters if p.kind == "Real"}
        variables = moment.variables | (other if comparison.vary else {})
        moments.append(Values(variables=variables, rates=moment.rates))
    try:
        evaluator = ManyEvaluator(flat, moments)
        table = np.array([term.value(evaluator) for term in terms]).T
        automatic = comparison.automatic(flat, evaluator)
    except NotEvaluable:
        return
    sound = np.all(np.isfinite(table), axis=1)
    if np.count_nonzero(sound) < _FEWEST:
        return
    table = _centered(table[sound])
    for item, target in _targets(automatic):
        used = _sum_of(table, _centered(target[sound]))
        if used:
            first = terms[used[0]].item
            others = [Label(span) for span in (flat.gravity_span,) if span is not None and comparison.code == "W0511"]
            others += [Label(span) for span in (place(item),) if span is not None and comparison.code == "W0526"]
            sink.report(comparison.code, place(first), *around(first), *others, item=_statement(item))


def _targets(automatic: list[_Automatic]) -> Iterable[tuple[Item, Floats]]:
    """Each contribution along the moments, then the sum of the last ones of all items where there are several."""
    for each in automatic:
        for values in each.values:
            yield each.item, values
    if len(automatic) > 1:
        yield automatic[0].item, np.sum([each.values[-1] for each in automatic], axis=0)


def _statement(item: Item) -> str:
    """The text of an item, cut to a length that fits a label."""
    span = place(item)
    text = "mass" if span is None else " ".join(span.text.rstrip(";").split())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def _sum_of(columns: Floats, target: Floats) -> list[int]:
    """The columns whose sum the target is; empty where it is no such sum."""
    size = float(np.max(np.abs(target), initial=0.0))
    if size == 0.0 or not np.all(np.isfinite(target)):
        return []
    alone = np.max(np.abs(columns - target[:, None]), axis=0) < _TOLERANCE * size
    if np.any(alone):  # terms that differ by a factor cannot be told apart in a fit
        return [int(np.argmax(alone))]
    if len(columns) < columns.shape[1] + 4:
        return []
    scales = np.max(np.abs(columns), axis=0)
    factors = np.linalg.lstsq(columns / np.where(scales > 0, scales, 1.0), target, rcond=None)[0]
    factors = np.where(scales > 0, factors / np.where(scales > 0, scales, 1.0), 0.0)
    chosen = np.abs(factors) > 0.5
    left = target - columns @ chosen.astype(float)
    return [int(i) for i in np.flatnonzero(chosen)] if float(np.max(np.abs(left))) < _TOLERANCE * size else []


def _centered(values: Floats) -> Floats:
    return np.asarray(values - np.mean(values, axis=0))


# ---- terms written by hand -------------------------------------------------------------------------------------------


def _additive(expression: fx.FlatExpression, sign: int = 1) -> list[fx.FlatExpression]:
    """The additive terms of an expression, signs applied."""
    if isinstance(expression, fx.Binary) and expression.operator in ("+", "-"):
        right = _additive(expression.right, sign if expression.operator == "+" else -sign)
        return _additive(expression.left, sign) + right
    if isinstance(expression, fx.Unary) and expression.operator == "-":
        return _additive(expression.operand, -sign)
    return [expression if sign > 0 else fx.Unary("-", expression)]


def _energies(flat: fm.FlatModel, kind: str) -> list[_Term]:
    """Terms of energies of one kind; those of a Lagrangian are T - V."""
    found: list[_Term] = []
    for energy in flat.energies:
        if energy.kind in (kind, "lagrangian"):
            sign = -1 if energy.kind == "lagrangian" and kind == "potential" else 1
            found += [_Term(energy, _scalar(value)) for value in _additive(energy.value, sign)]
    return found


def _scalar(value: fx.FlatExpression) -> Callable[[ManyEvaluator], Floats]:
    return lambda evaluator: evaluator.scalar(value)


def _loads(flat: fm.FlatModel, dependence: Dependence) -> Iterable[_Term]:
    """Terms of the loads that do not depend on rates, states and inputs, as weights do not."""
    given = {item.name for item in (*flat.states, *flat.inputs)}
    for load in flat.loads:
        if isinstance(load, fm.RateForce):
            continue
        value = load.value if isinstance(load, fm.GeneralizedForce) else None
        if isinstance(load, fm.PointForce):
            value = load.force
        if isinstance(load, fm.FrameTorque):
            value = load.torque
        assert value is not None
        for part in _additive(value):
            for axis in range(3) if isinstance(part, fx.Vector) else (0,):
                split = [part.x, part.y, part.z][axis] if isinstance(part, fx.Vector) else part
                for each in _additive(split):
                    needed = dependence.of(each)
                    if any(needed.differentiated()) or any(name in given for name in needed):
                        continue
                    yield _Term(load, power_of(load, _along(axis, each) if isinstance(part, fx.Vector) else each))


def _along(axis: int, value: fx.FlatExpression) -> fx.FlatExpression:
    x, y, z = (value if axis == each else fx.ZERO for each in range(3))
    return fx.Vector(x, y, z)


# ---- automatic contributions -----------------------------------------------------------------------------------------


def _heavy(flat: fm.FlatModel) -> tuple[fm.PointMass | fm.RigidBody, ...]:
    return (*flat.masses, *flat.bodies)


def _potentials(flat: fm.FlatModel, evaluator: ManyEvaluator) -> list[_Automatic]:
    return [_Automatic(item, (-weight(flat, evaluator, item, moving=False),)) for item in _heavy(flat)]


def _powers(flat: fm.FlatModel, evaluator: ManyEvaluator) -> list[_Automatic]:
    return [_Automatic(item, (weight(flat, evaluator, item, moving=True),)) for item in _heavy(flat)]


def _kinetics(flat: fm.FlatModel, evaluator: ManyEvaluator) -> list[_Automatic]:
    return [_Automatic(item, kinetic_energies(evaluator, item)) for item in _heavy(flat)]
