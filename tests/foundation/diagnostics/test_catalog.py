"""The catalog and the sink that fills its templates."""

import re
import string
from pathlib import Path

import pytest
from choice import together
from click import Context

from lagdsl.foundation.diagnostics import CompilationFailed, Label, Sink
from lagdsl.foundation.diagnostics.catalog import (
    ROWS,
    analysis,
    assembly,
    constraints,
    dimensions,
    engines,
    events,
    export,
    fits,
    names,
    physics,
    robots,
    starts_and_runs,
    syntax,
    values,
)
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.interfaces.cli.main import lag

FAMILIES = {
    "01": (syntax,), "02": (names,), "03": (values, events), "04": (dimensions,), "05": (physics,),
    "06": (constraints,), "07": (assembly,), "08": (starts_and_runs, analysis), "09": (export, engines),
    "10": (robots,), "11": (fits,),
}  # fmt: skip
FILE = SourceFile("a.lag", "one two three")
HERE, THERE = Span(FILE, 0, 3), Span(FILE, 4, 7)


def fields(template):
    return {name for _, name, _, _ in string.Formatter().parse(template or "") if name is not None}


@together("family", FAMILIES)
def test_rows_stand_in_their_family_in_order(family):
    for module in FAMILIES[family]:
        codes = list(module.ROWS)
        letters_aside = sorted(codes, key=lambda code: code[1:])
        assert codes == letters_aside or codes == sorted(codes)
        assert all(code[1:3] == family and code[0] in "EWN" and len(code) == 5 for code in codes)


def test_no_number_is_used_twice():
    numbers = [code[1:] for code in ROWS]
    assert len(numbers) == len(set(numbers))


def test_fields_of_the_words_are_names():
    for code, row in ROWS.items():
        for text in (row.message, row.label, row.help, row.secondary):
            assert all(name.isidentifier() for name in fields(text)), code
            assert text is None or (text == text.strip() and not text.endswith(".")), code
        first = row.message.split()[0]
        assert first[0].islower() or first[0] in "{`" or first[:2].isupper() or first == "MuJoCo", code


def test_commands_that_messages_name_exist():
    folder = Path(syntax.__file__).parent
    named = {word for file in folder.glob("*.py") for word in re.findall(r"`lag ([a-z]+)", file.read_text("utf-8"))}
    assert "run" in named
    assert named <= set(lag.list_commands(Context(lag)))


def report(*places, **more):
    sink = Sink()
    sink.report("W0511", *places, **{"item": "mass m at P", **more})
    return sink


def test_templates_fill_labels_and_help():
    (diagnostic,) = report(HERE, Label(THERE)).diagnostics
    assert [label.text for label in diagnostic.labels] == [
        "equals the automatic term",
        "already adds -m*g.r for `mass m at P`",
    ]
    assert diagnostic.help == "remove one of the two"


def test_words_given_win():
    (diagnostic,) = report(Label(HERE, "mine"), Label(THERE, "yours"), notes=("n",), help="h").diagnostics
    assert [label.text for label in diagnostic.labels] == ["mine", "yours"]
    assert (diagnostic.notes, diagnostic.help) == (("n",), "h")


def test_the_same_fact_is_kept_once():
    sink = report(HERE)
    sink.report("W0511", HERE, item="mass m at P")
    sink.report("W0511", THERE, item="mass m at P")
    assert len(sink.diagnostics) == 2


def test_without_a_place():
    assert report(None).diagnostics[0].labels == ()


def test_only_errors_stop():
    sink = report(HERE)
    assert not sink.has_errors
    sink.raise_if_errors()
    sink.report("E0501", HERE, name="phi")
    with pytest.raises(CompilationFailed) as caught:
        sink.raise_if_errors()
    assert [diagnostic.code for diagnostic in caught.value.diagnostics] == ["W0511", "E0501"]
    assert "error[E0501]: coordinate `phi` is never used\n --> a.lag:1:1\n" in str(caught.value)
