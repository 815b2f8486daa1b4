"""Random expressions survive printing and reading; random and mutilated texts get an answer."""

import pytest
from choice import examples, spread, together
from hypothesis import given, settings
from hypothesis import strategies as st
from texts_of_syntax import TEXTS, expression, parsed

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse_expression
from lagdsl.language.syntax.printer import format_text, print_expression
from lagdsl.language.syntax.tokens import plain_tokens
from lagdsl.language.syntax.vocabulary import vocabulary

WORDS, MARKS, RESERVED = vocabulary()
SOURCES = [path.read_text(encoding="utf-8") for path in TEXTS]
LEVELS = {
    "or": 1,
    "and": 2,
    "<": 4,
    "==": 4,
    ">=": 4,
    "<>": 4,
    "+": 5,
    "-": 5,
    "*": 6,
    "/": 6,
    ".*": 6,
    "./": 6,
    "^": 8,
}
S = {"span": None}  # spans do not take part in comparison

names = st.from_regex("[A-Za-z_][A-Za-z0-9_]{0,5}", fullmatch=True).filter(lambda name: name not in RESERVED)
soft_words = st.sampled_from(sorted(set(WORDS) - RESERVED))
numbers = st.from_regex(r"[0-9]{1,4}(\.[0-9]{1,4})?([eE][+-]?[0-9])?", fullmatch=True).filter(lambda n: True)
# A percent sign has no power.
powers = st.builds("{}{}".format, st.sampled_from(sorted({*UNITS} - {"%"})), st.sampled_from(["", "2", "^3", "^-1"]))
units = st.builds(
    "".join,
    st.lists(
        powers | st.just("%"),
        min_size=1,
        max_size=3,
    ).map(lambda parts: [".".join(parts[:2]), *(["/" + parts[2]] if len(parts) == 3 else [])]),
)
references = st.builds(lambda name: nodes.Reference(**S, name=name), names | soft_words)
# Strings hold no characters that are not seen (E0137): controls, marks without a letter, fillers.
SEEN = st.characters(
    codec="utf-8", exclude_categories=("C", "Mn", "Zl", "Zp"), exclude_characters="\u115f\u1160\u3164\uffa0"
)
leaves = (
    references
    | st.builds(lambda text: nodes.Number(**S, text=text), numbers)
    | st.builds(lambda number, unit: nodes.Quantity(**S, number=number, unit=unit), numbers, units)
    | st.builds(lambda value: nodes.String(**S, value=value), st.text(SEEN | st.sampled_from('\n\t"\\'), max_size=8))
    | st.builds(lambda value: nodes.Boolean(**S, value=value), st.booleans())
)


def level(node: nodes.Expression) -> int:
    match node:
        case nodes.Conditional():
            return 0
        case nodes.Binary():
            return LEVELS[node.operator]
        case nodes.Unary():
            return 3 if node.operator == "not" else 7
        case _:
            return 9


def at_least(node: nodes.Expression, least: int) -> nodes.Expression:
    """The node, in brackets if its operator binds too loosely."""
    return node if level(node) >= least else nodes.Parenthesized(**S, inner=node)


def binary(operator: str, left: nodes.Expression, right: nodes.Expression) -> nodes.Expression:
    own = LEVELS[operator]
    leftmost, rightmost = (own, own + 1) if own < 8 and own != 4 else (own + 1, own + 1)
    if own == 6 and isinstance(right, nodes.Unary):
        rightmost = 7
    if own == 8:
        rightmost = 8
        if isinstance(right, nodes.Unary) and right.operator == "-" and level(right.operand) >= 8:
            rightmost = 7
    return nodes.Binary(**S, operator=operator, left=at_least(left, leftmost), right=at_least(right, rightmost))


def unary(operator: str, operand: nodes.Expression) -> nodes.Expression:
    least = 4 if operator == "not" else 8
    return nodes.Unary(**S, operator=operator, operand=at_least(operand, least))


def extended(inner: st.SearchStrategy[nodes.Expression]) -> st.SearchStrategy[nodes.Expression]:
    several = st.lists(inner, min_size=1, max_size=3).map(tuple)
    named = st.builds(lambda name, value: nodes.Named(**S, name=name, value=value), names, inner)
    iterators = st.builds(
        lambda name, start, stop: (
            nodes.Iterator(**S, name=name, range=nodes.Range(**S, start=start, step=None, stop=stop)),
        ),
        names,
        inner,
        inner,
    )
    subscripts = st.lists(
        inner
        | st.just(nodes.All(**S))
        | st.builds(lambda a, b, c: nodes.Range(**S, start=a, step=b, stop=c), inner, st.none() | inner, inner),
        min_size=1,
        max_size=2,
    ).map(tuple)
    targets = references | st.builds(
        lambda t, n: nodes.Member(**S, target=t, name=n, name_span=None), references, names
    )
    return (
        st.builds(binary, st.sampled_from(sorted(LEVELS)), inner, inner)
        | st.builds(unary, st.sampled_from(["-", "+", "not"]), inner)
        | st.builds(lambda e: nodes.Parenthesized(**S, inner=e), inner)
        | st.builds(lambda e: nodes.Array(**S, elements=e), several)
        | st.builds(lambda a, b: nodes.Tuple(**S, elements=(a, *b)), inner, several)
        | st.builds(lambda rows: nodes.Matrix(**S, rows=rows), st.lists(several, min_size=1, max_size=2).map(tuple))
        | st.builds(
            lambda f, a: nodes.Call(**S, function=f, arguments=a),
            targets,
            st.lists(inner | named, max_size=3).map(tuple),
        )
        | st.builds(lambda f, b, i: nodes.Reduction(**S, function=f, body=b, iterators=i), targets, inner, iterators)
        | st.builds(lambda b, i: nodes.Comprehension(**S, body=b, iterators=i), inner, iterators)
        | st.builds(lambda t, s: nodes.Index(**S, target=t, subscripts=s), targets, subscripts)
        | st.builds(
            lambda c, v, o: nodes.Conditional(**S, branches=(nodes.Branch(**S, condition=c, value=v),), otherwise=o),
            inner,
            inner,
            inner,
        )
    )


