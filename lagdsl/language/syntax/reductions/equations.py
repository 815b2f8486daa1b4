"""Nodes of equations, loops, branches and events."""

from __future__ import annotations

from typing import Any

from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.reductions.action import Action, listed, maker
from lagdsl.language.syntax.reductions.expressions import pairs


def _if(c: list[Any], span: Span) -> nodes.If:
    """Conditions and bodies in turn, then the body of `else` or None."""
    return nodes.If(span=span, branches=_branches(nodes.IfBranch, c[:-1]), otherwise=c[-1])


def _branches(kind: type[Any], items: list[Any]) -> tuple[Any, ...]:
    return tuple(
        kind(span=_branch_span(condition, body), condition=condition, body=body) for condition, body in pairs(items)
    )


def _branch_span(condition: nodes.Expression, body: tuple[nodes.Item, ...]) -> Span:
    return condition.span.to(body[-1].span) if body else condition.span


_for = maker(nodes.For, "iterators", "*body")

EQUATIONS: dict[str, Action] = {
    "eq": maker(nodes.Equation, "left", "right", "doc"),
    "call_eq": maker(nodes.CallEquation, "call", "doc"),
    "keyword_name": maker(nodes.Reference, "name"),
    "equation": lambda c, span: c[0],
    "for_eq": _for,
    "for_element": _for,
    "if_eq": _if,
    "if_element": _if,
    "elements": listed,
    "equations": listed,
    "when_body": listed,
    "when_clause": lambda c, span: nodes.When(span=span, branches=_branches(nodes.WhenBranch, c)),
}
