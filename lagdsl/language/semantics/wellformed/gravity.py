"""Gravity that is forgotten, out of place, or without effect (E0507, W0510, W0514, W0527)."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import ManyEvaluator, NotEvaluable, Values
from lagdsl.language.flat.probe import probes
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place
from lagdsl.language.flat.traversal import postorder
from lagdsl.language.semantics.wellformed.moments import centre, velocity

_MOMENTS = 3
_NOTHING = 1e-9


def check_gravity(flat: fm.FlatModel, dependence: Dependence, sink: Sink, *, sampled: bool = True) -> None:
    """One `gravity` statement, depending on time and parameters, and, where `sampled`, along the motion of a mass."""
    if flat.gravity is None:
        _check_forgotten(flat, sink)
        return
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    positions = [name for name in dependence.of(flat.gravity) if name in moving]
    if positions:
        sink.report("E0507", flat.gravity_span, name=positions[0])
    elif sampled:
        _check_across(flat, sink)
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


def _check_across(flat: fm.FlatModel, sink: Sink) -> None:
    """W0527 where gravity acts along z, and all masses move in the plane z = 0: it changes nothing there.

    A model that moves along x alone is not meant, nor one that asks for reactions, which may hold the weight.
    """
    heavy: list[fm.PointMass | fm.RigidBody] = [*flat.masses, *flat.bodies]
    if not heavy or _asks_reaction(flat):
        return
    try:
        moments = [Values(variables=each.variables, rates=each.rates) for each in probes(flat, _MOMENTS)]
        evaluator = ManyEvaluator(flat, moments)
        fields = evaluator.vector(flat.gravity or fx.ZERO_VECTOR)
        places = np.array([centre(evaluator, item)[2] for item in heavy])
        speeds = np.array([velocity(evaluator, item) for item in heavy])
    except NotEvaluable:
        return
    upright = not np.any(fields[:2]) and np.any(fields[2])
    largest = np.max(np.abs(speeds), axis=(0, 2))
    if upright and not np.any(places) and largest[2] == 0.0 and largest[1] > _NOTHING * np.max(largest):
        sink.report("W0527", flat.gravity_span)


def _asks_reaction(flat: fm.FlatModel) -> bool:
    asked = (node for item in flat.outputs for node in postorder(item.value))
    return any(isinstance(node, fx.FrameReaction | fx.ReactionAlong) for node in asked)
