"""Rendered diagnostics: the samples of the language reference, odd texts, and any text at all."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.foundation.diagnostics import CompilationFailed, Diagnostic, Label, Severity
from lagdsl.foundation.diagnostics.excerpt import WIDEST, printable
from lagdsl.foundation.diagnostics.render import render, render_all
from lagdsl.foundation.source import SourceFile, Span


def label(file: SourceFile, marked: str, text: str = "", occurrence: int = 0) -> Label:
    start = -1
    for _ in range(occurrence + 1):
        start = file.text.index(marked, start + 1)
    return Label(Span(file, start, start + len(marked)), text)


def error(*labels: Label, message: str = "wrong", **more) -> Diagnostic:
    return Diagnostic(code="E0999", severity=Severity.ERROR, message=message, labels=labels, **more)


def body(diagnostic: Diagnostic) -> list[str]:
    return render(diagnostic).splitlines()[2:]


def test_secondary_label_on_an_earlier_line():
    file = SourceFile(
        "pendulum.lag",
        "\n\n\n  coordinate Angle theta(start = 60 deg);\n\n  mass m at {l*sin(theta), -l*cos(thta)};\n",
    )
    diagnostic = Diagnostic(
        code="E0201",
        severity=Severity.ERROR,
        message="unknown name `thta`",
        labels=(
            label(file, "thta", "not declared in `Pendulum`"),
            label(file, "theta", "a coordinate with a similar name is declared here"),
        ),
        help="did you mean `theta`?",
    )
    assert render(diagnostic) == (
        "error[E0201]: unknown name `thta`\n"
        " --> pendulum.lag:6:35\n"
        "  |\n"
        "4 |   coordinate Angle theta(start = 60 deg);\n"
        "  |                    ----- a coordinate with a similar name is declared here\n"
        "6 |   mass m at {l*sin(theta), -l*cos(thta)};\n"
        "  |                                   ^^^^ not declared in `Pendulum`\n"
        "help: did you mean `theta`?\n"
    )


def test_two_labels_on_one_line():
    file = SourceFile("cart.lag", "\n" * 11 + "  potential V = -m*g_n*l*cos(a) + l*(1 - cos(b));\n")
    diagnostic = Diagnostic(
        code="E0401",
        severity=Severity.ERROR,
        message="cannot add an energy and a length",
        labels=(
            label(file, "l*(1 - cos(b))", "this is a length [m]"),
            label(file, "-m*g_n*l*cos(a)", "this is an energy [J]"),
        ),
        help="the second term is short by `kg.m/s2`; a factor `m*g_n` would make it an energy",
    )
    assert render(diagnostic) == (
        "error[E0401]: cannot add an energy and a length\n"
        "  --> cart.lag:12:35\n"
        "   |\n"
        "12 |   potential V = -m*g_n*l*cos(a) + l*(1 - cos(b));\n"
        "   |                 ---------------   ^^^^^^^^^^^^^^ this is a length [m]\n"
        "   |                 this is an energy [J]\n"
        "help: the second term is short by `kg.m/s2`; a factor `m*g_n` would make it an energy\n"
    )


def test_note_of_two_lines_and_warning():
    file = SourceFile("a.lag", "  connect(a, b);\n")
    diagnostic = Diagnostic(
        code="N0701",
        severity=Severity.NOTE,
        message="4 of 6 are redundant",
        labels=(label(file, "connect", "this closes the loop"),),
        notes=("3 - 2 = 1;\nreaction(D) is not determined",),
    )
    assert render(diagnostic) == (
        "note[N0701]: 4 of 6 are redundant\n"
        " --> a.lag:1:3\n"
        "  |\n"
        "1 |   connect(a, b);\n"
        "  |   ^^^^^^^ this closes the loop\n"
        "note: 3 - 2 = 1;\n"
        "      reaction(D) is not determined\n"
    )


def test_overlapping_labels_get_rows_of_their_own():
    file = SourceFile("a.lag", "abcdefgh")
    rows = body(error(label(file, "cd", "inner"), label(file, "abcdef", "outer"), label(file, "gh", "beside")))
    assert rows == ["  |", "1 | abcdefgh", "  |   ^^  -- beside", "  |   inner", "  | ------ outer"]


def test_span_of_several_lines():
    file = SourceFile("a.lag", "kinetic 1 +\n   2 +\n   3 +\n   4;\n")
    rows = body(error(Label(Span(file, 8, len(file.text) - 2), "too long")))
    assert rows == ["  |", "1 | kinetic 1 +", "  |         ^^^", "...", "4 |    4;", "  |    ^ too long"]
    adjacent = body(error(Label(Span(file, 8, 17), "")))
    assert "..." not in adjacent


def test_another_file_has_its_own_place():
    one, two = SourceFile("one.lag", "aaa"), SourceFile("two.lag", "\n\nbbb")
    text = render(error(label(one, "aaa", "here"), label(two, "bbb", "there")))
    assert " --> one.lag:1:1\n" in text
    assert " ::: two.lag:3:1\n  |\n3 | bbb\n  | --- there\n" in text


def test_no_label_at_all():
    assert render(error(message="no file", notes=("x",), help="y")) == "error[E0999]: no file\nnote: x\nhelp: y\n"


def test_tabs_wide_combining_and_control_characters():
    file = SourceFile("a.lag", "\tx 質量 e\u0301 \x1b[31m y")
    rows = body(error(label(file, "y", "here")))
    assert rows[1] == "1 |     x 質量 e\u0301 \\x1b[31m y"
    assert rows[2].index("^") == 4 + len("    x ") + 4 + len(" e ") + len("\\x1b[31m ")
    assert printable("a\u202eb\U000e0001") == "a\\u202eb\\U000e0001"


def test_long_lines_are_clipped_around_each_mark():
    file = SourceFile("a.lag", "a" + "x" * 100_000 + "target" + "y" * 100_000)
    text = render(error(label(file, "target", "here"), label(file, "a", "far away")))
    lines = text.splitlines()
    assert max(map(len, lines)) < WIDEST + 20
    assert lines[3].startswith("1 | ...xxx") and lines[3].endswith("yyy...")
    assert lines[4].index("^") == lines[3].index("target")
    assert lines[5].startswith("1 | axxx") and lines[6] == "  | - far away"
    assert max(map(len, render(error(label(file, "x" * 100_000))).splitlines())) < WIDEST + 20


def test_color_only_paints():
    file = SourceFile("a.lag", "aaa bbb")
    diagnostic = error(label(file, "aaa", "p"), label(file, "bbb", "s"), notes=("n",), help="h")
    colored = render_all([diagnostic], color=True)
    assert "\x1b[1;31merror[E0999]\x1b[0m" in colored
    plain = colored
    for code in ("1;31", "1;34", "1", "0"):
        plain = plain.replace(f"\x1b[{code}m", "")
    assert plain == render_all([diagnostic])


def test_blank_line_between_diagnostics():
    assert render_all([]) == ""
    assert render_all([error(), error()]) == "error[E0999]: wrong\n\nerror[E0999]: wrong\n"


def test_exception_shows_rendered_text():
    failure = CompilationFailed((error(message="no"),))
    assert str(failure) == "error[E0999]: no\n"


_TEXT = st.text(st.characters(codec="utf-8") | st.sampled_from("\n\t ab質\u0301\x00"), max_size=80)


@pytest.mark.no_cover
@given(_TEXT, st.lists(st.tuples(st.integers(-5, 90), st.integers(-5, 90), _TEXT), max_size=5), _TEXT, st.booleans())
def test_any_text_and_any_spans(text, places, message, color):
    file = SourceFile("\x1bname", text)
    labels = tuple(Label(Span(file, start, end), words) for start, end, words in places)
    out = render(error(*labels, message=message, notes=(message,), help=message), color)
    assert out.endswith("\n")
    plain = render(error(*labels, message=message, notes=(message,), help=message), False)
    assert not [c for c in plain if unicodedata.category(c) in ("Cc", "Cf") and c != "\n"]


@given(st.text("ab \t", min_size=1, max_size=60), st.data())
def test_caret_stands_under_its_character(text, data):
    at = data.draw(st.integers(0, len(text) - 1))
    file = SourceFile("a.lag", text)
    rows = body(error(Label(Span(file, at, at + 1))))
    column = rows[2].index("^") - 4
    expanded = "".join(rows[1][4:].ljust(column + 1))
    assert expanded[column] == (" " if text[at] == "\t" else text[at])


@pytest.mark.parametrize("end", [3, 4])
def test_span_that_ends_with_the_line_end(end):
    file = SourceFile("a.lag", "abc\ndef")
    assert body(error(Label(Span(file, 0, end))))[1:] == ["1 | abc", "  | ^^^"]
