"""The rules as a lexer of Pygments: `pygmentize -l lag`, Sphinx, MkDocs, Jupyter."""

from __future__ import annotations

import re
from typing import Any, assert_never

from pygments.lexer import RegexLexer, bygroups, include
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text

from lagdsl.language.highlight.rules import ROOT, Include, Kind, Match, Region, Rule, contexts, inner

TOKENS: dict[Kind, Any] = {
    Kind.COMMENT: Comment,
    Kind.STRING: String,
    Kind.NUMBER: Number,
    Kind.UNIT: Keyword.Type,
    Kind.KEYWORD: Keyword,
    Kind.LITERAL: Keyword.Constant,
    Kind.OPERATOR: Operator,
    Kind.MARK: Punctuation,
    Kind.TYPE: Name.Class,
    Kind.NAME: Name,
}


class LagLexer(RegexLexer):  # type: ignore[misc]  # Pygments has no types
    """`.lag` texts."""

    name = "lag"
    aliases = ["lag", "lagdsl"]  # noqa: RUF012 as Pygments declares it
    filenames = ["*.lag"]  # noqa: RUF012
    url = "https://pypi.org/project/lagdsl/"
    flags = re.MULTILINE


def _states() -> dict[str, list[Any]]:
    """States of the lexer: the contexts, and one for each region, which its end leaves."""
    states: dict[str, list[Any]] = {}
    for name, rules in {**contexts(), **inner()}.items():
        states["root" if name == ROOT else name] = [_rule(rule, states) for rule in rules]
    for name in ("root", "statement", "equation", "brackets"):
        states[name] += [(r"\s+", Text)]
    return states


def _rule(rule: Rule, states: dict[str, list[Any]]) -> Any:
    match rule:
        case Include():
            return include(rule.context)
        case Match():
            return rule.pattern, _tokens(rule.kinds)
        case Region():
            state = f"{rule.inside} {len(states)} {rule.begin}"
            rest = [] if rule.whole is None else [(r"[^\\\n*\"]+|[\s\S]", TOKENS[rule.whole])]
            states[state] = [(rule.end, TOKENS[rule.end_kind], "#pop"), include(rule.inside), *rest]
            return rule.begin, _tokens(rule.begin_kinds), state
        case _:
            assert_never(rule)


def _tokens(kinds: tuple[Kind, ...]) -> Any:
    return TOKENS[kinds[0]] if len(kinds) == 1 else bygroups(*(TOKENS[kind] for kind in kinds))


LagLexer.tokens = _states()
