"""Counts of the lecture: d = 3N - k for particles, 6B - k for bodies, or both; Gruebler's for planar mechanisms."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.derivation.structure.names import located
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel


@record(kw_only=True)
class Count:
    """N particles and B bodies have 3N + 6B coordinates in space; k conditions, stated or built into the choice of
    coordinates, leave `freedom`."""

    particles: int
    bodies: int
    freedom: int

    @property
    def conditions(self) -> int:
        return 3 * self.particles + 6 * self.bodies - self.freedom


def count(flat: FlatModel, freedom: int) -> Count | None:
    """None where inertia stands in energies written by hand, or where the masses have fewer freedoms than that."""
    particles, bodies = len(flat.masses), len(flat.bodies)
    line = Count(particles=particles, bodies=bodies, freedom=freedom)
    by_hand = any(term.kind in ("kinetic", "lagrangian") for term in flat.energies)
    return line if particles + bodies and line.conditions >= 0 and not by_hand else None


def count_text(line: Count) -> str:
    """`d = 3N - k = 3*2 - 5 = 1`"""
    symbols, numbers = [], []
    if line.particles:
        symbols.append("3N")
        numbers.append(f"3*{line.particles}")
    if line.bodies:
        symbols.append("6B")
        numbers.append(f"6*{line.bodies}")
    return f"d = {' + '.join(symbols)} - k = {' + '.join(numbers)} - {line.conditions} = {line.freedom}"


def balance_text(coordinates: int, rank: int | None, forces: int = 0) -> str:
    """`3 coordinates - 2 independent constraints = 1 degree of freedom`; a `rank` of None leaves constraints out.
    `forces` are balances of forces along directions without inertia."""
    held = "" if rank is None else f" - {counted(rank, 'independent constraint')}"
    held += f" - {forces} balance{'' if forces == 1 else 's'} of forces" if forces else ""
    left = coordinates - (rank or 0) - forces
    return f"{counted(coordinates, 'coordinate')}{held} = {counted(left, 'degree')} of freedom"


def counted(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


_LOWER_PAIRS = ("Revolute", "Prismatic")  # that leave one freedom of three
_PLANE = 3  # equations of a loop in space that hold by themselves where it stays in a plane


def gruebler_text(flat: FlatModel, redundant: Sequence[bool], freedom: int) -> str:
    """`Gruebler in the plane: 3*3 moving links - 2*4 joints = 1`, and what special dimensions add to it; empty where
    joints are others than pins and slides, or no loop is closed, or one of them leaves the plane.

    Every joint of the spanning tree carries one moving link. Source: R. L. Norton, Design of Machinery, 6th ed.,
    section 2.5, equation 2.1.
    """
    links, joints = sum(not joint.cut for joint in flat.joints), len(flat.joints)
    excess: dict[tuple[object, ...], int] = {}
    for item in located(flat):
        closure = item.constraint.closure
        if closure is not None:
            loop = (closure.joint, closure.loop)
            excess[loop] = excess.get(loop, 0) + sum(redundant[row] for row in item.rows)
    plane = bool(excess) and all(number >= _PLANE for number in excess.values())
    if not plane or links + len(excess) != joints or any(joint.kind not in _LOWER_PAIRS for joint in flat.joints):
        return ""
    expected = 3 * links - 2 * joints
    line = f"Gruebler in the plane: 3*{links} moving links - 2*{joints} joints = {expected}"
    return line if expected == freedom else f"{line}; the dimensions of this mechanism make it {freedom}"
