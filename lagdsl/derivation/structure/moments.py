"""Other moments: times, states and inputs that are not those of the start.

Rows may say the same at the start and not later: x = y and x = (1 + t) y.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.model import FlatModel, Input, State

_SEED = 20013
# Distances from the start, as parts of the experiment and of the sizes of states and inputs. Corners of time may lie
# behind the first ones; a mechanism may not reach the last one.
_PARTS = (1e-3, 0.05, 0.6)


@record()
class Moment:
    """A time with states and inputs."""

    t: float
    z: Floats
    u: Floats


def comes_from_outside(flat: FlatModel) -> bool:
    """True if time, an input or a state takes part in a constraint."""
    orders = Dependence(flat)
    moving = {"time", *(item.name for item in (*flat.inputs, *flat.states))}
    return any(not moving.isdisjoint(orders.of_all(constraint.residuals)) for constraint in flat.constraints)


def other_moments(flat: FlatModel, start: Moment) -> list[Moment]:
    """The same ones in every run; none where the constraints are the same at all moments."""
    if not comes_from_outside(flat):
        return []
    length = flat.experiment.stop_time - flat.experiment.start_time
    generator = np.random.default_rng(_SEED)

    def moved(values: Floats, items: Sequence[State | Input], part: float) -> Floats:
        nominals = np.array([abs(item.nominal) if item.nominal else 1.0 for item in items])
        steps: Floats = part * np.maximum(nominals, np.abs(values)) * generator.standard_normal(len(values))
        return values + steps

    return [
        Moment(start.t + part * length, moved(start.z, flat.states, part), moved(start.u, flat.inputs, part))
        for part in _PARTS
    ]