expressions = st.recursive(leaves, extended, max_leaves=12)


@pytest.mark.no_cover
@settings(max_examples=examples(400), deadline=None)
@given(expressions)
def test_printed_expressions_read_back(tree):
    text = print_expression(tree)
    sink = Sink()
    found = parse_expression(SourceFile("t", text), sink)
    assert found == tree, (text, [d.code for d in sink.diagnostics])
    assert print_expression(found) == text


@settings(max_examples=examples(150), deadline=None)
@given(expressions)
def test_long_statements_wrap_without_a_change(tree):
    text = f"model M Real some_name = {print_expression(tree)}; end M;"
    once = format_text(SourceFile("t", text), Sink())
    assert once is not None
    assert format_text(SourceFile("t", once), Sink()) == once
    declared = parsed(once)[0].items[0].items[0].declarators[0]
    assert declared.value == tree


@settings(max_examples=examples(300), deadline=None)
@given(st.text(max_size=200))
def test_any_text_gets_an_answer(text):
    unit, diagnostics = parsed(text)
    assert (unit is None) == bool(diagnostics)


pieces = st.sampled_from(
    [
        *WORDS,
        *MARKS,
        "x",
        "Real",
        "5 kg",
        "3",
        '"s"',
        "//c\n",
        "/*c*/",
        "\n",
        "\n  ",
        '"',
        "/*",
        "@",
        "Nm",
    ]
)


@pytest.mark.no_cover
@settings(max_examples=examples(500), deadline=None)
@given(st.lists(pieces, max_size=60))
def test_any_tokens_get_an_answer(words):
    text = " ".join(words)
    for wrapped in (text, f"model M\n{text}\nend M;", f"model M\nequation\n{text}\nend M;\n"):
        unit, diagnostics = parsed(wrapped)
        assert (unit is None) == bool(diagnostics)
        for diagnostic in diagnostics:
            for label in diagnostic.labels:
                assert 0 <= label.span.start <= label.span.end <= len(wrapped)


@pytest.mark.no_cover
@settings(max_examples=examples(400), deadline=None)
@given(st.data())
def test_mutilated_models_get_an_answer(data):
    text = data.draw(st.sampled_from(SOURCES))
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        length = data.draw(st.integers(0, 12))
        text = text[:start] + data.draw(st.just("") | pieces | st.text(max_size=3)) + text[start + length :]
    unit, diagnostics = parsed(text)
    assert (unit is None) == bool(diagnostics)
    assert len(diagnostics) < 40, "a few faults have few causes"
    if unit is not None:
        once = format_text(SourceFile("t", text), Sink())
        assert once is not None and format_text(SourceFile("t", once), Sink()) == once


@pytest.mark.no_cover
@settings(max_examples=examples(200), deadline=None)
@given(st.sampled_from(SOURCES), st.data())
def test_one_token_left_out_is_told_as_few_faults(text, data):
    """A single slip never draws more than three diagnostics."""
    places = [(token.start_pos, token.end_pos) for token in plain_tokens(text)]
    start, end = data.draw(st.sampled_from(places))
    _, diagnostics = parsed(text[:start] + text[end:])
    assert len(diagnostics) <= 3, [(d.code, d.labels[0].span.text) for d in diagnostics]


@together("source", spread(range(len(SOURCES)), 40))
def test_layout_does_not_matter(source):
    """Without any blank that is not needed the formatted text is the same, comments aside."""
    import re

    text = SOURCES[source]
    if "//" in text or "/*" in text:
        pytest.skip("comments keep their lines")
    squeezed = re.sub(r"[ \t]*\n[ \t]*", "\n", text)
    blank_lines = re.sub(r"\n\n+", "\n", squeezed)
    one, other = (format_text(SourceFile("t", t), Sink()) for t in (re.sub(r"\n\n+", "\n", text), blank_lines))
    assert one == other


def test_expressions_of_the_strategy_are_those_of_the_language():
    assert expression("force.at[on]") == nodes.Index(
        **S,
        target=nodes.Member(**S, target=nodes.Reference(**S, name="force"), name="at", name_span=None),
        subscripts=(nodes.Reference(**S, name="on"),),
    )
