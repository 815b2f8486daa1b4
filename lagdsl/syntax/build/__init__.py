"""Makes the nodes of the syntax tree: one function for every rule of the grammar that has a node, by the rule's name."""

from __future__ import annotations

from lagdsl.diagnostics import Sink
from lagdsl.syntax.build.classes import class_actions
from lagdsl.syntax.build.declarations import DECLARATIONS
from lagdsl.syntax.build.equations import EQUATIONS
from lagdsl.syntax.build.expressions import expression_actions
from lagdsl.syntax.build.items import ITEMS
from lagdsl.syntax.machine import Action


def actions(sink: Sink) -> dict[str, Action]:
    """All actions; those that check something report to `sink`."""
    return {**expression_actions(sink), **DECLARATIONS, **ITEMS, **EQUATIONS, **class_actions(sink)}


__all__ = ["actions"]
