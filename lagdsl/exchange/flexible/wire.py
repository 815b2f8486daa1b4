"""The edges of a body of solid elements: where two faces of its surface meet at an angle."""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict

import numpy as np

from lagdsl.exchange.flexible.body import Floats, Wire
from lagdsl.exchange.flexible.deck import Deck
from lagdsl.exchange.flexible.elements import FACES

MOST_SEGMENTS = 48
"""Lines that a page draws of one body."""
_SHARP = np.cos(np.radians(30))


def wire(deck: Deck, order: dict[int, int], places: Floats, shapes: Floats) -> Wire | None:
    """Lines along the sharp edges of the surface; None for a body that has none, as a ball."""
    edges = _thinned(_sharp_edges(deck, order, places))
    if not edges:
        return None
    used = sorted({node for edge in edges for node in edge})
    position = {node: k for k, node in enumerate(used)}
    pairs = tuple((position[a], position[b]) for a, b in edges)
    return Wire(points=places[used], shapes=shapes[used], edges=pairs)


def _sharp_edges(deck: Deck, order: dict[int, int], places: Floats) -> list[tuple[int, int]]:
    faces: dict[frozenset[int], tuple[int, ...]] = {}
    times: Counter[frozenset[int]] = Counter()
    for element in deck.elements.values():
        for corners in FACES[element.kind]:
            face = tuple(order[element.nodes[k]] for k in corners)
            faces[frozenset(face)] = face
            times[frozenset(face)] += 1
    normals: dict[tuple[int, int], list[Floats]] = defaultdict(list)
    for key, face in faces.items():
        if times[key] > 1:
            continue
        a, b, c = (places[face[k]] for k in (0, 1, 2))
        normal = np.cross(b - a, c - a)
        normal /= max(float(np.linalg.norm(normal)), np.finfo(float).tiny)
        for start, end in zip(face, (*face[1:], face[0]), strict=True):
            normals[min(start, end), max(start, end)].append(normal)
    return sorted(edge for edge, found in normals.items() if len(found) != 2 or float(found[0] @ found[1]) < _SHARP)


def _thinned(edges: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Chains of edges with as many nodes left out as brings them to MOST_SEGMENTS; the ends of chains stay."""
    chains = _chains(edges)
    step = 1
    while step < len(edges) and sum(-(-(len(chain) - 1) // step) for chain in chains) > MOST_SEGMENTS:
        step += 1
    found = []
    for chain in chains:
        kept = [*chain[:-1:step], chain[-1]]
        found += list(itertools.pairwise(kept))
    return found[: 4 * MOST_SEGMENTS]


def _chains(edges: list[tuple[int, int]]) -> list[list[int]]:
    """Runs of edges between nodes where not exactly two edges meet; closed ones begin and end at their first node."""
    beside: dict[int, list[int]] = defaultdict(list)
    for a, b in edges:
        beside[a].append(b)
        beside[b].append(a)
    left = {frozenset(edge) for edge in edges}
    starts = [node for node in sorted(beside) if len(beside[node]) != 2]
    found = []
    for start in [*starts, *sorted(beside)]:
        for first in beside[start]:
            if frozenset((start, first)) not in left:
                continue
            chain = [start, first]
            left.remove(frozenset((start, first)))
            while len(beside[chain[-1]]) == 2:
                following = [node for node in beside[chain[-1]] if frozenset((chain[-1], node)) in left]
                if not following:
                    break
                left.remove(frozenset((chain[-1], following[0])))
                chain.append(following[0])
            found.append(chain)
    return found


def skeleton(points: Floats) -> tuple[tuple[int, int], ...]:
    """The shortest tree of lines between all points: R. C. Prim, Bell Syst. Tech. J. 36 (1957) 1389."""
    nearest = np.zeros(len(points), dtype=np.int64)
    distances = np.linalg.norm(points - points[0], axis=1)
    distances[0] = np.inf
    found = []
    for _ in range(len(points) - 1):
        new = int(np.argmin(distances))
        found.append((int(nearest[new]), new))
        others = np.linalg.norm(points - points[new], axis=1)
        closer = (others < distances) & np.isfinite(distances)
        nearest[closer] = new
        distances[closer] = others[closer]
        distances[new] = np.inf
    return tuple(found)
