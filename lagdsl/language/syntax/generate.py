"""Writes `grammar.jsonl`, the parser of the grammar: `python -m lagdsl.language.syntax.generate`.

Lark numbers the states of the automaton in the order of sets, which follows the hash seed. Here a walk from the start
states numbers them, so that equal grammars give equal bytes.
"""

from __future__ import annotations

from typing import Any

from lark.parsers.lalr_analysis import IntParseTable, Shift

from lagdsl.foundation.resources import grammar_file
from lagdsl.language.syntax.automaton import automaton_text
from lagdsl.language.syntax.language import STARTS, STORED, compiled, lark_version

UNBOUNDED = 2**32 - 1
"""Width of a pattern without a bound: versions of Python give this or more."""


def stored_text(grammar: str) -> str:
    """The text of `grammar.jsonl` for the text of a grammar."""
    lark: Any = compiled(grammar)
    for terminal in lark.terminals:
        if terminal.pattern.type == "re":
            terminal.pattern._width = [min(width, UNBOUNDED) for width in terminal.pattern._get_width()]
    return automaton_text(
        _in_order(lark.parser.parser._parse_table), lark.terminals, lark.ignore_tokens, lark_version()
    )


def _in_order(table: IntParseTable) -> IntParseTable:
    """The same automaton with states, and symbols within them, in an order of its own."""
    order = _state_order(table)
    states = {
        number: {
            name: (kind, order[argument] if kind is Shift else argument)
            for name, (kind, argument) in sorted(table.states[state].items())
        }
        for state, number in order.items()
    }
    starts, ends = table.start_states, table.end_states
    made: Any = IntParseTable
    numbered: IntParseTable = made(
        states,
        {name: order[starts[name]] for name in STARTS},
        {name: order[ends[name]] for name in STARTS},
    )
    return numbered


def _state_order(table: IntParseTable) -> dict[int, int]:
    order: dict[int, int] = {}
    waiting = [table.start_states[name] for name in STARTS]
    for state in waiting:
        if state not in order:
            order[state] = len(order)
            waiting += [argument for _, (kind, argument) in sorted(table.states[state].items()) if kind is Shift]
    return order


def main() -> None:
    """Write the file beside this one."""
    STORED.write_text(stored_text(grammar_file().read_text(encoding="utf-8")), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
