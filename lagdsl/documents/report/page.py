"""State that all sections of a derivation report share: the model, its derivation, and how things are set."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Concatenate, ParamSpec

from sympy import Symbol

from lagdsl.derivation.textbook.contributions import AppliedForce, AppliedTorque, Inertial
from lagdsl.derivation.textbook.familiar import Familiar
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.recipe import Derivation
from lagdsl.derivation.textbook.small_motions.study import Study
from lagdsl.documents.report.boxes import Box, Bracket, Column, Derivative, Name, Operator, Row, Subscript, Sum, bold
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import Equation
from lagdsl.documents.report.names import carrier_labels
from lagdsl.documents.report.notation import Notation
from lagdsl.documents.report.typeset import Typesetter
from lagdsl.documents.report.unicode_math import line
from lagdsl.language.flat.model import FlatModel

Arguments = ParamSpec("Arguments")
_WIDEST_VECTOR = 90


@dataclass(frozen=True)
class Page:
    """One derivation and its notation."""

    familiar: Familiar
    derivation: Derivation
    notation: Notation
    typeset: Typesetter
    study: Study | None
    units: Units | None = None

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

    def vector_letter(self, letter: str) -> Box:
        """In bold; a spin about the normal of the plane is a number."""
        found = self.notation.letter(letter)
        return found if letter in "ωM" and self.planar else bold(found)

    def by_time(self) -> Box:
        """The bare operator d/dt."""
        return Derivative("d", None, self.notation.of(self.derivation.symbols.time))

    def rate(self, q: Symbol) -> Box:
        symbols = self.derivation.symbols
        return self.notation.of(symbols.qd[symbols.q.index(q)])

    def vector(self, components: Vector) -> Box:
        return self.typeset.vector(components, planar=self.planar)

    def unit(
        self, of: Callable[Concatenate[Units, Arguments], str | None], *given: Arguments.args, **named: Arguments.kwargs
    ) -> str | None:
        """The unit of an equation, where units are asked for; that of a number is none."""
        found = None if self.units is None else of(self.units, *given, **named)
        return None if found == "1" else found

    @property
    def planar(self) -> bool:
        """True if nothing leaves the plane z = 0."""
        d = self.derivation
        carried = all(item.position[2] == 0 and item.spin[0] == 0 and item.spin[1] == 0 for item in d.inertials)
        actions = [a.action for a in d.actions]
        forces = [a for a in actions if isinstance(a, AppliedForce)]
        turned = any(isinstance(a, AppliedTorque) for a in actions)
        return carried and not turned and all(f.force[2] == 0 and f.position[2] == 0 for f in forces)


def vector_lines(left: Box, value: Box, unit: str | None) -> list[Equation]:
    """`left = value`; a vector too wide for a line component by component."""
    if not isinstance(value, Column) or len(line(value)) <= _WIDEST_VECTOR:
        return [Equation(left, value, unit=unit)]
    axes = zip("xyz", value.components, strict=False)
    return [Equation(_component(left, Name(axis)), component, unit=unit) for axis, component in axes]


def _component(vector: Box, axis: Box) -> Box:
    if isinstance(vector, Subscript):
        return Subscript(vector.base, Row((vector.index, Operator(","), axis)))
    return Subscript(Bracket(vector) if isinstance(vector, Derivative) else vector, axis)


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
