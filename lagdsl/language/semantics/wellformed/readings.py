"""Reactions, energies and momenta that a model reads: items that no coordinate moves act on these."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.traversal import postorder


@record()
class Readings:
    """`released`: frames and points whose reaction the model reads; in `dependence` each is a quantity of its own, on
    which all depends that it carries. `masses`: the model reads an energy or a momentum of all masses."""

    released: frozenset[str]
    dependence: Dependence
    masses: bool


def read_by(flat: fm.FlatModel) -> Readings:
    """The readings of a model."""
    nodes = [node for node, _ in mechanical(flat)]
    released = frozenset(
        node.frame if isinstance(node, fx.FrameReaction) else node.point
        for node in nodes
        if isinstance(node, fx.FrameReaction | fx.ReactionAlong)
    )
    sums = (fx.SystemEnergy, fx.GeneralizedMomentum, fx.LinearMomentum, fx.AngularMomentum)
    return Readings(released, with_released(flat, released), any(isinstance(node, sums) for node in nodes))


def mechanical(flat: fm.FlatModel) -> Iterator[tuple[fx.FlatExpression, Item]]:
    """Reactions, energies and momenta that the model reads, each with the item that reads it first."""
    definitions = (item for item in flat.named if isinstance(item, fm.Definition))
    asking: tuple[fm.Output | fm.Invariant | fm.Definition, ...] = (
        *flat.outputs,
        *flat.invariants,
        *definitions,
        *flat.observed,
    )
    seen: set[int] = set()
    for item in asking:
        for node in postorder(item.value, seen):
            seen.add(id(node))
            if isinstance(node, fx.Mechanical):
                yield node, item


def with_released(flat: fm.FlatModel, names: frozenset[str]) -> Dependence:
    """Of the model in which the points and frames `names` may move by themselves, each by a quantity of its name."""
    named = tuple(_released(each) if each.name in names else each for each in flat.named)
    return Dependence(replace(flat, named=named))


def _released(named: fm.Named) -> fm.Named:
    """A point that depends on nothing but itself, a frame that moves in its place by itself, too."""
    own = fx.Variable(named.name)
    match named:
        case fm.Point():
            return replace(named, position=own)
        case fm.Frame():
            return replace(named, steps=(*named.steps, fm.Move((own, fx.ZERO, fx.ZERO)), fm.Rotate(0, own)))
        case fm.Definition():
            return named
