"""Pairs of velocities that are another pair, turned in its plane: their congruence costs less than that of two sums.

    x' = c x + s y,   +-y' = c y - s x,   c^2 + s^2 = 1

With W in x', y' equal to [a b; b d] and e = s (a - d) + 2 c b, W in x, y is [a - s e, c e - b; c e - b, d + s e]
(Golub and Van Loan, *Matrix Computations*, 4th ed., section 5.1, uses the same planes for the opposite purpose).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.foundation.record import record


@record(kw_only=True)
class Rotation:
    """`after` = (x', y') from `before` = (x, y); `mirrored`: y' has the opposite sign."""

    after: tuple[int, int]
    before: tuple[int, int]
    cosine: int
    sine: int
    mirrored: bool


def find_rotations(graph: Graph, terms: Mapping[int, Mapping[int, int]]) -> list[Rotation]:
    """Rotations among sums of two products, each with what it multiplies looked through."""
    waiting: dict[tuple[int, int], list[tuple[int, int, int]]] = {}
    found = []
    for node, arguments in terms.items():
        if len(arguments) != 2:
            continue
        factors = sorted(_factored(graph, terms, arguments).items())
        if not factors or not _is_unit_pair(graph, factors[0][1], factors[1][1]):
            continue
        (x, a), (y, b) = factors
        partners = waiting.setdefault((x, y), [])
        for index, (other, c, s) in enumerate(partners):
            turned = a == graph.negate(s) and b == c
            mirrored = a == s and b == graph.negate(c)
            if turned or mirrored:
                partners.pop(index)
                found.append(Rotation(after=(other, node), before=(x, y), cosine=c, sine=s, mirrored=mirrored))
                break
        else:
            partners.append((node, a, b))
    return found


def _factored(graph: Graph, terms: Mapping[int, Mapping[int, int]], sums: Mapping[int, int]) -> dict[int, int]:
    """Coefficients with the products that were summed looked through; empty unless two different factors are left."""
    result: dict[int, int] = {}
    for product, sign in sums.items():
        inner = terms.get(product, {})
        if graph.op[product] is not Op.MULTIPLY or len(inner) != 1:
            return {}
        ((factor, coefficient),) = inner.items()
        if factor in result:
            return {}
        result[factor] = graph.multiply(sign, coefficient)
    return result


def _is_unit_pair(graph: Graph, a: int, b: int) -> bool:
    """True if the two are, up to signs, cosine and sine of the same angle."""
    a = graph.a[a] if graph.op[a] is Op.NEGATE else a
    b = graph.a[b] if graph.op[b] is Op.NEGATE else b
    return {graph.op[a], graph.op[b]} == {Op.COS, Op.SIN} and graph.a[a] == graph.a[b]


class Turns:
    """Rotations in groups of one angle each, which are eliminated together as soon as nothing uses any of them."""

    def __init__(self, rotations: Sequence[Rotation], priority: Mapping[int, tuple[int, int]]) -> None:
        self._priority = priority
        self._rotation = {v: r for r in rotations for v in r.after}
        self._group: dict[int, list[Rotation]] = {}
        groups: dict[tuple[int, int], list[Rotation]] = {}
        for rotation in rotations:
            group = groups.setdefault((rotation.cosine, rotation.sine), [])
            group.append(rotation)
            self._group |= dict.fromkeys(rotation.after, group)
        self.ready: dict[int, None] = {}

    def __contains__(self, variable: int) -> bool:
        return variable in self._group

    def group(self, variable: int) -> list[Rotation]:
        return self._group[variable]

    def release(self, variable: int) -> bool:
        """Nothing uses `variable` any more. True if that holds for its whole group now."""
        self.ready[variable] = None
        members = [v for rotation in self._group[variable] for v in rotation.after]
        if not all(v in self.ready for v in members):
            return False
        for v in members:
            del self.ready[v]
        return True

    def take_some(self) -> Rotation:
        """A pair whose group waits for one that waits for it: turned by itself."""
        waiting = [self._rotation[v] for v in self.ready if v == self._rotation[v].after[0]]
        complete = [r for r in waiting if r.after[1] in self.ready]
        rotation = min(complete, key=lambda r: (self._priority[r.after[0]], r.after))
        self._group[rotation.after[0]].remove(rotation)
        for v in rotation.after:
            del self.ready[v]
        return rotation
