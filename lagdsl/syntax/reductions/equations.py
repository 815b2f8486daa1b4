"""Nodes of equations, loops, branches and events."""

from __future__ import annotations

from typing import Any

from lagdsl.source import Span
from lagdsl.syntax import nodes
from lagdsl.syntax.reductions.action import Action
from lagdsl.syntax.reductions.declarations import doc
from lagdsl.syntax.reductions.expressions import pairs


def _for(c: list[Any], span: Span) -> nodes.For:
    return nodes.For(span=span, iterators=c[0], body=tuple(c[1:]))


def _if(c: list[Any], span: Span) -> nodes.If:
    """Conditions and bodies in turn, then the body of `else` or None."""
    branches = tuple(
        nodes.IfBranch(span=_branch_span(condition, body), condition=condition, body=body)
        for condition, body in pairs(c[:-1])
    )
    return nodes.If(span=span, branches=branches, otherwise=c[-1])


def _when(c: list[Any], span: Span) -> nodes.When:
    branches = tuple(
        nodes.WhenBranch(span=_branch_span(condition, body), condition=condition, body=body)
        for condition, body in pairs(c)
    )
    return nodes.When(span=span, branches=branches)


def _branch_span(condition: nodes.Expression, body: tuple[nodes.Item, ...]) -> Span:
    return condition.span.to(body[-1].span) if body else condition.span


EQUATIONS: dict[str, Action] = {
    "eq": lambda c, span: nodes.Equation(span=span, left=c[0], right=c[1], doc=doc(c[2])),
    "call_eq": lambda c, span: nodes.CallEquation(span=span, call=c[0], doc=doc(c[1])),
    "keyword_name": lambda c, span: nodes.Reference(span=span, name=c[0].value),
    "equation": lambda c, span: c[0],
    "for_eq": _for,
    "for_element": _for,
    "if_eq": _if,
    "if_element": _if,
    "elements": lambda c, span: tuple(c),
    "equations": lambda c, span: tuple(c),
    "when_body": lambda c, span: tuple(c),
    "when_clause": _when,
}
