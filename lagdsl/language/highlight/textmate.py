"""The rules as a TextMate grammar, which VS Code, Sublime Text, Shiki and code hosts read."""

from __future__ import annotations

import json
from typing import Any, assert_never

from lagdsl.language.highlight.rules import ROOT, Include, Kind, Match, Region, Rule, contexts, inner

SCOPES: dict[Kind, str] = {
    Kind.COMMENT: "comment.lag",
    Kind.STRING: "string.quoted.double.lag",
    Kind.NUMBER: "constant.numeric.lag",
    Kind.UNIT: "keyword.other.unit.lag",
    Kind.KEYWORD: "keyword.control.lag",
    Kind.LITERAL: "constant.language.lag",
    Kind.OPERATOR: "keyword.operator.lag",
    Kind.MARK: "punctuation.lag",
    Kind.TYPE: "entity.name.type.lag",
    Kind.NAME: "variable.other.lag",
}


def textmate() -> str:
    """The text of `lag.tmLanguage.json`."""
    every = {**contexts(), **inner()}
    grammar = {
        "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
        "name": "lag",
        "scopeName": "source.lag",
        "fileTypes": ["lag"],
        "patterns": [{"include": f"#{ROOT}"}],
        "repository": {name: {"patterns": [_rule(rule) for rule in rules]} for name, rules in every.items()},
    }
    return json.dumps(grammar, indent=2) + "\n"


def _rule(rule: Rule) -> dict[str, Any]:
    match rule:
        case Include():
            return {"include": f"#{rule.context}"}
        case Match():
            return {"match": rule.pattern, **_captures("captures", rule.kinds)}
        case Region():
            found = {
                "begin": rule.begin,
                "end": rule.end,
                **_captures("beginCaptures", rule.begin_kinds),
                **_captures("endCaptures", (rule.end_kind,)),
                "patterns": [{"include": f"#{rule.inside}"}],
            }
            return found if rule.whole is None else {"name": SCOPES[rule.whole], **found}
        case _:
            assert_never(rule)


def _captures(name: str, kinds: tuple[Kind, ...]) -> dict[str, Any]:
    """Scopes of the whole text, or of each group."""
    first = 0 if len(kinds) == 1 else 1
    return {name: {str(number): {"name": SCOPES[kind]} for number, kind in enumerate(kinds, first)}}
