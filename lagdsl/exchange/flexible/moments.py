"""Integrals over the mass of a body of solid elements, whose mass matrix is the same in all three directions.

The integral of u_i v_j over the mass is u_i' m v_j, where m is the block of the mass matrix of one direction. Sources:
A. A. Shabana, Dynamics of Multibody Systems, ch. 5; R. Schwertassek and O. Wallrapp, Dynamik flexibler
Mehrkörpersysteme, ch. 6.
"""

from __future__ import annotations

import numpy as np
from scipy import sparse

from lagdsl.exchange.flexible.body import PERMUTATION, Moments
from lagdsl.exchange.flexible.matrices import Floats, Sparse
from lagdsl.exchange.flexible.refusal import Refused

_SAME = 1e-6
"""Of the largest entry: files have seven digits at least."""


def directional_mass(mass: Sparse) -> Sparse:
    """The block of one direction [nodes, nodes]. Raises Refused, E1215, where directions are mixed or differ."""
    blocks = [[sparse.csr_array(mass[i::3, j::3]) for j in range(3)] for i in range(3)]
    block = blocks[0][0]
    scale = abs(block).max()
    if not scale > 0:
        raise Refused("E1215", None, reason="zero")
    for i in range(3):
        for j in range(3):
            other = blocks[i][j] - block if i == j else blocks[i][j]
            if other.nnz and abs(other).max() > _SAME * scale:
                raise Refused("E1215", None, reason="not the same in all directions")
    return block


def moments(block: Sparse, places: Floats, share: Floats, shapes: Floats, second: Floats) -> Moments:
    """The integrals for nodes at `places` [nodes, 3] with `shapes` [nodes, 3, n]; `share` as in `rigid_motions`.

    `second` [4, 3, n, n] are the integrals of the displacements of second order: of their components, and of these
    times x, y, z.
    """
    count = shapes.shape[2]
    weights = np.asarray(block @ share)
    weighted = np.asarray(block @ places)
    mass = float(share @ weights)
    if not mass > 0:
        raise Refused("E1215", None, reason="not positive")
    rest = places.T @ weighted
    first = np.einsum("ai,ajk->ijk", weighted, shapes)
    flat = shapes.reshape(len(places), -1)
    both = (flat.T @ np.asarray(block @ flat)).reshape(3, count, 3, count).transpose(0, 2, 1, 3)
    together = both + second[1:]
    return Moments(
        mass=mass,
        first=weights @ places,
        S=np.einsum("a,aik->ik", weights, shapes),
        S2=second[0],
        inertia=_inertia(rest),
        inertia1=_inertia(first + first.swapaxes(0, 1)),
        inertia2=_inertia(together + together.swapaxes(0, 1)),
        H=np.einsum("iab,abk->ik", PERMUTATION, first),
        H2=np.einsum("iab,ablk->ilk", PERMUTATION, both),
    )


def _inertia(products: Floats) -> Floats:
    """tr(P) 1 - P of the integrals P of r r' [3, 3, ...]."""
    trace = np.einsum("ii...->...", products)
    return np.asarray(np.multiply.outer(np.eye(3), trace) - products)
