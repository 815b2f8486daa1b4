"""Makes the nodes of the syntax tree: one action for every rule of the grammar that has a node, by the rule's name."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.syntax.reductions.action import Action
from lagdsl.language.syntax.reductions.classes import class_actions
from lagdsl.language.syntax.reductions.declarations import DECLARATIONS
from lagdsl.language.syntax.reductions.equations import EQUATIONS
from lagdsl.language.syntax.reductions.expressions import expression_actions
from lagdsl.language.syntax.reductions.items import ITEMS


def actions(sink: Sink) -> dict[str, Action]:
    """All actions; those that check something report to `sink`."""
    return {**expression_actions(sink), **DECLARATIONS, **ITEMS, **EQUATIONS, **class_actions(sink)}


__all__ = ["Action", "actions"]
