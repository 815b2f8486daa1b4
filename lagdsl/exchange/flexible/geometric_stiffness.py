"""Geometric stiffness of a body of solid elements under unit loads, on its modes.

A load brings stresses, and the stresses s the stiffness: the integral of grad(u_k) s grad(u_l). Source: O. Wallrapp and
R. Schwertassek, Int. J. Numer. Methods Eng. 32 (1991) 1833.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np

from lagdsl.exchange.flexible.deck import Deck
from lagdsl.exchange.flexible.elements import rule
from lagdsl.exchange.flexible.matrices import Floats, Integers
from lagdsl.exchange.flexible.refusal import Refused
from lagdsl.foundation.record import record

_AT_ONCE = 200
"""Elements whose stresses are held in memory together."""


@record(kw_only=True)
class _Group:
    """Elements of one kind: their nodes [elements, nodes of one] as places in the matrices, and constants."""

    kind: str
    reduced: bool
    nodes: Integers
    modulus: Floats
    ratio: Floats


def no_stiffening(deck: Deck) -> str | None:
    """The reason for which a deck does not tell the stresses of its body; None if it does."""
    for number, element in deck.elements.items():
        if rule(element.kind, element.is_reduced) is None:
            return f"stresses of {element.kind} are not computed"
        if number not in deck.elastic:
            return f"element {number} has no isotropic `*ELASTIC` by `*SOLID SECTION`"
    return None


def geometric_stiffness(deck: Deck, order: dict[int, int], places: Floats, shapes: Floats, loaded: Floats) -> Floats:
    """The matrices [loads, n, n] on `shapes` [nodes, 3, n] for the static displacements `loaded` [nodes, 3, loads].
    `order` has the place of each node. Raises Refused, E1210, for an element without volume."""
    total = np.zeros((loaded.shape[2], shapes.shape[2], shapes.shape[2]))
    for group in _groups(deck, order):
        found = rule(group.kind, group.reduced)
        assert found is not None, "internal error: elements without stresses were told before"
        corners = places[group.nodes]
        jacobians = np.einsum("gnj,eni->egij", found.derivatives, corners)
        volumes = np.linalg.det(jacobians) * found.weights
        if not (volumes > 0).all():
            raise Refused(
                "E1210", None, name=deck.file.name, reason="an element has no volume, or its nodes turn the wrong way"
            )
        gradients = np.einsum("gnj,egji->egni", found.derivatives, np.linalg.inv(jacobians))
        slopes = np.einsum("egni,enak->egkai", gradients, shapes[group.nodes])
        strains = np.einsum("egni,enaL->egLai", gradients, loaded[group.nodes])
        stresses = _stress(strains, group) * volumes[:, :, None, None, None]
        pulled = np.einsum("egkai,egLij->egLkaj", slopes, stresses)
        total += np.einsum("egLkaj,eglaj->Lkl", pulled, slopes)
    return 0.5 * (total + total.swapaxes(1, 2))


def _stress(slopes: Floats, group: _Group) -> Floats:
    """Hooke's law of isotropic materials, for gradients [elements, points, loads, 3, 3]."""
    strain = 0.5 * (slopes + slopes.swapaxes(-1, -2))
    shear = (group.modulus / (2 * (1 + group.ratio)))[:, None, None, None, None]
    lame = 2 * shear * (group.ratio / (1 - 2 * group.ratio))[:, None, None, None, None]
    trace = np.einsum("egLii->egL", strain)[..., None, None]
    return np.asarray(2 * shear * strain + lame * trace * np.eye(3))


def _groups(deck: Deck, order: dict[int, int]) -> Iterator[_Group]:
    """Elements of one kind, `_AT_ONCE` at most together."""
    sorted_out: dict[tuple[str, bool], list[int]] = defaultdict(list)
    for number, element in deck.elements.items():
        sorted_out[element.kind, element.is_reduced].append(number)
    for (kind, reduced), numbers in sorted_out.items():
        for first in range(0, len(numbers), _AT_ONCE):
            chosen = numbers[first : first + _AT_ONCE]
            constants = np.array([deck.elastic[number] for number in chosen])
            nodes = np.array([[order[node] for node in deck.elements[number].nodes] for number in chosen])
            yield _Group(kind=kind, reduced=reduced, nodes=nodes, modulus=constants[:, 0], ratio=constants[:, 1])
