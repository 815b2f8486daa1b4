"""The formatter: canonical, idempotent, faithful to trees and comments."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from choice import spread, together
from texts_of_syntax import CORPUS, TEXTS, expression, tree

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.layout import WIDTH
from lagdsl.language.syntax.printer import format_text, print_expression


def formatted(text: str) -> str:
    sink = Sink()
    found = format_text(SourceFile("t", text), sink)
    assert found is not None, [(d.code, d.message) for d in sink.diagnostics]
    return found


def with_end_names(unit: nodes.Unit) -> nodes.Unit:
    """The tree with the names after `end` filled in."""

    def complete(item):
        if not isinstance(item, nodes.Class):
            return item
        return replace(item, end_name=item.name, items=tuple(map(complete, item.items)))

    return replace(unit, items=tuple(map(complete, unit.items)))


def check(text: str) -> str:
    once = formatted(text)
    assert formatted(once) == once
    assert tree(once) == with_end_names(tree(text))
    assert re.findall(r"//[^\n]*|/\*[\s\S]*?\*/", once) == re.findall(r"//[^\n]*|/\*[\s\S]*?\*/", text)
    return once


@together("path", spread(TEXTS, 20))
def test_corpus(path):
    once = check(path.read_text(encoding="utf-8"))
    assert all(len(line) <= WIDTH or re.match(" *(model|joint) ", line) for line in once.split("\n"))
    assert not re.search(r"[ \t]\n|\n\n\n", once)


@pytest.mark.parametrize("name", ["pendulum", "four_bar", "every_statement", "layout"])
def test_text_of(name):
    """Files that are formatted already, or whose formatted text stands beside them."""
    beside = CORPUS / f"{name}.formatted"
    source = (CORPUS / f"{name}.lag").read_text(encoding="utf-8")
    assert formatted(source) == (beside.read_text(encoding="utf-8") if beside.exists() else source)


@together(
    "text",
    [
        "1/2*m*(l*der(theta))^2",
        "-g_n*world.y",
        "zs - zu",
        "a .* b ./ c",
        "P[i-1]",
        "q[1:N-1, :, 2*i+1]",
        "R*(sin(theta)*hoop.x - cos(theta)*hoop.y)",
        "if a < b and not c or d then 1 elseif e then 2 m/s2 else -3",
        "f(x, y = 2 kg)",
        "sum(der(q[i])^2 for i in 1:N, j in {1, 2})",
        "{i^2 for i in 1:3}",
        "[1, 2; 3, -4]",
        "(1, 2)",
        '"a\\"b\\\\c\\nd"',
        "5 /s",
        "5/s",
        "2 m / s",
        "5 m ^ 2",
        "2 m*s",
        "a - -b",
        "x^-y",
        "true",
        "world.rotz(psi).rotx(lean).origin",
        "[[1, 2]]",
        "{{1, 2}, {3, 4}}",
        "a <> b",
    ],
)
def test_canonical_expressions_stay(text):
    assert print_expression(expression(text)) == text


@together(
    ("text", "canonical"),
    [
        ("1  +2 *3", "1 + 2*3"),
        ("f( x,y=2 )", "f(x, y = 2)"),
        ("P[ i - 1 ]", "P[i-1]"),
        ("30deg", "30 deg"),
        ("5  /s", "5 /s"),
        ("2 m / (s)", "2 m / (s)"),
        ("{1,2}", "{1, 2}"),
        ("a<b", "a < b"),
        ("not(a)", "not (a)"),
        ("q[i - -1]", "q[i--1]"),
    ],
)
def test_spacing(text, canonical):
    assert print_expression(expression(text)) == canonical
    assert expression(canonical) == expression(text)


def test_end_gets_its_name():
    assert formatted("model M\n  model N end;\nend;") == "model M\n  model N\n  end N;\nend M;\n"


def test_blank_lines_are_kept_but_one_is_enough():
    text = "\n\nmodel M\n\n\n  Real x;\n\n\n\n  Real y;\n  Real z;\n\n\nend M;\n\n\n"
    assert check(text) == "model M\n\n  Real x;\n\n  Real y;\n  Real z;\n\nend M;\n"


def test_comments_stay_where_they_are():
    text = """\
