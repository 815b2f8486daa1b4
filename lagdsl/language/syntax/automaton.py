"""The automaton of the grammar as a text of JSON lines, of which only the lines are read that a parse needs.

The first line is a header, then every rule has a line, then every state. A state gives, for each symbol, the state
that a shift leads to, or -1 - r for a reduction by the rule in line r after the header.
"""

from __future__ import annotations

import json
from typing import Any

from lark.grammar import Rule
from lark.lexer import TerminalDef
from lark.parsers.lalr_analysis import Action, IntParseTable, Reduce, Shift

Row = dict[str, tuple[Action, "int | Rule"]]


class States(dict[int, Row]):
    """Rows of the automaton, read when first asked for. `complete` reads the rest; only then may one iterate."""

    def __init__(self, rules: list[str], states: list[str]) -> None:
        super().__init__()
        self._rules: list[str | Rule] = [*rules]
        self._states = states

    def __missing__(self, state: int) -> Row:
        read: dict[str, int] = json.loads(self._states[state])
        row: Row = {
            symbol: (Shift, target) if target >= 0 else (Reduce, self._rule(-1 - target))
            for symbol, target in read.items()
        }
        self[state] = row
        return row

    def complete(self) -> States:
        """All rows, in their order."""
        found = {state: self[state] for state in range(len(self._states))}
        self.clear()
        self.update(found)
        return self

    def _rule(self, number: int) -> Rule:
        rule = self._rules[number]
        if isinstance(rule, str):
            rule = self._rules[number] = Rule.deserialize(json.loads(rule), {})
        return rule


def stored_automaton(text: str, version: str) -> tuple[IntParseTable, list[TerminalDef], list[str]] | None:
    """The table, all terminals and the names of those that are ignored; None if another version of Lark stored them."""
    first, *lines = text.splitlines()
    header: dict[str, Any] = json.loads(first)
    if header["lark"] != version:
        return None
    rules = header["rules"]
    make: Any = IntParseTable
    table = make(States(lines[:rules], lines[rules:]), header["starts"], header["ends"])
    terminals = [TerminalDef.deserialize(terminal, {}) for terminal in header["terminals"]]
    return table, terminals, header["ignored"]


def automaton_text(table: IntParseTable, terminals: list[TerminalDef], ignored: list[str], version: str) -> str:
    """Input of `stored_automaton`. The states of `table` are numbered from 0."""
    entries = [entry for row in table.states.values() for entry in row.values()]
    rules = sorted({rule for kind, rule in entries if kind is Reduce}, key=str)
    number = {rule: -1 - index for index, rule in enumerate(rules)}
    header = {
        "lark": version,
        "rules": len(rules),
        "starts": table.start_states,
        "ends": table.end_states,
        "ignored": ignored,
        "terminals": [terminal.serialize() for terminal in terminals],
    }
    rows = (
        {symbol: target if kind is Shift else number[target] for symbol, (kind, target) in row.items()}
        for row in table.states.values()
    )
    lines = (header, *(rule.serialize() for rule in rules), *rows)
    return "".join(f"{json.dumps(line, separators=(',', ':'), ensure_ascii=False)}\n" for line in lines)
