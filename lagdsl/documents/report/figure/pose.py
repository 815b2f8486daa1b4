"""The machine where its motion starts: positions of masses, and how they change with one coordinate at a time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from lagdsl.derivation.scene.drawings import mass_centre
from lagdsl.derivation.scene.machine import number, vector
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation, compile_flat

_NONE: Mapping[str, float] = {}


@dataclass(frozen=True)
class Pose:
    """`carriers` are the positions of masses, then of the mass centres of bodies, as expressions."""

    flat: FlatModel
    values: Mapping[str, float]
    carriers: tuple[fx.FlatExpression, ...]

    def vector(self, expression: fx.FlatExpression, moved: Mapping[str, float] = _NONE) -> Floats:
        """Components (3,) [SI]; nan where there is no finite value."""
        return vector(Evaluator(self.flat, Values(variables={**self.values, **moved})), expression)

    def scalar(self, expression: fx.FlatExpression) -> float:
        """In SI units; nan where there is no value."""
        return number(Evaluator(self.flat, Values(variables=self.values)), expression)

    def has(self, expression: fx.FlatExpression) -> bool:
        """Does a vector have a value?"""
        return bool(np.isfinite(self.vector(expression)).all())

    def along(self, expression: fx.FlatExpression, coordinate: str, by: float) -> Floats:
        """Place with one coordinate changed `by` so much, the others held."""
        return self.vector(expression, {coordinate: self.values[coordinate] + by})

    def rate(self, expression: fx.FlatExpression, coordinate: str) -> Floats:
        """Derivative of a place by a coordinate."""
        return vector(self._rate(coordinate), fx.Derivative(expression))

    def spin(self, frame: str, coordinate: str) -> Floats:
        """Derivative (3,) of the rotation of a frame by a coordinate."""
        return vector(self._rate(coordinate), fx.AngularVelocity(frame))

    def _rate(self, coordinate: str) -> Evaluator:
        """The coordinate has the rate 1, everything else rests."""
        rests = ("time", *self.values, *(state.name for state in self.flat.states))
        rates = {**dict.fromkeys(rests, 0.0), coordinate: 1.0}
        return Evaluator(self.flat, Values(variables=self.values, rates=rates))


def pose(flat: FlatModel, compilation: Compilation | None = None) -> Pose | None:
    """At the start values, with constraints at the nearest consistent ones; None where there is no start.

    The latter are found with `compilation`, of a model with the same coordinates and constraints, if there is one."""
    own = Evaluator(flat, Values())
    try:
        values = {item.name: own.scalar(item.start) for item in flat.coordinates}
        values |= {item.name: own.scalar(item.default) for item in flat.inputs}
    except NotEvaluable:
        return None
    if flat.constraints or flat.initial_equations:
        found = _consistent(flat, compilation)
        if found is None:
            return None
        values |= found
    if not all(np.isfinite(value) for value in values.values()):
        return None
    return Pose(flat, values, (*(mass.position for mass in flat.masses), *map(mass_centre, flat.bodies)))


def _consistent(flat: FlatModel, compilation: Compilation | None) -> dict[str, float] | None:
    from lagdsl.engines.runtime.engines.selection import engine_of
    from lagdsl.motion.simulate.initialize import initial_state

    try:
        made = compilation or compile_flat(flat, Sink())
        if made is None:
            return None
        start = initial_state(made.flat, engine_of(made.program))
    except CompilationFailed:
        return None
    return dict(zip((item.name for item in made.flat.coordinates), start.q.tolist(), strict=True))
