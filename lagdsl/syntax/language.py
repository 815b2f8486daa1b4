"""The language as Lark runs it: LALR(1) with the contextual lexer, from grammar/lagdsl.lark.

Lark takes most of a second to compute the automaton of the grammar. `grammar.json` beside this file holds it, as Lark
serialises it; `python -m lagdsl.syntax.generate` writes that file.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import lark
from lark import Lark, Token
from lark.lark import PostLex
from lark.lexer import BasicLexer

from lagdsl.resources import grammar_file

STARTS = ("start", "expr")
STORED = Path(__file__).with_name("grammar.json")


class _InEveryState(PostLex):
    """Terminals that the contextual lexer looks for whether the parser accepts them or not.

    Without IDENT `atP` would be the keyword `at` and the name `P` where only the keyword is accepted, and without
    ELSEWHEN `elsewhen` would be `else when`.
    """

    always_accept = ("IDENT", "ELSEIF", "ELSEWHEN", "STRING", "UNCLOSED_STRING", "UNCLOSED_COMMENT")

    def process(self, stream: Iterator[Token]) -> Iterator[Token]:
        return stream


@cache
def language() -> Lark:
    """The parser; from the grammar itself if another version of Lark has serialised what is stored."""
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    if stored["lark"] != lark_version():
        return compiled(grammar_file().read_text(encoding="utf-8"))
    return _loaded(stored["data"], stored["memo"])


def compiled(grammar: str) -> Lark:
    """The parser of the text of a grammar."""
    return Lark(
        grammar,
        parser="lalr",
        lexer="contextual",
        maybe_placeholders=True,
        start=list(STARTS),
        postlex=_InEveryState(),
    )


def lark_version() -> str:
    """Major and minor version of Lark: within them the serialised form is the same."""
    return ".".join(lark.__version__.split(".")[:2])


def plain_lexer() -> BasicLexer:
    """The lexer that asks no parser: every word that may be a keyword is one."""
    frontend: Any = language().parser
    lexer = frontend.lexer.lexer.root_lexer
    assert isinstance(lexer, BasicLexer)
    return lexer


def _loaded(data: dict[str, Any], memo: dict[str, Any]) -> Lark:
    """The parser from what it was serialised to; JSON has made texts of the numbers of states and rules."""
    table = data["parser"]["parser"]
    table["states"] = {int(state): row for state, row in table["states"].items()}
    data["options"]["postlex"] = _InEveryState()
    return Lark.load({"data": data, "memo": {int(number): item for number, item in memo.items()}})
