"""The drawing of the system before its derivation."""

from __future__ import annotations

from lagdsl.documents.report.document import Block, Drawing, Heading, text
from lagdsl.documents.report.figure.draw import figure
from lagdsl.documents.report.figure.drawn_model import derived, outlined
from lagdsl.documents.report.notation import Notation
from lagdsl.documents.report.page import Page
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

_LEGEND = (
    "The start of the motion. Each coordinate has a color and its positive sense, from its zero. In this color are the "
    "admissible motions ∂r/∂q of the masses that it moves, the others held. Weights are gray, forces red. Arrows of "
    "one color have one scale."
)
_LEGEND_OF_A_MACHINE = (
    "The start of the motion. Full circles are masses, open ones mass centers of bodies. The first coordinates have a "
    "color each and their positive sense, from their zero. Forces are red."
)


def system(page: Page, compilation: Compilation | None) -> list[Block]:
    """Nothing for a model that has no mass in space, or no start."""
    found = figure(derived(page), compilation)
    return [] if found is None else [Heading("The system"), Drawing(found, text(_LEGEND))]


def machine(flat: FlatModel, notation: Notation, compilation: Compilation | None) -> list[Block]:
    """The same of a machine that is told by chapters."""
    found = figure(outlined(flat, notation), compilation)
    return [] if found is None else [Heading("The system"), Drawing(found, text(_LEGEND_OF_A_MACHINE))]
