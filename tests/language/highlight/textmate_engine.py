"""A reader of TextMate grammars: lines, regions with their ends first, the earliest match, of equal ones the first."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from lagdsl.language.highlight.textmate import SCOPES

KINDS = {scope: kind for kind, scope in SCOPES.items()}
_compiled = cache(re.compile)


class Engine:
    """Kinds of the characters of a text, by the scope that is innermost."""

    def __init__(self, grammar: dict[str, Any]) -> None:
        self.grammar = grammar
        self._flat: dict[int, list[dict[str, Any]]] = {}

    def kinds(self, text: str) -> list[str]:
        found: list[str] = []
        stack: list[dict[str, Any]] = []
        for line in text.splitlines(keepends=True):
            found += self._line(line, stack)
        return found

    def _line(self, line: str, stack: list[dict[str, Any]]) -> list[str]:
        kinds, at = [self._of(stack)] * len(line), 0
        while at <= len(line):
            rules = self._rules(stack[-1] if stack else self.grammar)
            first = None
            if stack and (end := _compiled(stack[-1]["end"]).search(line, at)):
                first = (end.start(), -1, end, None)
            for number, rule in enumerate(rules):
                match = _compiled(rule.get("match") or rule["begin"]).search(line, at)
                if match is not None and (first is None or match.start() < first[0]):
                    first = (match.start(), number, match, rule)
            if first is None:
                break
            _, _, match, rule = first
            if rule is None:
                self._paint(kinds, match, stack.pop()["endCaptures"])
            elif "begin" in rule:
                stack.append(rule)
                self._paint(kinds, match, rule["beginCaptures"])
            else:
                self._paint(kinds, match, rule["captures"])
            assert match.end() > at or match.end() > match.start(), "the grammar stands still"
            at = match.end()
            kinds[at:] = [self._of(stack)] * (len(line) - at)
        return kinds

    def _of(self, stack: list[dict[str, Any]]) -> str:
        return next((KINDS[region["name"]] for region in reversed(stack) if "name" in region), "none")

    def _rules(self, place: dict[str, Any]) -> list[dict[str, Any]]:
        """The rules of a place, with those of other contexts that it includes."""
        if id(place) not in self._flat:
            rules: list[dict[str, Any]] = []
            for rule in place["patterns"]:
                name = rule.get("include")
                rules += [rule] if name is None else self._rules(self.grammar["repository"][name.removeprefix("#")])
            self._flat[id(place)] = rules
        return self._flat[id(place)]

    def _paint(self, kinds: list[str], match: re.Match[str], captures: dict[str, Any]) -> None:
        for number, capture in captures.items():
            start, end = match.span(int(number))
            kinds[start:end] = [KINDS[capture["name"]]] * (end - start)
