"""Hostile and absurd texts: a diagnostic, bounded time and memory, no traceback."""

import time

import pytest
from choice import ALL, spread
from texts_of_syntax import expression, parsed

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.render import render_all
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import limits
from lagdsl.language.syntax.parser import parse
from lagdsl.language.syntax.printer import format_text, print_expression
from lagdsl.language.syntax.recursion import deep_recursion

SECONDS = 8.0  # far beyond what is needed: these tests guard against quadratic time, not against slow machines
PART = 1 if ALL else 3  # a megabyte, or a third of it, which would take as much too long if time were quadratic


def model(body: str) -> str:
    return f"model M\n{body}\nend M;\n"


def codes(text: str) -> list[str]:
    begun = time.process_time()
    unit, diagnostics = parsed(text)
    assert time.process_time() - begun < SECONDS
    assert (unit is None) == any(d.code.startswith("E") for d in diagnostics)
    return [d.code for d in diagnostics]


@pytest.mark.parametrize(
    "body",
    [
        "  Real x = " + "(" * 10_000 + "1" + ")" * 10_000 + ";",
        "  Real x = " + "[" * 100_000,
        "  Real x = " + "{" * 100_000 + ";",
        "  Real x = " + "+".join("x" * 5000) + ";",
        "  Real x = " + "^".join("x" * 5000) + ";",
        "  Real x = " + "-" * 100_000 + "x;",
        "  Real x = " + "if a then b else " * 5000 + "x;",
        "  Real x = a" + ".b" * 100_000 + ";",
        "  a" + ".b" * 100_000 + " x;",
        "  Real x = " + "f(" * 5000 + ")" * 5000 + ";",
        "  Real x" + "(a" * 5000 + ")" * 5000 + ";",
        "  if a then\n" * 20_000,
        "  for i in 1:2 loop\n" * 20_000,
        "  model N\n" * 20_000,
    ],
)
def test_depth_has_a_limit(body):
    assert codes(model(body)) in (["E0109"], ["E0138"])


@pytest.mark.parametrize(("opening", "closing"), [("(", ")"), ("{", "}"), ("f(", ")"), ("((", "))"), ("a[", "]")])
def test_brackets_are_told_as_brackets(opening: str, closing: str) -> None:
    text = model("  Real x = " + opening * 500 + "1" + closing * 500 + ";")
    sink = Sink()
    assert parse(SourceFile("deep.lag", text), sink) is None
    (found,) = sink.diagnostics
    assert found.code == "E0138" and f"{limits.MAX_BRACKETS} brackets" in found.message


HIDDEN = [chr(code) for code in (0x061C, 0x200E, 0x200F, *range(0x202A, 0x202F), *range(0x2066, 0x206A))]


@pytest.mark.parametrize("character", HIDDEN)
@pytest.mark.parametrize(
    "place", ["  // {} note", "  /* a\n {} */", '  Real x = 1 "{} doc";', '  Real x = 1 "{}"; // "', "  Real {}x = 1;"]
)
def test_hidden_turns_of_the_text_are_refused(place: str, character: str) -> None:
    assert codes(model(place.format(character))) == ["E0137"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\u05d0\u05d1", []),
        ("\u2067\u05d0\u05d1\u2069", []),
        ("\u202b\u0627\u202c and \u200f", []),
        ("\u2067\u05d0", ["E0137"]),
        ("\u05d0\u2069", ["E0137"]),
        ("\u202e\u2066\u05d0\u202c\u2069", ["E0137"]),
        ("\u2067abc\u2069", ["E0137"]),
    ],
)
def test_strings_from_right_to_left_may_say_so(text: str, expected: list[str]) -> None:
    assert codes(model(f'  Real x = 1 "{text}";')) == expected
    assert codes(model(f'  Real x = 1; // "{text}"')) == (expected or (["E0137"] if text != "\u05d0\u05d1" else []))


UNSEEN = [
    "\x07",
    "\x1b",
    "\x7f",
    "\x9b",
    "\xad",
    "\u200b",
    "\u2060",
    "\u2064",
    "\u3164",
    "\ufeff",
    "\U000e0041",
    "\U000e0101",
]


