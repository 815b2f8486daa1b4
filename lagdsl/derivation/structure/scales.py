"""Scales of accuracy: groups, natural sizes and largest scales of the state (lag/methods/accuracy.h).

A number is as accurate as the tolerance times its scale, which is the largest magnitude seen so far among the numbers
of the same group (coordinates of one dimension that the equations couple, their rates, one state), at least 1e-4 of the
natural size, and for angles at most 1: an angle that has turned a thousand times still enters through its sine.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.derivation.structure.points import groups, natural_sizes
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record()
class Scales:
    """`groups` are whole numbers, `sizes` natural sizes, `caps` the largest scales: (2 nq + nz,) each; `sizes` with the
    leading axes of the start values."""

    groups: Floats
    sizes: Floats
    caps: Floats


def scales_of(flat: FlatModel, components: Sequence[int], q: Floats) -> Scales:
    """q (..., nq): the start values of the coordinates; `components` those of the layout."""
    n = len(flat.coordinates)
    alike = groups(flat.coordinates, components)
    first = len(alike)
    group = np.zeros(n)
    for number, members in enumerate(alike):
        group[members] = number
    sizes = natural_sizes(flat.coordinates, components, q)
    nominals = np.array([abs(s.nominal) if s.nominal else 1.0 for s in flat.states])
    states = np.broadcast_to(nominals, (*sizes.shape[:-1], len(nominals)))
    angles = np.array([c.dimension.is_dimensionless for c in flat.coordinates], dtype=bool)
    return Scales(
        groups=np.concatenate([group, group + first, 2.0 * first + np.arange(len(flat.states))]),
        sizes=np.concatenate([sizes, sizes, states], axis=-1),
        caps=np.concatenate([np.where(angles, 1.0, np.inf), np.full(n + len(flat.states), np.inf)]),
    )
