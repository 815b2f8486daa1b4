"""The parser makes the trees of the language, every node with the place where it stands."""

import os
import re

import pytest
from choice import spread, together
from lark import Lark, Tree
from texts_of_syntax import CORPUS, TEXTS, dump, equation, expression, parsed, statement, tree

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.resources import grammar_file
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.print_expressions import quoted
from lagdsl.language.syntax.printer import print_expression
from lagdsl.language.syntax.session import Session
from lagdsl.language.syntax.tokens import plain_tokens
from lagdsl.language.syntax.vocabulary import vocabulary
from lagdsl.language.syntax.walk import children, descendants


@together("path", TEXTS)
def test_text_parses(path):
    unit, diagnostics = parsed(path.read_text(encoding="utf-8"))
    assert diagnostics == ()
    assert unit is not None and unit.items


@pytest.mark.parametrize("name", ["pendulum", "chain", "furuta", "planar_excerpt", "bouncing_ball", "every_statement"])
def test_tree(name):
    expectation = CORPUS / f"{name}.ast"
    found = dump(tree((CORPUS / f"{name}.lag").read_text(encoding="utf-8"))) + "\n"
    if os.environ.get("LAGDSL_UPDATE") or not expectation.exists():
        existed = expectation.exists()
        expectation.write_text(found, encoding="utf-8")
        assert existed, f"{expectation.name} was missing and has been written: read it"
    assert found == expectation.read_text(encoding="utf-8")


@together("path", spread(TEXTS, 40))
def test_spans_nest_and_cover_tokens(path):
    text = path.read_text(encoding="utf-8")
    tokens = list(plain_tokens(text))
    begins, ends = {token.start_pos for token in tokens}, {token.end_pos for token in tokens}
    unit = tree(text)
    for node in descendants(unit):
        assert node.span.start in begins and node.span.end in ends
        for child in children(node):
            assert node.span.start <= child.span.start <= child.span.end <= node.span.end


def test_span_of_every_kind_of_expression_is_its_text():
    text = "if a.b[1, 2] > -f(x, y = 2 m) then {1, (2)} else [1, 2; 3, 4]*sum(q[i] for i in 1:n)"
    whole = expression(text)
    spelled = {(type(node).__name__, node.span.text) for node in descendants(whole)}
    for kind, part in [
        ("Conditional", text),
        ("Branch", "a.b[1, 2] > -f(x, y = 2 m) then {1, (2)}"),
        ("Binary", "a.b[1, 2] > -f(x, y = 2 m)"),
        ("Index", "a.b[1, 2]"),
        ("Member", "a.b"),
        ("Unary", "-f(x, y = 2 m)"),
        ("Named", "y = 2 m"),
        ("Quantity", "2 m"),
        ("Array", "{1, (2)}"),
        ("Parenthesized", "(2)"),
        ("Matrix", "[1, 2; 3, 4]"),
        ("Reduction", "sum(q[i] for i in 1:n)"),
        ("Iterator", "i in 1:n"),
        ("Range", "1:n"),
    ]:
        assert (kind, part) in spelled


def test_names_have_places_of_their_own():
    declared = statement("parameter Mass mass_of = 1 kg;").declarators[0]
    assert declared.name_span.text == "mass_of"
    assert expression("a.b.origin").name_span.text == "origin"
    assert tree("package Planar end Planar;").items[0].name_span.text == "Planar"


@together(
    ("text", "grouped"),
    [
        ("-x^2", "(-(x^2))"),
        ("a - b - c", "((a-b)-c)"),
        ("a^b^c", "(a^(b^c))"),
        ("a^-b", "(a^(-b))"),
        ("-a*b", "((-a)*b)"),
        ("a/b*c", "((a/b)*c)"),
        ("a .* b ./ c", "((a.*b)./c)"),
        ("not a and b or c", "(((not a)and b)or c)"),
        ("a + b < c*d", "((a+b)<(c*d))"),
        ("+a", "(+a)"),
        ("1/2*m*v^2", "(((1/2)*m)*(v^2))"),
        ("2*m/s", "((2*m)/s)"),
        ("5/s", "(5/s)"),
        ("5 / s", "(5/s)"),
        ("f(x).y[1]", "f(x).y[1]"),
    ],
)
def test_precedence(text, grouped):
    def group(node):
        match node:
            case nodes.Binary():
                word = f"{node.operator} " if node.operator.isalpha() else node.operator
                return f"({group(node.left)}{word}{group(node.right)})"
            case nodes.Unary():
                return f"({'not ' if node.operator == 'not' else node.operator}{group(node.operand)})"
            case _:
                return print_expression(node)

    assert group(expression(text)) == grouped


