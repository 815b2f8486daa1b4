"""A sparse symmetric matrix of nodes, and the congruences and pivots that shrink it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from lagdsl.algebra.eliminate.rotations import Rotation
from lagdsl.algebra.graph.graph import Graph

Pair: TypeAlias = "tuple[dict[int, int], dict[int, int]]"


class SparseSystem:
    """W of W a = h: rows by variable, only what is not identically zero."""

    def __init__(self, graph: Graph, weights: Mapping[int, Mapping[int, int]]) -> None:
        self.graph = graph
        self.rows: dict[int, dict[int, int]] = {j: {} for j in weights}
        for j, row in weights.items():
            for k, weight in row.items():
                if k <= j:
                    self.add(j, k, weight)

    def pivot(self, j: int) -> int:
        return self.rows.get(j, {}).get(j, self.graph.zero)

    def add(self, j: int, k: int, value: int) -> None:
        """To W_jk and W_kj."""
        if value == self.graph.zero:
            return
        row = self.rows.setdefault(j, {})
        total = self.graph.add(row.get(k, self.graph.zero), value)
        if total == self.graph.zero:
            row.pop(k, None)
            self.rows.setdefault(k, {}).pop(j, None)
            return
        row[k] = total
        self.rows.setdefault(k, {})[j] = total

    def take(self, j: int) -> dict[int, int]:
        """The row of j, removed."""
        row = self.rows.pop(j, {})
        for k in row:
            if k != j and k in self.rows:
                self.rows[k].pop(j, None)
        return row

    # ---- steps -------------------------------------------------------------------------------------------------------

    def substitute(self, j: int, terms: Mapping[int, int]) -> None:
        """Replace a_j by its definition, the sum of `terms`."""
        graph, row = self.graph, self.take(j)
        diagonal = row.pop(j, graph.zero)
        for k, weight in row.items():
            for p, c in terms.items():
                product = graph.multiply(c, weight)
                self.add(p, k, graph.add(product, product) if p == k else product)
        if diagonal != graph.zero:
            arguments = list(terms)
            for position, p in enumerate(arguments):
                scaled = graph.multiply(terms[p], diagonal)
                for k in arguments[: position + 1]:
                    self.add(p, k, graph.multiply(terms[k], scaled))

    def minimize(self, j: int) -> dict[int, int]:
        """Eliminate a_j by its own equation: a_j = u - sum_k y_k a_k; gives the y."""
        graph, row = self.graph, self.take(j)
        inverse = graph.divide(graph.one, row.pop(j))
        others = sorted(row)
        shares = {k: graph.multiply(row[k], inverse) for k in others}
        for position, p in enumerate(others):
            for k in others[: position + 1]:
                self.add(p, k, graph.negate(graph.multiply(row[k], shares[p])))
        return shares

    def rotate(self, rotations: Sequence[Rotation]) -> None:
        """Replace several pairs turned by the same angle by the pairs they come from."""
        rows = [(self.take(r.after[0]), self.take(r.after[1])) for r in rotations]
        inside = dict.fromkeys(v for r in rotations for v in r.after)
        for position, rotation in enumerate(rotations):
            if rotation.mirrored:
                self._mirror(rows, rotations, position)
        for position, rotation in enumerate(rotations):
            self._rotate_outside(rotation, rows[position], inside)
            self._rotate_diagonal(rotation, rows[position])
            for other in range(position):
                self._rotate_block(rotation, rotations[other], rows[other])

    def _mirror(self, rows: Sequence[Pair], rotations: Sequence[Rotation], at: int) -> None:
        """Change the sign of y', so that the pair is turned only."""
        graph, (_, y) = self.graph, rotations[at].after
        own = rows[at][1]
        for k in own:
            if k != y:
                own[k] = graph.negate(own[k])
        for position, pair in enumerate(rows):
            for row in pair if position != at else pair[:1]:
                if y in row:
                    row[y] = graph.negate(row[y])

    def _rotate_outside(self, rotation: Rotation, rows: Pair, inside: Mapping[int, None]) -> None:
        """W of the pair with all other variables."""
        graph, (x, y) = self.graph, rotation.before
        for k in dict.fromkeys((*rows[0], *rows[1])):
            if k not in inside:
                first, second = self._turn_back(rotation, rows[0].get(k, graph.zero), rows[1].get(k, graph.zero))
                self.add(x, k, graph.add(first, first) if k == x else first)
                self.add(y, k, graph.add(second, second) if k == y else second)

    def _turn_back(self, rotation: Rotation, first: int, second: int) -> tuple[int, int]:
        graph, c, s = self.graph, rotation.cosine, rotation.sine
        return (
            graph.subtract(graph.multiply(c, first), graph.multiply(s, second)),
            graph.add(graph.multiply(s, first), graph.multiply(c, second)),
        )

    def _rotate_diagonal(self, rotation: Rotation, rows: Pair) -> None:
        graph, c, s = self.graph, rotation.cosine, rotation.sine
        (x, y), (x_after, y_after) = rotation.before, rotation.after
        a, b, d = (
            rows[0].get(x_after, graph.zero),
            rows[0].get(y_after, graph.zero),
            rows[1].get(y_after, graph.zero),
        )
        difference = graph.subtract(a, d)
        twice = graph.multiply(graph.multiply(graph.constant(2.0), c), b)
        e = graph.add(graph.multiply(s, difference), twice)
        moved = graph.multiply(s, e)
        self.add(x, x, graph.subtract(a, moved))
        self.add(y, y, graph.add(d, moved))
        self.add(x, y, graph.subtract(graph.multiply(c, e), b))

    def _rotate_block(self, one: Rotation, two: Rotation, rows: Pair) -> None:
        """W between two pairs, [p q; r t] with the rows of `one` and the columns of `two`."""
        graph, c, s = self.graph, one.cosine, one.sine
        (x, y), (u, v) = one.before, two.before
        p, q = (row.get(one.after[0], graph.zero) for row in rows)
        r, t = (row.get(one.after[1], graph.zero) for row in rows)
        if p == q == r == t == graph.zero:
            return
        e = graph.add(graph.multiply(s, graph.subtract(p, t)), graph.multiply(c, graph.add(q, r)))
        along, across = graph.multiply(s, e), graph.multiply(c, e)
        self._add_pair(x, u, graph.subtract(p, along))
        self._add_pair(y, v, graph.add(t, along))
        self._add_pair(x, v, graph.subtract(across, r))
        self._add_pair(y, u, graph.subtract(across, q))

    def _add_pair(self, j: int, k: int, value: int) -> None:
        """An element above and below the diagonal; where both variables are the same one, twice."""
        self.add(j, k, self.graph.add(value, value) if j == k else value)
