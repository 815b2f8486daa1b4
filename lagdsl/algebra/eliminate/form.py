"""The acceleration form: inertia and forces of velocities, before anything is expressed by the coordinates.

    sum_j delta_v_j (sum_k W_jk a_k - h_j) = 0,   v_j = sum_k c_jk v_k

for all variations of the rates. The variables v are nodes of the graph that are linear in the rates qd; their
definitions need not be written down, they are the expressions of the nodes. Gauss's principle in Gibbs's and Appell's
form (Pars, *A Treatise on Analytical Dynamics*, 1965, ch. 12), kept sparse.
"""

from __future__ import annotations

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op


class NotApplicable(Exception):  # noqa: N818  it is a fact about a model, no mistake
    """The form does not apply to this model: its equations have to be solved as a dense system."""


class AccelerationForm:
    """Weights W and forces h by velocity, collected contribution by contribution; signs move from nodes to weights.

    A velocity that does not depend on the rates is prescribed: it varies with none of them and contributes nothing.
    """

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.weights: dict[int, dict[int, int]] = {}
        self.forces: dict[int, int] = {}

    def add_square(self, velocity: int, weight: int) -> None:
        """W_jj of 1/2 W_jj v_j^2."""
        j, _ = self._variable(velocity)
        if j >= 0:
            self._add(j, j, weight)

    def add_product(self, velocity: int, other: int, weight: int) -> None:
        """W_jk and W_kj of W_jk v_j v_k; the two may turn out to be the same velocity."""
        graph = self.graph
        j, negative = self._variable(velocity)
        k, opposite = self._variable(other)
        if j < 0 or k < 0:
            return
        if negative != opposite:
            weight = graph.negate(weight)
        self._add(j, k, graph.add(weight, weight) if j == k else weight)

    def _add(self, j: int, k: int, weight: int) -> None:
        row, column = self.weights.setdefault(j, {}), self.weights.setdefault(k, {})
        row[k] = column[j] = self.graph.add(row.get(k, self.graph.zero), weight)

    def add_force(self, velocity: int, force: int) -> None:
        j, negative = self._variable(velocity)
        if j >= 0:
            known = self.forces.get(j, self.graph.zero)
            self.forces[j] = self.graph.subtract(known, force) if negative else self.graph.add(known, force)

    def _variable(self, velocity: int) -> tuple[int, bool]:
        """The node without its sign, -1 where it does not depend on the rates; and whether the sign was negative."""
        graph = self.graph
        negative = graph.op[velocity] is Op.NEGATE
        node = graph.a[velocity] if negative else velocity
        return (node if graph.depends(node, Group.QD) else -1), negative
