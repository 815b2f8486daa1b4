"""Definitions of intermediate quantities, after the section that is the first to be written with them."""

from __future__ import annotations

from collections.abc import Callable

from lagdsl.documents.report.document import Block, Paragraph, text
from lagdsl.documents.report.page import Page
from lagdsl.documents.report.sections.left_side import definition_lines


def with_intermediates(page: Page, section: Callable[[Page], list[Block]]) -> list[Block]:
    made = page.typeset.intermediates.made
    before = len(made)
    blocks = section(page)
    if len(made) == before:
        return blocks
    return [*blocks, Paragraph(text("with")), definition_lines(page, tuple(made[before:]))]