@pytest.mark.parametrize("character", [*UNSEEN, "\u200d", "\ufe0f"])
def test_what_takes_no_room_hides_no_text(character: str) -> None:
    for place in ("  // a{} note", "  /* a{}\n */", '  Real x = 1 "a{} doc";'):
        assert codes(model(place.format(character))) == ["E0137"]


@pytest.mark.parametrize(
    "text", ["\u2764\ufe0f", "\U0001f469\u200d\U0001f52c", "\u0915\u094d\u200d\u0937", "\u0645\u06cc\u200c\u062e"]
)
def test_joined_letters_and_pictures_are_texts(text: str) -> None:
    assert codes(model(f'  Real x = 1 "{text}"; // {text}')) == []


def test_the_message_shows_no_such_character() -> None:
    sink = Sink()
    parse(SourceFile("turned.lag", model("  Real x = 1; // \u202e\u2066 text")), sink)
    shown = render_all(sink.diagnostics)
    assert "U+202E, U+2066" in shown and not any(character in shown for character in HIDDEN)


def test_just_within_the_limits():
    assert codes(model("  Real x = " + "+".join("x" * (limits.MAX_DEPTH - 20)) + ";")) == []
    assert (
        codes(model("  Real x = " + "(" * (limits.MAX_BRACKETS - 1) + "1" + ")" * (limits.MAX_BRACKETS - 1) + ";"))
        == []
    )
    assert codes(model(f"  Real {'x' * limits.MAX_NAME} = {'1' * limits.MAX_NUMBER};")) == []


def test_deep_trees_print_and_compare():
    for text in ("+".join("x" * 900), "^".join("x" * 900), "-" * 900 + "x", "if a then b else " * 400 + "c"):
        tree = expression(text)
        assert print_expression(tree).replace(" ", "") == text.replace(" ", "")
        with deep_recursion():
            assert tree == expression(text)


def test_ten_megabytes_are_refused_at_once():
    begun = time.process_time()
    assert codes(" " * 10_000_000) == ["E0130"]
    assert time.process_time() - begun < SECONDS
    sink = Sink()
    assert format_text(SourceFile("t", "x" * (limits.MAX_CHARACTERS + 1)), sink) is None
    assert [d.code for d in sink.diagnostics] == ["E0130"]


@pytest.mark.parametrize(
    "text",
    [
        ")" * (999_000 // PART),
        model(")" * (999_000 // PART)),
        model("  Real 3 x;\n" * (80_000 // PART)),
        model("  Real 3 x;" * (80_000 // PART)),
        model(";" * (999_000 // PART)),
        "@" * (999_000 // PART),
        "@ " * (499_000 // PART),
        "\0" * (999_000 // PART),
        "θ " * (499_000 // PART),
        model("  Real x = [1;" * (70_000 // PART)),
        model("  Real x = 1e9999;" * (50_000 // PART)),
    ],
)
def test_a_megabyte_of_errors_stops(text):
    found = codes(text)
    assert len(found) == limits.MAX_ERRORS + 1
    assert found[-1] == "N0199"


@pytest.mark.parametrize(
    "text",
    spread(
        [
            '"' * (499_001 // PART),
            '"\\' * (249_000 // PART),
            '"\n' * (249_000 // PART),
            "/*" * (249_000 // PART),
            model("  Real x = " + ("3" + " " * 1000) * (900 // PART)),
            model("  Real x = " + "1" * (900_000 // PART) + ";"),
            model("  Real " + "x" * (900_000 // PART) + ";"),
            model('  Real x "' + "x" * (900_000 // PART) + '";'),
            model("  Real x = 5 " + "m." * (400_000 // PART) + "q;"),
            model("mass " * (90_000 // PART)),
            model("end " * (90_000 // PART)),
            model("for " * (90_000 // PART)),
            model("if " * (90_000 // PART)),
            model("Real " * (90_000 // PART)),
            model("( " * (90_000 // PART) + ";" * 1000),
            model("Real x = f(1\n" * (20_000 // PART)),
        ],
        6,
    ),
)
def test_anything_is_told_in_time(text):
    assert codes(text)


def test_many_thousand_declarators():
    assert codes(model("  Real " + ", ".join(f"x{i}" for i in range(20_000)) + ";")) == []


def test_carriage_returns():
    assert codes("model M\r\n  Real x = 3;\r\nend M;\r\n") == []