// before
within Lag; // of the library
/* a block
   of lines */
model M "doc" // header
  // first
  Real x; // trailing
      /* odd */ Real y;

  // own, after a blank line
  for i in 1:3 loop // loop
    Real z; // z
    // last of the loop
  end for; // after the loop
  if a then // then
    Real b;
    // before elseif
  elseif c then
    // only a comment
  else // else
    Real d;
    // before end
  end if;
  // at the end of the declarations
equation // section
  x = 3; /* one */ // two
  // last
end M; // end
// after
"""
    once = check(text)
    assert once.split("\n")[0] == "// before"
    for line in (
        "within Lag;  // of the library",
        'model M "doc"  // header',
        "  Real x;  // trailing",
        "  for i in 1:3 loop  // loop",
        "    // last of the loop",
        "    // before elseif",
        "    // only a comment",
        "  else  // else",
        "  // at the end of the declarations",
        "equation  // section",
        "  x = 3;  /* one */  // two",
        "end M;  // end",
        "// after",
    ):
        assert line in once.split("\n")


def test_statement_with_a_comment_inside_keeps_its_lines():
    text = """\
model M
      parameter Real a = 1,  // first
                     b = 2;  // second
  Real c = f(/* why */ 3);
  Real d "two
   lines" /* kept */ ;
end M;
"""
    assert (
        check(text)
        == """\
model M
  parameter Real a = 1,  // first
                 b = 2;  // second
  Real c = f(/* why */ 3);
  Real d "two
   lines" /* kept */ ;
end M;
"""
    )


def test_comment_before_a_section_belongs_where_it_stands():
    text = "model M\n  Real x;\n// about the equations\nequation\n  x = 1;\nend M;\n"
    assert check(text) == text


def test_comments_in_odd_places_are_kept():
    check('model /* a */ M // b\n  "doc"\nend /* c */ M /* d */ ; // e')
    check("model M\nequation\n  if /* a */ b /* c */ then /* d */ x = 1; /* e */ end /* f */ if;\nend M;")
    check("model M\n  when a then\n    x = 1;\n  // b\n  elsewhen c then // d\n  end when;\nend M;")
    check("within /* a */ Lag /* b */ ;\nmodel M end M;")
    check("model M\ninitial /* a */ equation // b\n  x = 1;\nend M;")


def test_long_lists_wrap():
    names = ", ".join(f"name{i} = {i} kg" for i in range(30))
    once = check(f"model M parameter Mass {names}; end M;")
    lines = once.split("\n")
    assert len(lines) > 4 and all(len(line) <= WIDTH for line in lines)
    assert all(line.startswith("      name") for line in lines[2:-2])


def test_outer_places_break_first():
    once = check(
        "model M force F = -k*(norm(b - a) - rest)*unit(b - a)*some_long_factor + c*der(norm(b - a)) "
        'at some_rather_long_point on some_frame from another_point if active "and a text"; end M;'
    )
    first, *rest = once.split("\n")[1:-2]
    assert first.startswith("  force F") and rest
    assert rest[0].strip().split()[0] in ("at", "on", "from", "if") or rest[0].strip()[0] == '"'


def test_faults_give_no_text():
    sink = Sink()
    assert format_text(SourceFile("t", "model M Real x = ; end M;"), sink) is None
    assert [d.code for d in sink.diagnostics] == ["E0100"]


@pytest.mark.parametrize("folder", ["stdlib", "benchmarks/models"])
def test_texts_of_the_project_are_formatted(folder: str) -> None:
    """Those of models/ are looked at in tests/models."""
    paths = sorted((Path(__file__).parents[3] / folder).rglob("*.lag"))
    assert len(paths) > 20
    texts = {path.name: path.read_text(encoding="utf-8") for path in paths}
    assert [name for name, text in texts.items() if formatted(text) != text] == [], "run `lag fmt`"
