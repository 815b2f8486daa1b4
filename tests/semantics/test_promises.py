"""What the text may say: `each` for all inside, both words for a load on a number, sizes met early."""

from __future__ import annotations

import time

import pytest
from flattening import run

from lagdsl.flat.evaluate import Evaluator, Values


def errors(text: str) -> list[str]:
    _, sink = run(text, model="M")
    return [d.code for d in sink.diagnostics if d.code.startswith("E")]


@pytest.mark.parametrize(
    "modifiers",
    [
        "each der(start = 1 rad/s)",
        "each der(start = 1 rad/s, fixed = true)",
        "der(each start = 1 rad/s)",
        "each der(each start = 1 rad/s)",
        "each start = 2 rad, each der(start = 1 rad/s)",
        "der(start = {1 rad/s, 1 rad/s})",
    ],
)
def test_each_counts_for_what_is_inside(modifiers: str) -> None:
    flat, sink = run(
        f"model M coordinate Angle q[2]({modifiers}); kinetic (1 J.s2)*(der(q[1])^2 + der(q[2])^2); end M;"
    )
    assert flat is not None, sink.diagnostics
    still = Evaluator(flat, Values())
    assert [still.scalar(c.rate_start) for c in flat.coordinates if c.rate_start is not None] == [1.0, 1.0]


@pytest.mark.parametrize(
    ("modifiers", "code"),
    [("der(start = 1 rad/s)", "E0335"), ("each der(start = {1 rad/s, 1 rad/s})", "E0415")],
)
def test_each_is_still_asked_for(modifiers: str, code: str) -> None:
    found = errors(f"model M coordinate Angle q[2]({modifiers}); kinetic (1 J.s2)*(der(q[1])^2 + der(q[2])^2); end M;")
    assert len(found) == 1


@pytest.mark.parametrize("word", ["force", "torque"])
@pytest.mark.parametrize("declaration", ["coordinate Real y", 'coordinate Real y(unit = "1")', "coordinate Real y[2]"])
def test_a_number_takes_both_words(word: str, declaration: str) -> None:
    name = "y[1]" if "[" in declaration else "y"
    other = "kinetic (1 J.s2)*der(y[2])^2;" if "[" in declaration else ""
    text = f"model M {declaration}; kinetic (1 J.s2)*der({name})^2; {other} {word} 2 J on {name}; end M;"
    assert errors(text) == []
    assert errors(text.replace("2 J", "2 N")) == ["E0403"]


@pytest.mark.parametrize(
    ("declaration", "load", "codes"),
    [
        ("coordinate Angle y", "force 2 N.m on y", ["E0412"]),
        ("coordinate Angle y", "torque 2 N.m on y", []),
        ('coordinate Real y(unit = "rad")', "force 2 N.m on y", ["E0412"]),
        ("type Bend = Angle; coordinate Bend y", "force 2 N.m on y", ["E0412"]),
        ("coordinate Length y", "torque 2 N on y", ["E0412"]),
        ("coordinate Length y", "force 2 N on y", []),
    ],
)
def test_angles_and_lengths_take_one_word(declaration: str, load: str, codes: list[str]) -> None:
    scale = "J.s2" if "Length" not in declaration else "kg"
    assert errors(f"model M {declaration}; kinetic (1 {scale})*der(y)^2; {load}; end M;") == codes


def test_a_number_is_not_called_an_angle() -> None:
    _, sink = run("model M coordinate Real y; kinetic (1 J.s2)*der(y)^2; force 2 N on y; end M;")
    (found,) = sink.diagnostics
    said = " ".join([found.message, *(label.text for label in found.labels), found.help or ""])
    assert "angle" not in said and "at P" not in said


@pytest.mark.parametrize("levels", [5, 9, 60])
def test_too_many_components_are_told_early(levels: int) -> None:
    classes = "".join(f"model L{k} L{k - 1} c[10]; end L{k};\n" for k in range(1, levels + 1))
    text = f"model L0 coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; end L0;\n{classes}model M L{levels} c; end M;"
    before = time.process_time()
    assert errors(text) == ["E0326"]
    assert time.process_time() - before < 30


def test_doubling_components_are_told_early() -> None:
    classes = "".join(f"model L{k} L{k - 1} a, b; end L{k};\n" for k in range(1, 40))
    text = f"model L0 coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; end L0;\n{classes}model M L39 c; end M;"
    assert errors(text) == ["E0326"]
