"""Every fault of the text is told once, at the right place, with a way out. Places stand between ⟦ and ⟧."""

import pytest
from choice import together
from texts_of_syntax import parsed, places, unmarked

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax.parser import parse_expression


def model(body: str) -> str:
    return f"model M\n{body}\nend M;\n"


CASES = [
    # something that does not fit
    ("E0100", model("  Real x = ⟦;⟧"), "an expression"),
    ("E0100", model("  Real x ⟦3⟧;"), "`;`, `,`, `=` or `(`"),
    ("E0100", model("  force F ⟦;⟧"), "`at`, `on` or an operator"),
    ("E0100", model("  parameter ⟦;⟧"), "a type"),
    ("E0100", model("  Real x = 3 ⟦y⟧;").replace("3 ", "(3) "), None),
    ("E0100", model('  Real x = a ⟦"text"⟧ + 1;').replace('⟦"text"⟧ +', '"text" ⟦+⟧'), None),
    ("E0100", "model ⟦3⟧\n  Real x;\nend;\n", "the name of the model"),
    ("E0100", "model⟦;⟧\n  Real x;\nend;\n", "the name of the model"),
    ("E0100", "model M\nequation\n  x = 3 +⟦⟧", "an expression"),
    ("E0100", model("  Real x = (1)⟦.⟧;").replace("⟦.⟧;", ".⟦;⟧"), "a name"),
    ("E0100", model("  if a then\n  elseif ⟦*⟧ then\n    Real x;\n  end if;"), "an expression"),
    ("E0100", model("  when ⟦)⟧ then\n    x = 1;\n  end when;").replace("⟦)⟧", "⟦*⟧"), "an expression"),
    ("E0100", model("  for ⟦3⟧ loop\n    Real x;\n  end for;"), "a name"),
    ("E0100", model("equation\n  x ⟦:=⟧ 3;"), "`=`"),
    # missing `;`
    ("E0101", model("  parameter Mass m = 1 kg⟦⟧\n  Length l;"), None),
    ("E0101", model("  Real x⟦⟧ // comment\n\n  mass m at P;"), None),
    ("E0101", model("  Real x⟦⟧"), None),
    ("E0101", model("equation\n  x = 3⟦⟧\n  y = 4;"), None),
    ("E0101", model("equation\n  x = f(3)⟦⟧\n  annotation(a = 1);"), None),
    ("E0101", "model M\n  Real x;\nend M⟦⟧\nmodel N\nend N;\n", None),
    ("E0101", "model M\n  Real x;\nend M⟦⟧\n", None),
    # misspelt keywords
    ("E0102", model("  ⟦coordnate⟧ Angle q;"), "coordinate"),
    ("E0102", model("  ⟦masss⟧ m at P;"), "mass"),
    ("E0102", model("  ⟦Mass⟧ m at P;"), "mass"),
    ("E0102", model("  ⟦Force⟧ 1 N on x;"), "force"),
    ("E0102", model("  ⟦Dissipation⟧ 2*x;"), "dissipation"),
    ("E0102", model("  ⟦paramter⟧ Mass m = 1 kg;"), "parameter"),
    ("E0102", model("  ⟦gravty⟧ = 3;"), "gravity"),
    ("E0102", model("  ⟦constrant⟧ wire: x = 3;"), "constraint"),
    ("E0102", model("  ⟦kinetc⟧ 1/2*m;"), "kinetic"),
    ("E0102", model("  ⟦forse⟧ F = 3 N at P;"), "force"),
    ("E0102", "⟦modle⟧ M\n  Real x;\nend M;\n", "model"),
    ("E0102", model("  ⟦modle⟧ N\n    Real x;\n  end N;"), "model"),
    # bare equations
    ("E0103", model("  Real x;\n  ⟦x = 3⟧;\n  y = 4;\n  der(z) = 5;"), "line 3"),
    ("E0103", model("  ⟦der(x) = 3⟧;"), "equation"),
    ("E0103", model("  ⟦a.b[1] = 3⟧;"), "equation"),
    ("E0103", model('  ⟦assert(x > 0, "no")⟧;'), "equation"),
    ("E0103", model("  for i in 1:3 loop\n    ⟦x[i] = 3⟧;\n  end for;"), "equation"),
    # units
    ("E0104", model("  Real x = 5 m/s⟦/⟧s;"), "m/s2"),
    ("E0104", model("  Real x = 5 /s ⟦/⟧ kg2 + 1;"), "m/s2"),
    ("E0105", model("  Force F = 5 ⟦Nm⟧;"), "`N.m`"),
    ("E0105", model("  kinetic 2 ⟦der⟧(x)^2;"), "2*der"),
    ("E0108", model("  ⟦#⟧ (a note in another language\n  Real x = 3;"), "//"),
    ("E0105", model("  Real x = 2 ⟦x⟧ + 1;"), "`2*x`"),
    ("E0105", model("  Real x = 2⟦abc⟧;"), "`2*abc`"),
    ("E0105", model("  Real x = 5 ⟦N.foo⟧;"), None),
    ("E0105", model("  Real x = 5 ⟦m10⟧;"), None),
    ("E0105", model("  Real x = {5 ⟦m^x⟧, 3};"), None),
    ("E0105", model("  Real x = 5 ⟦l⟧;"), None),
    # comments, characters, strings
    ("E0107", "model M\nend M;\n⟦/*⟧ no end\n", "*/"),
    ("E0108", model("  Real ⟦θ⟧ = 3;"), "theta"),
    ("E0108", model("  Real x = a ⟦&&⟧ b;"), "`and`"),
    ("E0108", model("  Real x = a ⟦!=⟧ b;"), "`<>`"),
    ("E0108", model("  Real x = a ⟦−⟧ b;"), "`-`"),
    ("E0108", model("  Real x; ⟦\0⟧"), None),
    ("E0126", model('  Real x = 1 ⟦"⟧the mass;\n  Real y = 2 "the other";'), '"'),
    ("E0126", model('  Real x = f("a", ⟦"⟧b);'), '"'),
    ("E0126", model('  draw text(⟦"⟧a);\n  draw text("+");\n  draw text("-");'), '"'),
    # brackets
    ("E0110", model("  Real x = 3 + 4⟦)⟧;"), None),
    ("E0110", model("  Real x = {1}⟦}⟧;"), None),
    ("E0111", model("  mass m at {l*sin⟦(⟧theta, -l*cos(theta)};"), "`)`"),
    ("E0111", model("  Real x = ⟦(⟧3 + 4;\n  Real y = 3;"), "`)`"),
    ("E0111", model("  coordinate Angle q⟦(⟧start = 3;\n  Real y = 3;"), "`)`"),
    ("E0111", model("  Real x = f⟦(⟧3\n  mass m at P;"), "`)`"),
    ("E0111", model("  Real x = ⟦[⟧1, 2;\n  Real y = 3;"), "`]`"),
    ("E0111", model("  Real x = 3*⟦(⟧"), "`)`"),
    ("E0111", "model M\n  Real x = ⟦{⟧1", "`}`"),
    ("E0112", model("  Real x = f(1⟦]⟧;"), "`)`"),
    ("E0112", model("  Real x = {1⟦)⟧;"), "`}`"),
    ("E0112", model("  Real x = {⟦)⟧;"), "`}`"),
    # blocks
    ("E0113", "⟦model Pendulum⟧\n  Real x;\n", "end Pendulum;"),
    ("E0113", model("  ⟦for⟧ i in 1:3 loop\n    Real x;"), "end for;"),
    ("E0113", model("equation\n  ⟦if⟧ a then\n    x = 1;\n  else\n    x = 2;"), "end if;"),
    ("E0113", model("equation\n  ⟦when⟧ a then\n    x = 1;"), "end when;"),
    ("E0113", "package P\n  ⟦model M⟧\n    Real x;\nend P;", "end M;"),
    ("E0113", "model M\n  ⟦for⟧ i in 1:3 loop\n    Real x;\n  end", "end for;"),
    ("E0114", "model Pendulum\nend ⟦Pendlum⟧;\n", "end Pendulum;"),
    ("E0120", model("  Real x;\n  ⟦end for⟧;\n  Real y;"), None),
    ("E0120", model("  Real x;\n  ⟦end for⟧\n  Real y;"), None),
    ("E0120", model("  for i in 1:3 loop\n    Real x;\n  ⟦end if⟧;"), None),
    ("E0120", model("  for i in 1:3 loop\n    Real x;\n  ⟦end if⟧;\n  Real y;\n  end for;"), None),
    (
        "E0120",
        model("  for i in 1:3 loop\n    Real x;\n  ⟦end if⟧;\n  for i in 1:3 loop\n    Real y;\n  end for;"),
        None,
    ),
    ("E0120", "model M\nend M;\n⟦end⟧ M;\n", None),
    # names
    ("E0115", model("  parameter Real ⟦end⟧ = 3;"), "end_"),
    ("E0115", model("  Real x = ⟦in⟧ + 2;"), "in_"),
    ("E0115", model('  Real x, ⟦loop⟧ "doc";'), "loop_"),
    ("E0115", 'model ⟦for⟧ "doc"\nend;\n', "for_"),
    ("E0124", model(f"  Real ⟦{'x' * 300}⟧;"), None),
    ("E0124", model(f'  Real x "{"x" * 20_000}";').replace('"', '⟦"', 1).replace('";', '"⟧;'), None),
    ("E0124", model(f"  Real x = ⟦{'1' * 200}⟧ kg;"), None),
    # numbers
    ("E0116", model("  Real x = ⟦1e999999⟧;"), "large"),
    ("E0116", model("  Mass x = ⟦1e999⟧ kg;"), "large"),
    ("E0116", model("  Real x = ⟦0.001e-9999⟧;"), "small"),
    ("E0127", model("  Real x = 1⟦.⟧e;"), "`1.0`"),
    # statements that are being typed above others
    ("E0139", model("  parameter Mass⟦⟧\n  parameter Real k = 3;"), "parameter Mass m = 1 kg;"),
    ("E0139", model("  p⟦⟧\n  parameter Real k = 3;"), None),
    ("E0139", model("  Real y =⟦⟧\n  R.Gear gear(ratio = 3);"), None),
    ("E0139", model("  torque 2*x⟦⟧\n  x.y a;"), "torque value on theta;"),
    ("E0139", model("  mass⟦⟧"), "mass m at {x, y};"),
    ("E0139", model("  Real y =⟦⟧\nequation\n  x = 3;"), None),
    ("E0139", model("  gravity⟦⟧\ninitial equation\n  x = 3;"), "gravity = -g_n*world.y;"),
    ("E0139", "function f⟦⟧\npartial model M\n  Real x = 3;\nend M;\n", "function f(Real x)"),
    ("E0111", model("  Link a⟦(⟧l =\n  R.Gear gear(ratio = 3);"), "`)`"),
    ("E0101", model("  Real x = a⟦⟧\n  B b(c = 3);"), "`;`"),
    ("E0100", model("  Real x = a +\n      b ⟦c⟧;"), None),
    ("E0113", model("  ⟦for⟧ i in 1:3 loop\n  gravity = 0;\nprotected\n  Real z = 4;"), "end for;"),
    ("E0113", model("equation\n  ⟦when⟧ a then\n    x = 1;\ninitial equation\n  x = 3;"), "end when;"),
    # sections and shapes
    ("E0117", "⟦parameter⟧ Real x = 3;\nReal y;\ncoordinate Angle q;\n", "model Name"),
    ("E0117", "⟦Real⟧ y;\nmodel M\nend M;\n", "model Name"),
    ("E0117", "model M\nend M;\n⟦x⟧ = 3;\n", "model Name"),
    ("E0118", model("equation\n  Real ⟦y⟧ = 3;\n  x = 2;"), None),
    ("E0118", model("equation\n  Lib.Spring ⟦s⟧(k = 2);"), None),
    ("E0119", model("equation\n  ⟦force⟧.x = 3;"), "`... = force.x;`"),
    ("E0119", model("equation\n  ⟦force⟧[1] = 3;"), "`... = force[1];`"),
    ("E0119", model("equation\n  ⟦point⟧.x + 1;"), "`... = point.x+1;`"),
    ("E0121", model("  Real x = ⟦2⟧(3 + y);"), "2*(3 + y)"),
    ("E0121", model("  Real x = ⟦(a + b)⟧(c);"), "(a + b)*(c)"),
    ("E0122", model("  Real⟦[3]⟧ x = {1, 2, 3};"), "`Real x[3]`"),
    ("E0122", model("  parameter Real⟦[3, n]⟧ x;"), "`Real x[3, n]`"),
    ("E0123", model("  for i in 1:3⟦⟧\n    Real x;\n  end for;"), "`loop`"),
    ("E0123", model("equation\n  when a⟦⟧\n    x = 3;\n  end when;"), "`then`"),
    ("E0125", model("equation\n  x = a < b ⟦<⟧ c;"), "a < b and b < c"),
    ("E0125", model("equation\n  x = y == 1 ⟦==⟧ z;"), None),
    # the text as a whole
    ("E0135", "", None),
    ("E0135", "  // nothing\n", None),
]


