"""Reactions by releasing what they hold: d'Alembert's value of forces that do no work.

The model is lowered a second time with a frame or a point displaced by symbols s that stand for zero. The residual of
the equation of s at s = 0, with rate and acceleration 0, is the force that keeps s at zero: the reaction. It is exerted
by the parent's side on all that the frame carries (Lagrange's principle of release; Hamel, *Theoretische Mechanik*,
1949).
"""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.constraints import constraint_forces, constraint_rows
from lagdsl.derivation.mechanics.kinematics.poses import Release
from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.derivation.mechanics.lagrange.lagrange import applied_forces, dynamics
from lagdsl.derivation.mechanics.lowering.lowering import Lowering, Provided
from lagdsl.derivation.mechanics.lowering.symbols import Directions, Symbols
from lagdsl.derivation.mechanics.lowering.values import Value
from lagdsl.foundation.record import mutable_record
from lagdsl.language.flat.expression import ForceBalance, FrameReaction, ReactionAlong
from lagdsl.language.flat.model import FlatModel


@mutable_record()
class Releases:
    """Assignment of release symbols: a frame takes three for the force and three for the torque."""

    release: Release
    along: dict[int, int]
    count: int


def plan_releases(requests: list[FrameReaction | ReactionAlong], directions: dict[int, Vector]) -> Releases:
    """Number the symbols; `directions` holds the lowered direction of each ReactionAlong by its id."""
    releases = Releases(Release(), {}, 0)
    for request in requests:
        if isinstance(request, ReactionAlong):
            if id(request) in releases.along:
                continue
            releases.along[id(request)] = releases.count
            entry = (releases.count, directions[id(request)])
            releases.release.points.setdefault(request.point, []).append(entry)
            releases.count += 1
            continue
        table = releases.release.origins if request.kind == "force" else releases.release.turns
        if request.frame not in table:
            table[request.frame] = releases.count
            releases.count += 3
    return releases


def reactions(lowering: Lowering, flat: FlatModel, symbols: Symbols, releases: Releases) -> list[int]:
    """The generalized force of each release, with qdd and lambda as symbols."""
    graph = lowering.graph
    released = Lowering(graph, flat, symbols, releases.release)
    provided = lowering.provide

    def provide(asked: Provided, nodes: Sequence[int]) -> Value:
        """Balances of forces, in constraints only, pull on nothing: their multipliers are zero."""
        assert provided is not None, asked
        return graph.zero if isinstance(asked, ForceBalance) else provided(asked, nodes)

    released.provide = provide
    directions = Directions(
        tuple(graph.symbols(Group.RELEASE, releases.count)),
        tuple(graph.symbols(Group.RELEASE_RATE, releases.count)),
        Group.RELEASE,
        Group.RELEASE_RATE,
    )
    terms = dynamics(released, flat, directions).terms
    constrained = constraint_forces(graph, constraint_rows(released, flat), list(symbols.lam), directions)
    at_zero = _at_zero(graph, directions)
    return [
        graph.subtract(
            lowering.rate.of(at_zero.of(momentum)), graph.add(at_zero.of(applied), at_zero.of(constraint_force))
        )
        for momentum, applied, constraint_force in zip(
            terms.momentum, applied_forces(graph, terms), constrained, strict=True
        )
    ]


def _at_zero(graph: Graph, directions: Directions) -> Substitution:
    return Substitution(graph, dict.fromkeys((*directions.positions, *directions.rates), graph.zero))
