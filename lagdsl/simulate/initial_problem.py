"""What is asked of the initial state: starts with weights, conditions, and where they were written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_points import SEED, Geometry, geometry
from lagdsl.runtime.engine import Engine

Flags = NDArray[np.bool_]

# An explicitly written start weighs so much more than one that was left to its default (language reference, section
# 5).
EXPLICIT_WEIGHT = 100.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """Starts of coordinates and rates as arrays in layout order; `space` holds the constraints and the start
    values. `seed` chooses the further beginnings of searches; results must not depend on it."""

    flat: FlatModel
    engine: Engine
    space: Geometry
    explicit: Flags
    fixed: Flags
    rate_explicit: Flags
    rate_fixed: Flags
    seed: int

    @property
    def widths(self) -> Floats:
        """1/sqrt(weight) of each coordinate: its natural size, a tenth of it where the start is explicit."""
        return np.where(self.explicit, self.space.sizes / np.sqrt(EXPLICIT_WEIGHT), self.space.sizes)


def problem(
    flat: FlatModel,
    engine: Engine,
    p: Floats,
    *,
    t0: float | None,
    u: Floats | None,
    start: Mapping[str, float],
    sink: Sink,
    seed: int = SEED,
) -> Problem:
    """Starts from the model and from `start` (coordinate, `der(coordinate)` or state, in SI units); these count as
    explicit."""
    space = geometry(flat, engine, p, seed)
    if t0 is not None:
        space = replace(space, t=t0)
    if u is not None:
        space = replace(space, u=u)
    q, qd, z = space.q.copy(), space.qd.copy(), space.z.copy()
    coordinates = {c.name: index for index, c in enumerate(flat.coordinates)}
    states = {s.name: index for index, s in enumerate(flat.states)}
    explicit = np.array([c.start_explicit for c in flat.coordinates], dtype=bool)
    rate_explicit = np.array([c.rate_start_explicit for c in flat.coordinates], dtype=bool)
    for name, value in start.items():
        rate_of = name[4:-1] if name.startswith("der(") and name.endswith(")") else None
        if name in coordinates:
            q[coordinates[name]], explicit[coordinates[name]] = value, True
        elif rate_of is not None and rate_of in coordinates:
            qd[coordinates[rate_of]], rate_explicit[coordinates[rate_of]] = value, True
        elif name in states:
            z[states[name]] = value
        else:
            known = ", ".join([*coordinates, *(f"der({c})" for c in coordinates), *states])
            sink.report("E0805", None, name=name, known=known)
    return Problem(
        flat=flat,
        engine=engine,
        space=replace(space, q=q, qd=qd, z=z),
        explicit=explicit,
        fixed=np.array([c.fixed for c in flat.coordinates], dtype=bool),
        rate_explicit=rate_explicit,
        rate_fixed=np.array([c.rate_fixed for c in flat.coordinates], dtype=bool),
        seed=seed,
    )