@together(("code", "marked", "help_part"), CASES)
def test_fault(code, marked, help_part):
    text, expected = unmarked(marked)
    unit, diagnostics = parsed(text)
    assert unit is None
    assert [d.code for d in diagnostics] == [code], [(d.code, d.labels[0].span.text) for d in diagnostics]
    assert places(diagnostics) == expected
    if help_part is not None:
        told = [diagnostics[0].help or "", diagnostics[0].message, *(label.text for label in diagnostics[0].labels)]
        assert any(help_part in part for part in told), told


def test_every_code_of_the_parser_is_tested():
    elsewhere = {"N0106", "N0199", "E0109", "E0130", "E0131", "E0132", "E0133", "E0134", "E0136", "E0137", "E0138"}
    family = {code for code in ROWS if code[1:3] == "01"}
    assert family - elsewhere == {code for code, _, _ in CASES}


def test_many_faults_of_one_text():
    marked = model(
        "  parameter Mass m = 1 kg⟦⟧\n"
        "  ⟦coordnate⟧ Angle q;\n"
        "  Real x = 3 + 4⟦)⟧;\n"
        "  Force F = 5 ⟦Nm⟧;\n"
        "  Real ⟦end⟧ = 3;\n"
        "  ⟦x = 3⟧;\n"
        "  Real z = ⟦;⟧\n"
        "  for i in 1:3 loop\n"
        "    ⟦masss⟧ m at P;\n"
        "    Real y = ⟦;⟧\n"
        "  end for;\n"
        "equation\n"
        "  x = a < b ⟦<⟧ c;\n"
        "  ⟦force⟧.x = 3;\n"
        "  Real ⟦y⟧ = 3;"
    )
    text, expected = unmarked(marked)
    unit, diagnostics = parsed(text)
    assert unit is None
    assert places(diagnostics) == expected


