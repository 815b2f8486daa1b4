"""Quantities of mechanics for outputs: multipliers, energies, momenta, and reactions, by a release."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, assert_never

from sympy import Add, Expr, Integer

from lagdsl.derivation.textbook import geometry
from lagdsl.derivation.textbook.contributions import (
    Contributions,
    Inertial,
    contributions,
    force_balance,
    generalized_force,
    held_rates,
)
from lagdsl.derivation.textbook.convert import Converter, Mechanical, Style
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.equations import Energies
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.kinematics import RELEASE, RELEASE_RATE, Release
from lagdsl.derivation.textbook.symbols import Symbols, replaced
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.model import FlatModel


@dataclass
class MechanicalValues:
    """Evaluates such nodes for one derived model."""

    model: FlatModel
    symbols: Symbols
    parts: Contributions
    energies: Energies
    momenta: Sequence[Expr]
    _known: dict[Mechanical | flat.Component, Expr | Vector] = field(default_factory=dict)

    def __call__(self, node: Mechanical | flat.Component, asking: Converter) -> Expr | Vector:
        """A reaction that several outputs read is formed once; of a component the other ones are not. The parts of a
        motion are as `asking` has them."""
        if isinstance(node, flat.RequiredForce):
            return self.parts.required(node, asking)
        if node not in self._known:
            self._known[node] = self._value(node)
        return self._known[node]

    def _value(self, node: Mechanical | flat.Component) -> Expr | Vector:
        match node:
            case flat.Multiplier(row):
                rows = [name for constraint in self.model.constraints for name in constraint.rows]
                return self.symbols.lam[rows.index(row)]
            case flat.SystemEnergy(kind):
                return self._energy(kind)
            case flat.GeneralizedMomentum(coordinate):
                return self.momenta[[c.name for c in self.model.coordinates].index(coordinate)]
            case flat.ForceBalance():
                return force_balance(self.model, self.parts, node)
            case flat.LinearMomentum():
                return _vector_sum([geometry.scale(item.mass, item.velocity) for item in self.parts.inertials])
            case flat.AngularMomentum(body, about):
                return self._angular_momentum(body, self.parts.converter.vector(about))
            case flat.AdmissibleMotion(point, coordinate):
                moved = self.symbols.q[[c.name for c in self.model.coordinates].index(coordinate)]
                x, y, z = (partial(component, moved) for component in self.parts.converter.vector(point))
                return (x, y, z)
            case flat.ReactionAlong(point, direction):
                along = self.parts.converter.vector(direction)
                return self._reaction(Release(kind="point", name=point, direction=along))
            case flat.FrameReaction():
                x, y, z = (self._of_frame(node, axis) for axis in range(3))
                return (x, y, z)
            case flat.RequiredForce():
                raise AssertionError(node)
            case flat.Component(vector, axis):
                assert isinstance(vector, flat.FrameReaction)
                return self._of_frame(vector, axis)
            case _:
                assert_never(node)

    def _of_frame(self, node: flat.FrameReaction, axis: int) -> Expr:
        kind: Literal["displace frame", "turn frame"] = "displace frame" if node.kind == "force" else "turn frame"
        return self._reaction(Release(kind=kind, name=node.frame, axis=axis))

    def _energy(self, kind: Literal["total", "kinetic", "potential", "jacobi"]) -> Expr:
        match kind:
            case "total":
                return self.energies.total
            case "kinetic":
                return self.energies.kinetic
            case "potential":
                return self.energies.potential
            case "jacobi":
                return self.energies.jacobi
            case _:
                assert_never(kind)

    def _angular_momentum(self, body: str | None, about: Vector) -> Vector:
        items = self.parts.inertials
        if body is not None:
            index = [b.label for b in self.model.bodies].index(body)
            items = (items[len(self.model.masses) + index],)
        return _vector_sum([self._moment(item, about) for item in items])

    def _moment(self, item: Inertial, about: Vector) -> Vector:
        """(r - about) x m v, and for a body R I omega."""
        arm = geometry.subtract(item.position, about)
        orbital = geometry.cross(arm, geometry.scale(item.mass, item.velocity))
        if item.frame is None or item.tensor is None:
            return orbital
        rotation = self.parts.converter.kinematics.poses[item.frame].rotation
        return geometry.add(orbital, geometry.apply(rotation, geometry.apply(item.tensor, item.spin)))

    def _reaction(self, release: Release) -> Expr:
        """The equation of the released coordinate s, solved for the force that keeps s at 0."""
        unreleased = self.parts.converter
        style = Style(number=unreleased.style.number, tidy=unreleased.style.tidy)
        converter = Converter(model=self.model, symbols=self.symbols, release=release, style=style)
        parts = contributions(self.model, converter)
        held = held_rates(self.model, self.symbols, parts)
        levels = [constraint.level for constraint in self.model.constraints for _ in constraint.rows]
        upheld = [
            lam * partial(residual, RELEASE if level == "position" else RELEASE_RATE)
            for lam, residual, level in zip(self.symbols.lam, parts.residuals, levels, strict=True)
        ]
        others = (
            held.partial(held.parts.dissipation, RELEASE_RATE)
            - held.partial(held.parts.lagrangian, RELEASE)
            - generalized_force(parts, RELEASE, RELEASE_RATE)
            - Add(*upheld)
        )
        momentum = _unreleased(partial(parts.lagrangian, RELEASE_RATE))
        return unreleased.rate(unreleased.style.tidy(momentum)) + _unreleased(others)


def _unreleased(expression: Expr) -> Expr:
    return replaced(expression, {RELEASE: Integer(0), RELEASE_RATE: Integer(0)})


def _vector_sum(vectors: Sequence[Vector]) -> Vector:
    total = geometry.ZERO
    for vector in vectors:
        total = geometry.add(total, vector)
    return total