@pytest.mark.parametrize(
    ("text", "number", "unit"),
    [
        ("9.81 m/s2", "9.81", "m/s2"),
        ("9.81 m/s^2", "9.81", "m/s^2"),
        ("5 N.m/rad", "5", "N.m/rad"),
        ("30deg", "30", "deg"),
        ("5 /s", "5", "/s"),
        ("5 s^-1", "5", "s^-1"),
        ("2e-3 kg.m2", "2e-3", "kg.m2"),
        ("2 kN.s/m", "2", "kN.s/m"),
    ],
)
def test_quantity_is_one_literal(text, number, unit):
    found = expression(text)
    assert isinstance(found, nodes.Quantity)
    assert (found.number, found.unit) == (number, unit)


def test_unit_is_greedy_over_division_but_not_over_products():
    assert print_expression(expression("2 m*s")) == "2 m*s"
    product = expression("2 m*s")
    assert isinstance(product, nodes.Binary) and isinstance(product.left, nodes.Quantity)
    assert isinstance(expression("2 m / s"), nodes.Binary)
    assert isinstance(expression("5 m^2"), nodes.Quantity)


def test_length_names_are_no_units():
    assert "l" not in UNITS and "L" not in UNITS


def test_words_are_keywords_only_where_statements_begin():
    assert statement("Mass mass = 1 kg;").declarators[0].name == "mass"
    assert statement("point block;").declarators[0].name == "block"
    assert statement("Mass joint;").declarators[0].name == "joint"
    assert statement("force force = force*force at at on on;").label == "force"
    assert statement("final parameter Real x = 1;").prefixes == ("final", "parameter")
    assert statement("mass m/2 at P;").mass == expression("m/2")


def test_keyword_like_variables_in_equations():
    assert equation("force = k*x;") == nodes.Equation(
        span=None, left=nodes.Reference(span=None, name="force"), right=expression("k*x"), doc=None
    )
    assert equation("k*x = force.x;").right == expression("force.x")
    assert equation("output Force F = 2 N;").prefixes == ("output",)
    assert isinstance(equation("force k*x on q;"), nodes.Load)
    for word in ("torque", "kinetic", "point", "state", "mass", "body"):
        assert equation(f"{word} = 1;").left.name == word


def test_force_with_material_points_on_both_sides():
    load = statement('force F = k*x at P on A from R on C if c "why";')
    assert (load.at, load.on, load.origin, load.origin_on) == tuple(map(expression, ("P", "A", "R", "C")))
    assert load.condition == expression("c") and load.doc == "why"
    assert statement("torque M on A from B;").at is None


def test_array_size_from_the_binding():
    assert isinstance(statement("parameter Inertia I[:] = {0, 0, 0};").declarators[0].subscripts[0], nodes.All)


def test_ranges():
    ranged = expression("q[1:2:n]").subscripts[0]
    assert (ranged.start, ranged.step, ranged.stop) == tuple(map(expression, ("1", "2", "n")))
    assert expression("q[1:n]").subscripts[0].step is None


def test_strings_resolve_escapes():
    assert expression(r'"a\"b\\theta\n"').value == 'a"b\\theta\n'
    assert expression('"two\nlines"').value == "two\nlines"
    assert expression(quoted('a"b\\c\nd\te')).value == 'a"b\\c\nd\te'


def test_end_without_name():
    assert tree("model M end;").items[0].end_name is None


def test_same_tree_whatever_the_layout():
    one = "model M parameter Real x=1+2*3;end M;"
    other = "model M // name\n\n  parameter /* c */ Real x = 1 + 2 * 3 ;\r\n\tend M ;"
    assert tree(one) == tree(other)


@pytest.mark.no_cover
def test_nodes_have_the_children_and_the_places_that_lark_gives_its_trees():
    """Lark's own trees of every text of the corpus, against what the builder hands to the makers of nodes."""
    lark = Lark(
        grammar_file().read_text(encoding="utf-8"),
        parser="lalr",
        lexer="contextual",
        maybe_placeholders=True,
        propagate_positions=True,
    )
    for path in TEXTS:
        text = path.read_text(encoding="utf-8")
        session = Session(SourceFile("t", text), Sink(), "start")
        session.builder.actions = _Trees()
        while not session.finished:
            assert session.shift(session.take())
        _assert_same(session.tree, lark.parse(text))


class _Trees(dict):
    """Every rule makes (its name, start, end, children)."""

    def __missing__(self, name):
        return lambda children, span: (name, span.start, span.end, children)


def _assert_same(ours, theirs):
    if not isinstance(theirs, Tree):
        assert ours == theirs
        return
    name, start, end, children = ours
    assert name == theirs.data
    if not theirs.meta.empty:
        assert (start, end) == (theirs.meta.start_pos, theirs.meta.end_pos)
    assert len(children) == len(theirs.children)
    for one, other in zip(children, theirs.children, strict=True):
        _assert_same(one, other)


def test_words_of_the_language_reference():
    """Section 3: sixteen words are reserved and no more."""
    words = "end if then elseif else for loop when elsewhen equation and or not true false in"
    assert frozenset(words.split()) == vocabulary().reserved
    assert all(re.fullmatch("[a-z]+", word) for word in vocabulary().reserved)
