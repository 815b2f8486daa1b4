"""Attributes of Lark that are not in its documents, but that `lagdsl/language/syntax` reads and changes.

Lark's own parser of a small grammar has them, with the same meaning. Where a new Lark fails here, the named file of
`lagdsl/language/syntax` needs another way before the bound of `lark` in pyproject.toml may rise.
"""

from __future__ import annotations

from functools import cache
from itertools import islice
from operator import attrgetter
from pathlib import Path
from typing import Any

import lark
import pytest
from lark.grammar import Rule
from lark.lexer import LexerThread
from lark.parsers.lalr_analysis import Reduce, Shift
from lark.parsers.lalr_interactive_parser import InteractiveParser
from lark.parsers.lalr_parser_state import ParseConf, ParserState

import lagdsl.language.syntax

FOLDER = Path(lagdsl.language.syntax.__file__).parent
GRAMMAR = """
start: item+
item: NAME "=" sum ";"
sum: NUMBER | sum "+" NUMBER
NAME: /[a-z]+/
NUMBER: /[0-9]+/
%ignore " "
"""
TEXT = "ab = 1 + 2; c = 3;"
# By the object: the paths that our files read, and the file that stops working without them.
PARSER = {
    "parser_state.state_stack": "stack.py",
    "parser_state.value_stack": "stack.py",
    "parser_state.parse_conf.states": "stack.py",
    "parser_state.parse_conf.end_state": "stack.py",
    "lexer_thread.lex": "session.py",
    "lexer_thread.state.line_ctr.char_pos": "session.py",
    "lexer_thread.state.text.text": "lexer.py",
    "lexer_thread.state.text.end": "lexer.py",
    "lexer_thread.state.last_token": "lexer.py",
    "choices": "stack.py",
    "accepts": "stack.py",
    "copy": "stack.py",
    "feed_token": "stack.py",
}
WHOLE = {
    "parser.parser._parse_table.states": "language.py",
    "parser.parser._parse_table.start_states": "automaton.py",
    "parser.parser._parse_table.end_states": "automaton.py",
    "parser.lexer.root_lexer.terminals": "lexer.py",
    "parser.lexer.root_lexer.scanner.match": "lexer.py",
    "parser.lexer.root_lexer.callback": "lexer.py",
    "parser.lexer.root_lexer.ignore_types": "lexer.py",
    "parser.lexer.lexers": "lexer.py",
    "lexer_conf.terminals_by_name": "lexer.py",
    "terminals": "language.py",
    "ignore_tokens": "language.py",
}


@cache
def whole() -> Any:
    return lark.Lark(GRAMMAR, parser="lalr", lexer="contextual")


def begun() -> Any:
    """Lark's interactive parser behind the tokens `ab =`."""
    parser: Any = whole().parse_interactive(TEXT)
    for token in islice(parser.lexer_thread.lex(parser.parser_state), 2):
        parser.feed_token(token)
    return parser


def missing(root: object, paths: dict[str, str]) -> list[str]:
    """A line for each path that Lark does not have."""
    lines = []
    for path, file in paths.items():
        try:
            attrgetter(path)(root)
        except AttributeError as error:
            lines.append(f"lark {lark.__version__} has no `{path}`, which lagdsl/language/syntax/{file} uses: {error}")
    return lines


def test_lark_has_the_attributes() -> None:
    lines = missing(begun(), PARSER) + missing(whole(), WHOLE)
    assert not lines, "\n".join(lines)


def test_a_missing_attribute_is_named_with_its_file() -> None:
    (line,) = missing(begun(), {"parser_state.stack_of_states": "stack.py"})
    assert "has no `parser_state.stack_of_states`, which lagdsl/language/syntax/stack.py uses" in line


@pytest.mark.parametrize("path", [*PARSER, *WHOLE])
def test_the_files_use_them(path: str) -> None:
    """A path that no file needs any more is deleted here."""
    assert path.rpartition(".")[2] in (FOLDER / (PARSER | WHOLE)[path]).read_text(encoding="utf-8")


def test_values_are_one_less_than_states() -> None:
    parser = begun()
    state = parser.parser_state
    assert [str(value) for value in state.value_stack] == ["ab", "="]
    assert len(state.state_stack) == len(state.value_stack) + 1
    assert all(entry in state.parse_conf.states for entry in state.state_stack)


def test_rows_have_shifts_to_states_and_reductions_by_rules() -> None:
    states = begun().parser_state.parse_conf.states
    entries = [entry for row in states.values() for entry in row.values()]
    assert {kind for kind, _ in entries} == {Shift, Reduce}
    assert all(target in states for kind, target in entries if kind is Shift)
    rules = [rule for kind, rule in entries if kind is Reduce]
    assert all(isinstance(rule, Rule) for rule in rules)
    assert {(rule.origin.name, len(rule.expansion)) for rule in rules} >= {("item", 4), ("sum", 1), ("sum", 3)}


def test_a_copy_has_stacks_of_its_own() -> None:
    parser = begun()
    trial = parser.copy(deepcopy_values=False)
    del trial.parser_state.state_stack[1:]
    del trial.parser_state.value_stack[:]
    trial.lexer_thread.state.line_ctr.char_pos = 0
    assert set(trial.choices()) >= {"NAME"}
    assert len(parser.parser_state.state_stack) == 3
    assert parser.lexer_thread.state.line_ctr.char_pos == 4
    assert set(parser.accepts()) == {"NUMBER"}


def test_the_place_of_the_lexer_can_be_set() -> None:
    parser = begun()
    parser.lexer_thread.state.line_ctr.char_pos = TEXT.index("3")
    token = next(parser.lexer_thread.lex(parser.parser_state))
    assert (token.type, token.value, token.start_pos, token.end_pos) == ("NUMBER", "3", 16, 17)


def test_a_parser_can_be_made_from_its_parts() -> None:
    made = whole()
    thread = LexerThread.from_text(made.parser.lexer, TEXT)
    conf: Any = ParseConf(made.parser.parser._parse_table, {}, "start")
    parser: Any = InteractiveParser(None, ParserState(conf, thread), thread)
    assert str(next(parser.lexer_thread.lex(parser.parser_state))) == "ab"
    assert set(parser.choices()) >= {"NAME", "item"}
