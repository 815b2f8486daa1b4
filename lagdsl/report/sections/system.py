"""The drawing of the system before its derivation."""

from __future__ import annotations

from lagdsl.report.document import Block, Drawing, Heading, text
from lagdsl.report.figure.draw import figure
from lagdsl.report.page import Page

_LEGEND = (
    "The start of the motion. Each coordinate has a color and its positive sense, from its zero. In this color are the "
    "admissible motions ∂r/∂q of the masses that it moves, the others held. Weights are gray, forces red. Arrows of "
    "one color have one scale."
)


def system(page: Page) -> list[Block]:
    """Nothing for a model that has no mass in space, or no start."""
    found = figure(page)
    return [] if found is None else [Heading("The system"), Drawing(found, text(_LEGEND))]
