"""The machine where its motion starts: positions of masses, and how they change with one coordinate at a time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from lagdsl.derivation.scene.drawings import mass_centre
from lagdsl.derivation.scene.machine import number, vector
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation, compile_flat

_NONE: Mapping[str, float] = {}


@dataclass(frozen=True)
class Pose:
    """`values` of coordinates and inputs by name [SI]."""

    flat: FlatModel
    values: Mapping[str, float]

    def at(self, coordinate: str = "", moved: Mapping[str, float] = _NONE) -> Evaluator:
        """With other values of those that are `moved`; a coordinate has the rate 1, everything else rests."""
        values = {**self.values, **moved}
        rests = ("time", *values, *(state.name for state in self.flat.states))
        return Evaluator(self.flat, Values(variables=values, rates={name: float(name == coordinate) for name in rests}))

    def vector(self, expression: fx.FlatExpression) -> Floats:
        """Components (3,) [SI]; nan where there is no finite value."""
        return vector(self.at(), expression)

    @cached_property
    def elements(self) -> tuple[fx.FlatExpression, ...]:
        """Positions of masses, then of the mass centres of bodies."""
        return (*(mass.position for mass in self.flat.masses), *map(mass_centre, self.flat.bodies))

    @cached_property
    def places(self) -> list[tuple[int, Floats]]:
        """Of the elements, by their numbers, that have one."""
        found = enumerate(map(self.vector, self.elements))
        return [(number, place) for number, place in found if np.isfinite(place).all()]

    def moved(self, coordinate: str) -> list[tuple[int, Floats]]:
        """Elements that a coordinate moves, with the derivatives (3,) of their places."""
        at = self.at(coordinate)
        rates = ((number, vector(at, fx.Derivative(each))) for number, each in enumerate(self.elements))
        return [(number, rate) for number, rate in rates if np.linalg.norm(rate) > 1e-9]


def pose(flat: FlatModel, compilation: Compilation | None = None) -> Pose | None:
    """At the start values, with constraints at the nearest consistent ones; None where there is no start.

    The latter are found with `compilation`, of a model with the same coordinates and constraints, if there is one."""
    own = Evaluator(flat, Values())
    values = {item.name: number(own, item.start) for item in flat.coordinates}
    values |= {item.name: number(own, item.default) for item in flat.inputs}
    if np.isfinite([*values.values()]).all() and (flat.constraints or flat.initial_equations):
        found = _consistent(flat, compilation)
        if found is None:
            return None
        values |= found
    return Pose(flat, values) if np.isfinite([*values.values()]).all() else None


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
