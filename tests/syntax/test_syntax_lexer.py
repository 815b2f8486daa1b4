"""Tokens: rulings 1 and 2 of the language on words and units."""

import pytest
from texts_of_syntax import parsed

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile
from lagdsl.syntax import tables
from lagdsl.syntax.automaton import END_OF_TEXT
from lagdsl.syntax.lexer import IDENT, NUMBER, QUANTITY, RESERVED, STRING, Lexer


def tokens(text, accepted=()):
    lexer, found = Lexer(SourceFile("t", text), Sink()), []
    while (token := lexer.next(accepted)).terminal != END_OF_TEXT:
        found.append(token)
    return found


@pytest.mark.parametrize("word", [*tables.WORDS])
def test_number_before_a_keyword_has_no_unit(word):
    number, after = tokens(f"2 {word}")
    assert (number.terminal, number.text, after.text) == (NUMBER, "2", word)
    assert [t.text for t in tokens(f"2/{word}")] == ["2", "/", word]
    assert [t.text for t in tokens(f"2 /{word}")] == ["2", "/", word]


@pytest.mark.parametrize("unit", tables.UNITS)
def test_every_unit_makes_a_quantity(unit):
    for text in (f"2 {unit}", f"2{unit}", f"2 /{unit}", f"2 m.{unit}2/{unit}^-3", f"2.5e-3 \t{unit}"):
        (quantity,) = tokens(text)
        assert quantity.terminal == QUANTITY and quantity.text == text


@pytest.mark.parametrize("word", sorted(tables.WORDS))
def test_words_are_names_unless_accepted(word):
    (plain,) = tokens(word)
    (taken,) = tokens(word, accepted=tables.WORDS[word])
    assert (plain.terminal == IDENT) == (word not in RESERVED)
    assert taken.terminal in tables.WORDS[word]


@pytest.mark.parametrize("word", ["forces", "modelA", "end_", "point1", "_mass", "iff"])
def test_longer_words_are_names(word):
    assert tokens(word, accepted=range(100))[0].terminal == IDENT


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("5/s", ["5", "/", "s"]),
        ("5 / s", ["5", "/", "s"]),
        ("5 /s", ["5 /s"]),
        ("2*m/s", ["2", "*", "m", "/", "s"]),
        ("2 m*s", ["2 m", "*", "s"]),
        ("1:N", ["1", ":", "N"]),
        ("5 m/x", ["5 m", "/", "x"]),
        ("5 l", ["5", "l"]),
        ("a.*b", ["a", ".*", "b"]),
        ("a<=b<>c", ["a", "<=", "b", "<>", "c"]),
        ("f->g", ["f", "->", "g"]),
        ("5 m\n/s", ["5 m", "/", "s"]),
        ("5\nm", ["5", "m"]),
    ],
)
def test_cutting(text, parts):
    assert [token.text for token in tokens(text)] == parts


def test_two_marks_where_the_grammar_wants_two():
    assert parsed("import A.*; model M end M;")[1] == ()
    assert parsed("model M Real x = a.*b; end M;")[1] == ()


def test_comments_are_kept_apart():
    lexer = Lexer(SourceFile("t", "a // one\n/* two\nlines */ b /**/"), Sink())
    assert [lexer.next().text for _ in range(3)] == ["a", "b", ""]
    assert [comment.text for comment in lexer.comments] == ["// one", "/* two\nlines */", "/**/"]
    lexer.rewind(1)
    assert lexer.comments == []
    assert lexer.next().text == "b" and len(lexer.comments) == 2


def test_string_with_every_escape():
    (token,) = tokens(r'"a\\b\"c"')
    assert token.terminal == STRING
