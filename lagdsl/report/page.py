"""State that all sections of a derivation report share: the model, its derivation, and how things are set."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Symbol

from lagdsl.flat.model import FlatModel
from lagdsl.report.boxes import Box, Bracket, Derivative, Sum
from lagdsl.report.names import carrier_labels
from lagdsl.report.notation import Notation
from lagdsl.report.typeset import Typesetter
from lagdsl.textbook.contributions import AppliedForce, AppliedTorque, Inertial
from lagdsl.textbook.familiar import Familiar
from lagdsl.textbook.geometry import Vector
from lagdsl.textbook.reading import STANDARD_GRAVITY
from lagdsl.textbook.recipe import Derivation
from lagdsl.textbook.small_motions.study import Study


@dataclass(frozen=True)
class Page:
    """One derivation and its notation."""

    familiar: Familiar
    derivation: Derivation
    notation: Notation
    typeset: Typesetter
    study: Study | None

    @property
    def flat(self) -> FlatModel:
        return self.familiar.flat

    def inertial_elements(self) -> list[tuple[Box, Inertial]]:
        """Masses and bodies with the index their vectors carry."""
        return list(zip(carrier_labels(self.flat), self.derivation.inertials, strict=True))

    def is_positive(self, symbol: Symbol) -> bool:
        """True for a parameter with a positive value."""
        return symbol == STANDARD_GRAVITY or any(p.name == symbol.name and p.value > 0 for p in self.flat.parameters)

    @property
    def lagrangian(self) -> Box:
        return self.notation.letter("L")

    def by_time(self) -> Box:
        """The bare operator d/dt."""
        return Derivative("d", None, self.notation.of(self.derivation.symbols.time))

    def rate(self, q: Symbol) -> Box:
        symbols = self.derivation.symbols
        return self.notation.of(symbols.qd[symbols.q.index(q)])

    def vector(self, components: Vector) -> Box:
        return self.typeset.vector(components, planar=self.planar)

    @property
    def planar(self) -> bool:
        """True if nothing leaves the plane z = 0."""
        d = self.derivation
        carried = all(item.position[2] == 0 and item.spin[0] == 0 and item.spin[1] == 0 for item in d.inertials)
        actions = [a.action for a in d.actions]
        forces = [a for a in actions if isinstance(a, AppliedForce)]
        turned = any(isinstance(a, AppliedTorque) for a in actions)
        return carried and not turned and all(f.force[2] == 0 and f.position[2] == 0 for f in forces)


def partial(of: Box, by: Box) -> Box:
    """The partial derivative as a fraction."""
    return Derivative("∂", of, by)


def added(boxes: list[Box]) -> Box:
    """A sum of boxes, of which some bring a minus sign along."""
    terms = []
    for box in boxes:
        if isinstance(box, Sum) and len(box.terms) == 1:
            terms.append(box.terms[0])
        else:
            terms.append(("+", Bracket(box) if isinstance(box, Sum) else box))
    return boxes[0] if len(boxes) == 1 else Sum(tuple(terms))
