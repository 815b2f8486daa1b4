"""The data of ModalBody from Standard Input Data.

The invariants are those of R. Schwertassek and O. Wallrapp, Dynamik flexibler Mehrkörpersysteme, ch. 6: momentum Ct,
angular momentum Cr, inertia J, and Oe, the force on each mode by the squares of the angular velocity, which is half of
the derivative of the inertia, with its sign changed. Geometric stiffening is in the derivatives of Ct, Cr, Oe and phi.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from lagdsl.exchange.flexible.body import Body, Floats, Moments, Station, Wire, body_of, central
from lagdsl.exchange.flexible.deck import unknown
from lagdsl.exchange.flexible.keywords import LONGEST
from lagdsl.exchange.flexible.refusal import Refused, end_span
from lagdsl.exchange.flexible.sid import Sid, Taylor
from lagdsl.exchange.flexible.wire import MOST_SEGMENTS, skeleton

_SQUARES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
"""Products of angular velocities in the columns of Oe."""
_CONTRADICTION = 0.01
"""Of the largest element: all integrals come from the same masses, and differ by rounding."""


def sid_body(sid: Sid, names: Sequence[str], metre: float) -> Body:
    """The body in SI units, `metre` long is the unit of length of the file. `names` are numbers of nodes; the first is
    frame_a. Raises Refused."""
    matrix = {name: _needed(sid, sid.matrices, name, "") for name in ("mdCM", "J", "Ct", "Cr", "Me", "Ke")}
    if not (sid.mass > 0 and _is_definite(matrix["Me"].m0)):
        raise Refused("E1215", None, reason="not positive definite")
    if not _is_definite(matrix["Ke"].m0):
        raise Refused("E1213", None)
    about = _moments(sid, matrix, metre)
    damping = sid.matrices.get("De")
    stations = {number: _station(sid, number, metre) for number in sid.nodes}
    zero = np.zeros((sid.modes, sid.modes))
    return body_of(
        about,
        matrix["Me"].m0 / metre,
        matrix["Ke"].m0 / metre,
        zero if damping is None else damping.m0 / metre,
        tuple(_chosen(stations, name) for name in names),
        _wire(list(stations.values())),
    )


def no_second_order(sid: Sid) -> str | None:
    """The reason for which a file does not tell the displacements of second order; None if it does."""
    for name in ("Ct", "Oe"):
        if name not in sid.matrices or sid.matrices[name].m1 is None:
            return f"{name} has no derivatives by the modes"
    return None


def has_negative_energy(body: Body) -> bool:
    """True if the body has a negative kinetic energy in a motion, about its mass center, which moves with it: integrals
    that contradict each other, as some programs write them, do not come from one mass."""
    whole = np.block([[body.inertia, body.H], [body.H.T, body.M - body.S.T @ body.S / body.mass]])
    largest = np.concatenate([np.full(3, np.abs(body.inertia).max()), np.diag(body.M)])
    sizes = np.sqrt(np.where(largest > 0.0, largest, 1.0))
    scaled = whole / np.outer(sizes, sizes)
    return bool(np.isfinite(scaled).all() and np.linalg.eigvalsh(scaled)[0] < -_CONTRADICTION)


def _needed(sid: Sid, matrices: dict[str, Taylor], name: str, owner: str) -> Taylor:
    if name not in matrices:
        raise Refused("E1203", None, name=sid.file.name, what=f"{owner}{name}")
    return matrices[name]


def _is_definite(matrix: Floats) -> bool:
    """True of a symmetric matrix whose eigenvalues are positive."""
    scale = float(np.abs(matrix).max())
    if not scale > 0 or np.abs(matrix - matrix.T).max() > _CONTRADICTION * scale:
        return False
    return bool(np.linalg.eigvalsh(matrix)[0] > 0)


def _moments(sid: Sid, matrix: dict[str, Taylor], metre: float) -> Moments:
    """The integrals about the mass center. Amplitudes are lengths of the file, so that shapes keep their numbers. A
    file without derivatives of Cr or Oe tells no terms of second order, and there are none about the mass center."""
    count = sid.modes
    half = sid.matrices.get("Oe")
    by_rates = None if half is None else _tensor(half.m0)
    written = matrix["J"].m1
    first = written.transpose(0, 2, 1) if written is not None else by_rates
    if first is None:
        raise Refused("E1203", None, name=sid.file.name, what="derivative of J")
    if by_rates is not None and np.abs(first - by_rates).max() > _CONTRADICTION * np.abs(first).max():
        reason = "the derivatives of J and the forces Oe contradict each other"
        raise Refused("E1210", end_span(sid.file), name=Path(sid.file.name).name, reason=reason)
    momentum, angular = matrix["Ct"].m1, matrix["Cr"].m1
    squares = None if half is None or half.m1 is None else half.m1
    about = central(
        Moments(
            mass=sid.mass / metre,
            first=matrix["mdCM"].m0[:, 0],
            S=matrix["Ct"].m0.T / metre,
            S2=np.zeros((3, count, count)) if momentum is None else momentum.transpose(2, 1, 0) / metre**2,
            inertia=matrix["J"].m0 * metre,
            inertia1=first,
            inertia2=np.zeros((3, 3, count, count)) if squares is None else _tensor(squares) / metre,
            H=matrix["Cr"].m0.T,
            H2=np.zeros((3, count, count)) if angular is None else angular.transpose(2, 1, 0) / metre,
        )
    )
    if squares is None:
        about = replace(about, inertia2=np.zeros_like(about.inertia2))
    return about if angular is not None else replace(about, H2=np.zeros_like(about.H2))


def _tensor(squares: Floats) -> Floats:
    """Derivatives of the inertia tensor [3, 3, ...] from forces [..., 6] by products of angular velocities."""
    tensor = np.zeros((3, 3, *squares.shape[:-1]))
    for column, (i, j) in enumerate(_SQUARES):
        tensor[i, j] = tensor[j, i] = -(2 if i == j else 1) * squares[..., column]
    return tensor


def _station(sid: Sid, number: int, metre: float) -> Station:
    owner = f"node {number}: "
    origin, phi, psi = (_needed(sid, sid.nodes[number], name, owner) for name in ("origin", "phi", "psi"))
    axes = sid.nodes[number].get("AP")
    if axes is not None and np.abs(axes.m0 - np.eye(3)).max() > _CONTRADICTION:
        reason = f"node {number} has axes of its own, AP, which the import does not read"
        raise Refused("E1210", end_span(sid.file), name=Path(sid.file.name).name, reason=reason)
    bent = np.zeros((3, sid.modes, sid.modes)) if phi.m1 is None else phi.m1.transpose(0, 2, 1) / metre
    return Station(
        name=str(number),
        place=origin.m0[:, 0] * metre,
        shape=phi.m0,
        turn=psi.m0 / metre,
        shape2=0.5 * (bent + bent.swapaxes(1, 2)),
    )


def _chosen(stations: dict[int, Station], name: str) -> Station:
    number = int(name) if name.isascii() and name.isdigit() and len(name) <= LONGEST else 0
    if number not in stations:
        raise unknown("node", name, [str(each) for each in stations], None)
    return stations[number]


def _wire(stations: list[Station]) -> Wire | None:
    """A tree of lines between nodes; of many nodes a part."""
    drawn = stations[:: max(1, -(-len(stations) // MOST_SEGMENTS))]
    if len(drawn) < 2:
        return None
    points = np.array([each.place for each in drawn])
    return Wire(points=points, shapes=np.array([each.shape for each in drawn]), edges=skeleton(points))
