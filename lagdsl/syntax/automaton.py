"""The LALR(1) automaton of the grammar, read from the generated tables state by state as it is needed."""

from __future__ import annotations

from typing import NamedTuple

from lagdsl.syntax import tables

TERMINAL: dict[str, int] = {name: number for number, name in enumerate(tables.TERMINALS)}
RESULT: dict[str, int] = {name: len(TERMINAL) + number for number, name in enumerate(tables.RESULTS)}
END_OF_TEXT = TERMINAL["$END"]

_rows: list[dict[int, int] | None] = [None] * len(tables.ROWS)
_rules: list[Rule | None] = [None] * len(tables.RULES)


class Rule(NamedTuple):
    """What a reduction takes off the stack and makes of it."""

    result: int
    length: int
    name: str
    is_list: bool
    may_pass: bool
    renames: bool  # one symbol becomes another of the same value: precedence levels
    children: tuple[tuple[int, bool] | None, ...]  # (position, is spliced); None: an option that is absent


def row(state: int) -> dict[int, int]:
    """Actions of a state by symbol: n >= 0 goes to state n, n < 0 reduces by rule ~n."""
    found = _rows[state]
    if found is None:
        numbers = [int(word) for word in tables.ROWS[state].split()]
        found = _rows[state] = dict(zip(numbers[::2], numbers[1::2], strict=True))
    return found


def rule(number: int) -> Rule:
    """The rule that action `~number` reduces by."""
    found = _rules[number]
    if found is None:
        result, length, name, *children = tables.RULES[number].split()
        found = _rules[number] = Rule(
            result=int(result),
            length=int(length),
            name=name.rstrip("?"),
            is_list=name.startswith("_"),
            may_pass=name.endswith("?"),
            renames=name.endswith("?") and length == "1" and children == ["0"],
            children=tuple(_child(text) for text in children),
        )
    return found


def _child(text: str) -> tuple[int, bool] | None:
    return None if text == "-" else (int(text.lstrip("*")), text.startswith("*"))