def test_faults_come_in_the_order_of_the_text():
    _, diagnostics = parsed(model("  Real x = ;\n  Real y = ;\n  Real z = ;"))
    starts = [d.labels[0].span.start for d in diagnostics]
    assert starts == sorted(starts) and len(starts) == 3


def test_second_label_says_why():
    _, (diagnostic,) = parsed(model("  Real x = f(1];"))
    assert diagnostic.labels[1].span.text == "(" and diagnostic.labels[1].text


@pytest.mark.parametrize(
    ("code", "marked"),
    [
        ("E0100", "1 +⟦⟧"),
        ("E0100", "a ⟦;⟧ b"),
        ("E0105", "2000 ⟦gg⟧"),
        ("E0110", "1⟦)⟧"),
        ("E0111", "f⟦(⟧1"),
        ("E0100", "a ⟦end⟧"),
        ("E0108", "a ⟦§⟧"),
        ("E0100", "⟦⟧"),
        ("E0100", "(a ⟦b⟧ c)"),
    ],
)
def test_fault_of_an_expression(code, marked):
    text, expected = unmarked(marked)
    sink = Sink()
    assert parse_expression(SourceFile("--set", text), sink) is None
    assert [d.code for d in sink.diagnostics] == [code]
    assert places(sink.diagnostics) == expected


