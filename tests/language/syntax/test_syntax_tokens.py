"""Tokens: words, numbers and units ("Text, numbers and units" in docs/reference/language.md)."""

import pytest
from choice import together
from texts_of_syntax import parsed

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax.language import all_states, language
from lagdsl.language.syntax.parser import parse_expression
from lagdsl.language.syntax.tokens import comments, lexer_state, plain_tokens
from lagdsl.language.syntax.vocabulary import vocabulary

WORDS, MARKS, RESERVED = vocabulary()


def tokens(text):
    return list(plain_tokens(text))


def lexers_of_states():
    """The lexers of the parser's states; states that accept the same share one."""
    lexers = language().lexers.lexers
    return list({id(lexers[state]): lexers[state] for state in all_states()}.values())


@together("word", [*WORDS])
def test_number_before_a_keyword_has_no_unit(word):
    number, after = tokens(f"2 {word}")
    assert (number.type, number.value, after.value) == ("NUMBER", "2", word)
    assert [t.value for t in tokens(f"2/{word}")] == ["2", "/", word]
    assert [t.value for t in tokens(f"2 /{word}")] == ["2", "/", word]


@together("unit", [unit for unit in UNITS if unit != "%"])
def test_every_unit_makes_a_quantity(unit):
    for text in (f"2 {unit}", f"2{unit}", f"2 /{unit}", f"2 m.{unit}2/{unit}^-3", f"2.5e-3 \t{unit}"):
        (quantity,) = tokens(text)
        assert quantity.type == "QUANTITY" and quantity.value == text


def test_percent_is_a_unit_without_exponent():
    """Behind it may stand a number that is divided by, in other languages."""
    for text in ("2 %", "2%", "2.5e-3 \t%"):
        (quantity,) = tokens(text)
        assert quantity.type == "QUANTITY" and quantity.value == text


@together("word", sorted(WORDS))
def test_words_are_names_unless_reserved(word):
    (plain,) = tokens(word)
    assert (plain.type == "IDENT") == (word not in RESERVED)


@together("word", sorted({*WORDS, "name", "_"}))
def test_no_state_of_the_parser_cuts_a_word(word):
    """A word is one token, a keyword at most where it is accepted; so is a word that begins with a keyword."""
    for lexer in lexers_of_states():
        for text in (word, f"{word}s", f"{word}1", f"{word}_", f"_{word}"):
            found = lexer.match(lexer_state(text, 0).text, 0)
            if found is None:
                assert text in RESERVED
            else:
                value, terminal = found
                assert value == text
                assert terminal in ("IDENT", *WORDS.get(text, ()))


@pytest.mark.parametrize(
    "text",
    [
        "model M mass m atP; end M;",
        "model M equation if a thenb = 1; end if; end M;",
        "model M equation when a then if b then x = 1; elsewhen c then x = 2; end when; end if; end when; end M;",
        "model M Real x = 1 ifb; end M;",
        "model M for i inx loop end for; end M;",
    ],
)
def test_keywords_are_whole_words(text):
    assert parsed(text)[0] is None


@together("word", sorted(set(WORDS) - RESERVED))
def test_soft_keywords_are_names_in_expressions(word):
    assert parse_expression(SourceFile("t", f"{word}.{word} + f({word}, a = {word})"), Sink()) is not None


@together(
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
    assert [token.value for token in tokens(text)] == parts


def test_two_marks_where_the_grammar_wants_two():
    assert parsed("import A.*; model M end M;")[1] == ()
    assert parsed("model M Real x = a.*b; end M;")[1] == ()


def test_comments_are_kept_apart():
    text = "a // one\n/* two\nlines */ b /**/"
    assert [token.value for token in tokens(text)] == ["a", "b"]
    assert [comment.text for comment in comments(text)] == ["// one", "/* two\nlines */", "/**/"]
    assert all(text[comment.start : comment.end] == comment.text for comment in comments(text))


def test_marks_of_comments_in_quotes_are_text():
    assert comments('a "// no" b / c "/* no */" // yes\n d') == comments(" " * 27 + "// yes")


@pytest.mark.parametrize(
    ("text", "values"), [("a /* b", ["a"]), ('a "b\nc', ["a", '"b"', "c"]), ("a θ @ b", ["a", "b"])]
)
def test_plain_tokens_go_on_behind_what_is_none(text, values):
    assert [token.value for token in tokens(text)] == values


def test_string_with_every_escape():
    (token,) = tokens(r'"a\\b\"c"')
    assert token.type == "STRING"
