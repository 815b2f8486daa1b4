"""A body of solid elements from its deck and its matrices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from lagdsl.exchange.flexible.body import Body, Floats, Station, body_of, central
from lagdsl.exchange.flexible.deck import INNER, Deck, unknown
from lagdsl.exchange.flexible.geometric_stiffness import geometric_stiffness, no_stiffening
from lagdsl.exchange.flexible.matrices import Matrices, Sparse
from lagdsl.exchange.flexible.moments import directional_mass, moments
from lagdsl.exchange.flexible.reduction import Interface, Reduction, reduced, rigid_motions
from lagdsl.exchange.flexible.refusal import Refused, end_span
from lagdsl.exchange.flexible.wire import wire

_RIGID = 1e-7
"""Of the forces that stiffnesses of one sign would give: files have seven digits at least."""
_FLAT = 1e-6
"""Of the size of an interface: nodes that are nearer to a line lie on it."""


def solid_body(deck: Deck, matrices: Matrices, names: Sequence[str], modes: int, metre: float) -> Body:
    """The body in SI units, `metre` long is the unit of length; force in N and time in s. The first of the interfaces
    `names` is frame_a, at which it is held. Raises Refused."""
    order = {node: k for k, node in enumerate(matrices.nodes)}
    share = _share(deck, order)
    deck = replace(deck, elastic={key: (modulus / metre**2, ratio) for key, (modulus, ratio) in deck.elastic.items()})
    places = metre * np.array([deck.nodes.get(node, (0.0, 0.0, 0.0)) for node in matrices.nodes])
    interfaces = _interfaces(deck, order, places, names, metre)
    places = places - np.multiply.outer(share, interfaces[0].point)
    interfaces = [replace(each, point=each.point - interfaces[0].point) for each in interfaces]
    stiffness, mass = matrices.stiffness / metre, matrices.mass / metre
    _check_free(stiffness, rigid_motions(places, share), matrices)
    block = directional_mass(mass)
    try:
        small = reduced(stiffness, mass, places, share, interfaces, modes)
    except (np.linalg.LinAlgError, ValueError):  # SciPy: a matrix that is singular, or has numbers that are not finite
        raise Refused("E1213", None) from None
    loads = _unit_loads(mass, places, share, interfaces)
    if no_stiffening(deck) is None:
        moved = small.response(loads).reshape(len(places), 3, -1)
        second = -geometric_stiffness(deck, order, places, small.shapes, moved)
    else:
        second = np.zeros((loads.shape[1], len(small.mass), len(small.mass)))
    about = central(moments(block, places, share, small.shapes, second[:12].reshape(4, 3, *second.shape[1:])))
    stations = _stations(interfaces, small, second[12:].reshape(-1, 3, *second.shape[1:]))
    matrices_of_modes = np.diag(small.mass), np.diag(small.stiffness), np.zeros((len(small.mass), len(small.mass)))
    return body_of(about, *matrices_of_modes, stations, wire(deck, order, places, small.shapes))


def _share(deck: Deck, order: dict[int, int]) -> Floats:
    """1 of the nodes of the deck, 0 of those that CalculiX adds to elements. Raises Refused, E1210, E1212."""
    foreign = [node for node in order if node not in deck.nodes]
    inner = INNER * sum(element.is_incompatible for element in deck.elements.values())
    if foreign and len(foreign) != inner:
        reason = f"it has unknowns of node {foreign[0]}, which the deck does not have"
        raise Refused("E1210", None, name=Path(deck.file.name).name, reason=reason)
    for element in deck.elements.values():
        for node in element.nodes:
            if node not in order:
                raise Refused("E1212", None, node=node, direction=1)
    return np.array([float(node in deck.nodes) for node in order])


def _check_free(stiffness: Sparse, motions: Floats, matrices: Matrices) -> None:
    """Rigid motions take no forces."""
    forces, bound = np.abs(stiffness @ motions), abs(stiffness) @ np.abs(motions)
    if (forces.max(axis=0) > _RIGID * bound.max(axis=0)).any():
        file = matrices.files[-2].source
        reason = "a rigid motion takes forces, so this body is not free"
        raise Refused("E1210", end_span(file), name=Path(file.name).name, reason=reason)


def _interfaces(
    deck: Deck, order: dict[int, int], places: Floats, names: Sequence[str], metre: float
) -> list[Interface]:
    found: list[Interface] = []
    taken: dict[int, str] = {}
    for name in names:
        nodes = deck.node_sets.get(name.upper())
        if nodes is None:
            raise unknown("set of nodes", name, deck.node_sets, None)
        for node in nodes:
            if node not in order:
                raise Refused("E1212", None, node=node, direction=1)
            if node in taken:
                raise Refused("E1216", None, name=name, reason=f"shares node {node} with `{taken[node]}`")
            taken[node] = name
        members = np.array([order[node] for node in nodes], dtype=np.int64)
        own = places[members]
        if len(own) < 3 or _is_flat(own):
            raise Refused("E1216", None, name=name, reason="has no three nodes beside one line")
        reference = deck.nodes.get(deck.reference_nodes.get(name.upper(), 0))
        point = own.mean(axis=0) if reference is None else metre * np.array(reference)
        found.append(Interface(name=name, point=point, members=members))
    return found


def _is_flat(points: Floats) -> bool:
    """True if all points lie on one line."""
    sizes = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return not sizes[1] > _FLAT * sizes[0]


def _unit_loads(mass: Sparse, places: Floats, share: Floats, interfaces: Sequence[Interface]) -> Floats:
    """Loads [unknowns, 12 + 3 p]: forces per mass of 1, x, y and z along each axis; then a force at each interface."""
    count = len(places)
    fields = np.zeros((count, 3, 4, 3))
    for j in range(3):
        fields[:, j, 0, j] = share
        fields[:, j, 1:, j] = places
    loads = [np.asarray(mass @ fields.reshape(3 * count, 12))]
    for interface in interfaces:
        force = np.zeros((count, 3, 3))
        force[interface.members] = _shares(places[interface.members] - interface.point)
        loads.append(force.reshape(3 * count, 3))
    return np.concatenate(loads, axis=1)


def _shares(places: Floats) -> Floats:
    """Forces [nodes, 3, 3] at rigidly tied nodes whose resultant is a unit force at their point, without a torque."""
    motions = rigid_motions(places)
    resultant = np.linalg.solve(motions.T @ motions, np.eye(6)[:, :3])
    return np.asarray(motions @ resultant).reshape(len(places), 3, 3)


def _stations(interfaces: Sequence[Interface], small: Reduction, second: Floats) -> tuple[Station, ...]:
    return tuple(
        Station(name=interface.name, place=interface.point, shape=motion[:3], turn=motion[3:], shape2=bent)
        for interface, motion, bent in zip(interfaces, small.motions, second, strict=True)
    )