@pytest.mark.parametrize(
    "text",
    [
        "package P\n  model M\n  when a then\n end P;",
        "model M\n for",
        "model M\n for i",
        "model M\n if a",
        "model",
        "model M\n Real x =",
        "model M\n end",
        "model M\n end for",
        "package P\n model M\n for i in 1:2 loop\n end P; end for; end M; end P;",
    ],
)
def test_unfinished_texts_are_told(text):
    unit, diagnostics = parsed(text)
    assert unit is None and 1 <= len(diagnostics) <= 5


def test_same_file_twice_in_one_sink():
    """A text with faults stays without a tree however often it is read."""
    sink, file = Sink(), SourceFile("t", "model M Real x = 5 Nm; end M;")
    from lagdsl.language.syntax.parser import parse

    assert parse(file, sink) is None and parse(file, sink) is None
    assert len(sink.diagnostics) == 1


def test_words_of_messages_are_those_of_users():
    """No terminal of the grammar shows in a message."""
    from lagdsl.language.syntax.language import all_states

    symbols = {symbol for row in all_states().values() for symbol in row}
    names = {name for name in symbols if "_" in name or (name.isupper() and len(name) > 3)}
    for _, marked, _ in CASES:
        for diagnostic in parsed(unmarked(marked)[0])[1]:
            told = " ".join((diagnostic.message, diagnostic.help or "", *(x.text for x in diagnostic.labels)))
            assert not [name for name in names if name in told.split()]
