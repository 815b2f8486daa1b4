"""Joints that can move without kinetic energy: nothing determines their acceleration.

The mass matrix along the motions that mimics, equalities and closures leave free is singular at every state; the
compiler asks the same of the model (`structure/inertia.py`). Each coordinate has a twist: an angular velocity,
and the velocity of a point. Velocities of mass centers follow from it, so the energy is a sum of squares: the moment of
a point on an axis is zero up to the square of a rounding error.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

import numpy as np

from lagdsl.exchange.robots.description import Equality, Joint, Link, Tendon
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.inertia import tensor_of
from lagdsl.exchange.robots.tree import WORLD, leader_of
from lagdsl.exchange.robots.turns import place_of, turn_about
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_STATES = 2
_TOLERANCE = 1e-12  # inertia along a free motion, of the largest, that still counts: the bound of the compiler
_NOTHING = 1e-3  # share of a motion below which a joint does not take part in it
_ALONE = 0.999


@record()
class Tree:
    """Links on a root by joints, and what ties them."""

    root: str
    links: list[Link]
    joints: list[Joint]
    closures: list[Joint]
    equalities: list[Equality]
    tendons: list[Tendon]


def idle_as_rigid(tree: Tree, findings: Findings) -> list[Joint]:
    """The joints, those that can move without kinetic energy as rigid ones; E1012 for each that imitates no other."""
    joints = {joint.name: joint for joint in tree.joints}
    rigid: dict[str, None] = {}
    while (found := _idle(tree, rigid)) and not set(found) <= rigid.keys():
        rigid |= dict.fromkeys(found)
    for name in rigid:
        if joints[name].mimic is None:
            instead = "the joint, and what imitates it, is written as a rigid one"
            findings.error("E1012", joints[name].span, name=name, instead=instead)
    return [replace(each, kind="fixed", mimic=None) if each.name in rigid else each for each in tree.joints]


def _idle(tree: Tree, rigid: dict[str, None]) -> list[str]:
    """Joints that move alone without energy, or else the one with the largest part in such a motion, with those that
    imitate them."""
    probes = [_Probe(tree, rigid, np.random.default_rng(seed)) for seed in range(_STATES)]
    names = probes[0].names
    if not names:
        return []
    shares = np.min([np.sqrt(np.abs(np.diag(probe.massless()))) for probe in probes], axis=0)
    if float(np.max(shares)) < _NOTHING:
        return []
    of = {joint.name: joint for joint in tree.joints}
    alone = [names[k] for k in np.flatnonzero(shares > _ALONE)] or [names[int(np.argmax(shares))]]
    leaders = {leader_of(of[name], of).name for name in alone}
    return [joint.name for joint in tree.joints if joint.kind != "fixed" and leader_of(joint, of).name in leaders]


class _Probe:
    """A random state: places of links, twists of joints by columns, with the names of their joints."""

    def __init__(self, tree: Tree, rigid: dict[str, None], random: np.random.Generator) -> None:
        self.tree = tree
        self.names: list[str] = []
        self.places: dict[str, Floats] = {tree.root: np.eye(4), WORLD: np.eye(4)}
        self.moved_by: dict[str, list[int]] = {tree.root: [], WORLD: []}
        twists: list[Floats] = []
        for joint in _outward(tree):
            before = self.places[joint.parent] @ place_of(joint.before)
            kind_is_rigid = joint.kind == "fixed" or joint.name in rigid
            columns, motion = ([], np.eye(4)) if kind_is_rigid else _motion(joint, before, random)
            first = len(twists)
            twists += columns
            self.names += [joint.name] * len(columns)
            self.moved_by[joint.child] = [*self.moved_by[joint.parent], *range(first, len(twists))]
            self.places[joint.child] = before @ motion @ place_of(joint.after)
        self.twists = np.array(twists).reshape(-1, 9)

    def massless(self) -> Floats:
        """The projector (n, n) onto the free motions without kinetic energy, in coordinates that are scaled by their
        inertia."""
        mass = self._mass()
        diagonal = np.sqrt(np.abs(np.diag(mass)))
        tied = np.max(np.where(mass != 0.0, diagonal, 0.0), axis=1)
        heavy = np.where(diagonal > 1e-9 * tied, diagonal, 0.0)
        least = float(np.min(heavy[heavy > 0.0], initial=np.inf))
        scale = 1.0 / np.where(heavy > 0.0, heavy, least if np.isfinite(least) else 1.0)
        rows = self._rows() * scale
        free = _complement(rows.T) if len(rows) else np.eye(len(mass))
        values, directions = np.linalg.eigh(free.T @ ((mass * scale[:, None]) * scale) @ free)
        top = float(np.max(np.abs(values), initial=0.0))
        empty = free @ directions[:, np.abs(values) <= _TOLERANCE * top] if top > 0.0 else free
        return np.asarray(empty @ empty.T)

    def _mass(self) -> Floats:
        """The mass matrix of links and rotors."""
        rotors = {joint.name: joint.passive.armature for joint in self.tree.joints}
        mass = np.diag([rotors[name] for name in self.names])
        for link in self.tree.links:
            moved = self.moved_by.get(link.name)
            if link.inertial is None or not moved:
                continue
            place = self.places[link.name]
            center = place[:3, :3] @ np.asarray(link.inertial.com) + place[:3, 3]
            rates = _at(self.twists[moved], center)
            turned = rates[:, :3] @ place[:3, :3]
            energy = turned @ tensor_of(link.inertial.inertia) @ turned.T
            mass[np.ix_(moved, moved)] += energy + link.inertial.mass * rates[:, 3:] @ rates[:, 3:].T
        return mass

    def _rows(self) -> Floats:
        """Mimics, equalities and closures, by rates."""
        at = {name: k for k, name in enumerate(self.names)}
        rows: list[Floats] = []
        for joint in self.tree.joints:
            if joint.mimic is not None and joint.name in at:
                rows.append(
                    self._row({joint.name: 1.0}, at) - self._row({joint.mimic.joint: joint.mimic.multiplier}, at)
                )
        ways = {tendon.name: dict(tendon.way) for tendon in self.tree.tendons}
        for equality in self.tree.equalities:
            one, other = (
                {name: 1.0} if equality.of == "joint" else ways[name]
                for name in (equality.one, equality.other or equality.one)
            )
            slope = sum(power * factor * 0.5 ** (power - 1) for power, factor in enumerate(equality.coefficients))
            rows.append(self._row(one, at) - (slope * self._row(other, at) if equality.other else 0.0))
        for joints in _chains(self.tree.closures):
            rows += list(self._closure(joints))
        return np.array(rows).reshape(-1, len(self.names))

    def _row(self, way: dict[str, float], at: dict[str, int]) -> Floats:
        row = np.zeros(len(self.names))
        for name, factor in way.items():
            if name in at:
                row[at[name]] += factor
        return row

    def _closure(self, joints: list[Joint]) -> Floats:
        """Rates of both ends against each other that the joints of a closure do not let."""
        columns: list[Floats] = []
        place = self.places[joints[0].parent]
        for joint in joints:
            place = place @ place_of(joint.before)
            columns += [] if joint.kind == "fixed" else _motion(joint, place, None)[0]
            place = place @ place_of(joint.after)
        point = place[:3, 3]
        relative = np.zeros((len(self.names), 6))
        for link, sign in ((joints[-1].child, 1.0), (joints[0].parent, -1.0)):
            moved = self.moved_by[link]
            relative[moved] += sign * _at(self.twists[moved], point)
        held = _complement(_at(np.array(columns), point).T) if columns else np.eye(6)
        return np.asarray((relative @ held).T)


def _at(twists: Floats, point: Floats) -> Floats:
    """Angular velocities, and velocities of a point of the moved body, of twists (n, 9): (n, 6)."""
    turns, velocities, points = twists[:, :3], twists[:, 3:6], twists[:, 6:]
    return np.hstack([turns, velocities + np.cross(turns, point - points)])


def _outward(tree: Tree) -> Iterator[Joint]:
    """Joints from the root outward."""
    below: dict[str, list[Joint]] = {}
    for joint in tree.joints:
        below.setdefault(joint.parent, []).append(joint)
    waiting = [tree.root]
    while waiting:
        for joint in below.get(waiting.pop(), ()):
            yield joint
            waiting.append(joint.child)


def _chains(closures: list[Joint]) -> Iterator[list[Joint]]:
    """Joints of closures that follow each other."""
    chain: list[Joint] = []
    for joint in closures:
        if chain and chain[-1].child != joint.parent:
            yield chain
            chain = []
        chain.append(joint)
    if chain:
        yield chain


def _motion(joint: Joint, before: Floats, random: np.random.Generator | None) -> tuple[list[Floats], Floats]:
    """Twists of a joint whose frame is `before`, each with the point that it tells the velocity of, and the
    displacement of the joint, which is none without `random`."""
    axes, at, still = before[:3, :3], before[:3, 3], np.zeros(3)
    axis = np.asarray(joint.axis, dtype=float)
    axis = axis / (float(np.linalg.norm(axis)) or 1.0)
    angle, way = (0.0, still) if random is None else (random.uniform(-1, 1), random.uniform(-1, 1, size=3))
    turned, motion = axes @ axis, np.eye(4)
    match joint.kind:
        case "revolute" | "screw":
            motion[:3, :3] = turn_about(axis, angle)
            motion[:3, 3] = joint.lead * angle / (2 * np.pi) * axis
            return [np.concatenate([turned, joint.lead / (2 * np.pi) * turned, at])], motion
        case "prismatic":
            motion[:3, 3] = way[0] * axis
            return [np.concatenate([still, turned, at])], motion
        case "planar":
            across = _complement(axis.reshape(3, 1))
            motion[:3, :3], motion[:3, 3] = turn_about(axis, angle), across @ way[:2]
            slides = [np.concatenate([still, axes @ each, at]) for each in across.T]
            return [*slides, np.concatenate([turned, still, at + axes @ motion[:3, 3]])], motion
        case "spherical" | "floating" | "fixed":
            motion[:3, :3] = turn_about(way + 0.1, angle)
            motion[:3, 3] = way if joint.kind == "floating" else still
            point = at + axes @ motion[:3, 3]
            turns = [np.concatenate([each, still, point]) for each in axes.T]
            slides = [np.concatenate([still, each, at]) for each in axes.T]
            return [*turns, *(slides if joint.kind == "floating" else [])], motion
        case _:
            assert_never(joint.kind)


def _complement(columns: Floats) -> Floats:
    """An orthonormal basis of what is orthogonal to the columns (n, k)."""
    left, values, _ = np.linalg.svd(columns)
    rank = int(np.sum(values > 1e-10 * np.max(values, initial=0.0)))
    return np.asarray(left[:, rank:])
