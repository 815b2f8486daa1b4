"""Impacts: rates jump so that momentum is balanced in the whole mechanism.

    M (v+ - v-) = Jc' p + J' P,   J v+ + b = 0,   0 <= p, Jc v+ + e Jc v- >= 0, one of the two zero for each contact

(Pfeiffer, Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, ch. 8; Newton's law in their formulation as a
linear complementarity problem). Its matrix is symmetric and positive semidefinite, so that the problem is that of
non-negative least squares (Lawson, Hanson, *Solving Least Squares Problems*, 1974, ch. 23).
"""

from __future__ import annotations

import numpy as np

from lagdsl.backends.python.support.linear import factorize
from lagdsl.mechanics.rank import Floats


def collide(
    mass: Floats, jacobian: Floats, rank: int, rates: Floats, rows: Floats, speeds: Floats, restitution: Floats
) -> Floats:
    """v+ (nq,) from v-: `rows` (k, nq) are dgap/dq of the contacts that take part, `speeds` (k,) their rates of gap.

    `jacobian` are the bilateral rows, which `rates` satisfy already.
    """
    from scipy.optimize import nnls

    factors, _ = factorize(mass, jacobian, rank)
    response, _ = factors.solve(rows.T, np.zeros((len(jacobian), len(rows))))
    compliance = rows @ response
    values, vectors = np.linalg.eigh(0.5 * (compliance + compliance.T))
    large = values > 1e-13 * max(float(values[-1]), 0.0)
    root = np.sqrt(values[large])[:, None] * vectors[:, large].T
    target = (vectors[:, large] / np.sqrt(values[large])).T @ ((1.0 + restitution) * speeds)
    impulses, _ = nnls(root, -target)
    return np.asarray(rates + response @ impulses)
