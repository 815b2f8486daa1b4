"""The stored parser is Lark's for the grammar, and nothing computes it anew at run time."""

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from lark.common import LexerConf
from lark.lexer import ContextualLexer
from texts_of_syntax import TEXTS

from lagdsl.foundation import resources
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax import generate, language
from lagdsl.language.syntax.vocabulary import vocabulary

ROOT = Path(__file__).parents[3]


def run(code: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, **environment},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return done.stdout


def test_what_is_stored_is_the_parser_of_the_grammar():
    text = generate.stored_text(resources.grammar_file().read_text(encoding="utf-8"))
    assert text == language.STORED.read_text(encoding="utf-8"), "run `python -m lagdsl.language.syntax.generate`"


def test_what_is_stored_does_not_depend_on_the_hash_seed():
    code = (
        "import hashlib; from lagdsl.foundation.resources import grammar_file;"
        "from lagdsl.language.syntax.generate import stored_text;"
        "print(hashlib.sha256(stored_text(grammar_file().read_text(encoding='utf-8')).encode()).hexdigest())"
    )
    assert run(code, PYTHONHASHSEED="1").strip() == hashlib.sha256(language.STORED.read_bytes()).hexdigest()


def test_main_writes_what_is_stored(tmp_path, monkeypatch):
    monkeypatch.setattr(generate, "STORED", tmp_path / "grammar.jsonl")
    generate.main()
    assert (tmp_path / "grammar.jsonl").read_bytes() == language.STORED.read_bytes()


def test_what_another_version_of_lark_has_stored_is_not_read(tmp_path, monkeypatch):
    """Nothing of it is looked at but the version; the parser is that of the grammar."""
    (tmp_path / "grammar.jsonl").write_text(json.dumps({"lark": "0.1"}))
    monkeypatch.setattr(language, "STORED", tmp_path / "grammar.jsonl")
    anew, stored = language.language.__wrapped__(), language.language()
    assert anew.terminals.keys() == stored.terminals.keys()
    text = "model M Real x = 3 kg; mass m at {x, 0}; end M;"
    assert tokens(anew.parser(text, "start")) == tokens(stored.parser(text, "start"))


def tokens(parser):
    """Tokens of a text, with the lexer driven by the states of the parser."""
    return [(token.type, str(token), token.start_pos, token.end_pos) for token in parser.iter_parse()]


def test_our_lexer_and_that_of_lark_read_the_same():
    grammar = language.compiled(resources.grammar_file().read_text(encoding="utf-8"))
    for path in TEXTS:
        text = path.read_text(encoding="utf-8")
        found = tokens(language.language().parser(text, "start"))
        assert found == tokens(grammar.parse_interactive(text, "start")), path.name


def test_lexers_of_states_are_those_of_lark():
    """The terminals that each state tries, in their order, and the words that are keywords there."""
    whole = language.plain_lexer()
    conf = LexerConf(list(whole.terminals), re, whole.ignore_types, skip_validation=True)
    states = language.all_states()
    theirs = ContextualLexer(conf, states, always_accept=language._InEveryState.always_accept)
    for state in states:
        ours, other = language.language().lexers.lexers[state], theirs.lexers[state]
        assert ours.ignore_types == other.ignore_types and ours.newline_types == other.newline_types
        assert other.scanner.terminals == [t for t in whole.scanner.terminals if t.name in ours._accepted]
        keywords = {
            name: {text: kind for text, kind in whole.keywords[name].items() if kind in ours._accepted}
            for name in ours.callback
        }
        unless = {n: {t.pattern.value: t.name for t in c.scanner.terminals} for n, c in other.callback.items()}
        assert {name: words for name, words in keywords.items() if words} == unless


def test_parsing_loads_nothing_heavy():
    code = (
        "import sys; from lagdsl.foundation.source import SourceFile; from lagdsl.foundation.diagnostics import Sink;"
        "from lagdsl.language.syntax.parser import parse;"
        "assert parse(SourceFile('t', 'model M Real x = 3 kg; end M;'), Sink());"
        "print([name for name in ('lark.tools', 'numpy', 'sympy', 'scipy', 'rich', 'pint') if name in sys.modules])"
    )
    assert run(code) == "[]\n"


def test_units_are_no_keywords():
    words, _, reserved = vocabulary()
    assert not set(UNITS) & (set(words) | reserved)


def test_units_are_those_of_the_vocabulary():
    from lagdsl.foundation.units.generate import unit_names

    assert len(unit_names()) > 60
    assert sorted(unit_names()) == sorted(UNITS)


def test_no_state_takes_a_word_for_two_keywords():
    for state, accepted in language.all_states().items():
        for word, terminals in vocabulary().words.items():
            assert sum(terminal in accepted for terminal in terminals) <= 1, (state, word)
