"""Promises about texts: `each` for all inside, both words for a load on a number, sizes met early."""

from __future__ import annotations

import time

import numpy as np
import pytest
from choice import ALL, chosen, together
from flattening import run

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.semantics.scope import limits
from lagdsl.language.semantics.wellformed.check import check as check_physics
from lagdsl.motion.signals.inputs import signals


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


@pytest.mark.parametrize(
    "text",
    [
        "coordinate Angle q[2](each each start = 1 rad); kinetic (1 J.s2)*(der(q[1])^2 + der(q[2])^2);",
        "coordinate Angle q[2](each der(each each start = 1 rad/s)); kinetic (1 J.s2)*(der(q[1])^2 + der(q[2])^2);",
        "W w[2](each each R = 2);",
        "W w(q(final final start = 2 rad));",
        "extends W(final final R = 2);",
    ],
)
def test_a_prefix_stands_once(text: str) -> None:
    wheel = "model W parameter Real R = 1; coordinate Angle q; kinetic R*(1 J.s2)*der(q)^2; end W;"
    assert errors(f"{wheel} model M {text} end M;") == ["E0212"]


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
        ("coordinate Real y(start = 1)", "force 2 J on y^2", []),
        ("coordinate Real y", "torque 2 J on (-2*y)", []),
        ("coordinate Angle y", "force 2 J on 2*y", ["E0412"]),
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


@pytest.fixture
def _few_components(monkeypatch: pytest.MonkeyPatch) -> None:
    """`make check` meets a bound that is a tenth as high."""
    if not ALL:
        monkeypatch.setattr(limits, "MAX_COMPONENTS", limits.MAX_COMPONENTS // 10)


@pytest.mark.usefixtures("_few_components")
@pytest.mark.parametrize("levels", chosen([5, 9, 60], [60]))
def test_too_many_components_are_told_early(levels: int) -> None:
    classes = "".join(f"model L{k} L{k - 1} c[10]; end L{k};\n" for k in range(1, levels + 1))
    text = f"model L0 coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; end L0;\n{classes}model M L{levels} c; end M;"
    before = time.process_time()
    assert errors(text) == ["E0326"]
    assert time.process_time() - before < 30


@pytest.mark.usefixtures("_few_components")
def test_doubling_components_are_told_early() -> None:
    classes = "".join(f"model L{k} L{k - 1} a, b; end L{k};\n" for k in range(1, 40))
    text = f"model L0 coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; end L0;\n{classes}model M L39 c; end M;"
    assert errors(text) == ["E0326"]


WHEELS = """
model Wheel
  parameter Real r[2] = {1, 2};
  parameter Real k = 1;
  coordinate Angle spin;
  point P = {k*(1 m), 0};
  kinetic (1 J.s2)*der(spin)^2;
end Wheel;
model Axle parameter Real a = 1; Wheel w[2](k = {a, 2*a}); end Axle;
model M
  Wheel wheel[3](k = {1, 2, 3}), one;
  Axle axle[2](a = {10, 20});
"""


@together(
    ("output", "expected"),
    [
        ("Real y[3] = wheel.k", [1, 2, 3]),
        ("Real y[2] = wheel[2:3].k", [2, 3]),
        ("Real y[3] = wheel[:].k", [1, 2, 3]),
        ("Real y[2] = wheel[{3, 1}].k", [3, 1]),
        ("Real y = sum(wheel.k)", [6]),
        ("Real y[3, 2] = wheel.r", [1, 2, 1, 2, 1, 2]),
        ("Real y[2, 2] = axle.w.k", [10, 20, 20, 40]),
        ("Real y[2] = axle.w[2].k", [20, 40]),
        ("Real y[2] = axle[2].w.k", [20, 40]),
        ("Real y[1, 2] = axle[2:2].w.k", [20, 40]),
        ("Length y[3, 3] = wheel.P", [1, 0, 0, 2, 0, 0, 3, 0, 0]),
        ("AngularVelocity y[3] = der(wheel.spin)", [4, 5, 6]),
        ("Angle y = wheel.spin*wheel.k", [14]),
    ],
)
def test_members_of_arrays_of_components(output: str, expected: list[float]) -> None:
    flat, sink = run(f"{WHEELS} output {output}; end M;", model="M")
    assert flat is not None, sink.diagnostics
    spins = {f"wheel[{k}].spin": float(k) for k in (1, 2, 3)}
    rates = {f"wheel[{k}].spin": 3.0 + k for k in (1, 2, 3)}
    there = Evaluator(flat, Values(variables=spins, rates=rates))
    assert [there.scalar(item.value) for item in flat.outputs] == expected


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("output Real y[3] = wheel.nothing;", "E0210"),
        ("output Real y = wheel[4:5].k;", "E0316"),
        ("output Real y = wheel.k;", "E0334"),
        ("output Real y[3] = wheel[1, 2].k;", "E0341"),
    ],
)
def test_members_that_are_not_there(text: str, code: str) -> None:
    assert set(errors(f"{WHEELS} {text} end M;")) == {code}


def test_empty_parentheses_modify_nothing() -> None:
    """As in Modelica: `Weld j();`."""
    text = """
    model Slider parameter Real k() = 1; coordinate Length x(start() = 1 m); kinetic 1/2*k*(1 kg)*der(x)^2; end Slider;
    model Other = Slider();
    model M extends Slider(); Other s(x()), t(); end M;
    """
    flat, sink = run(text, model="M")
    assert flat is not None and not sink.has_errors
    assert [c.name for c in flat.coordinates] == ["x", "s.x", "t.x"]


def test_limits_of_inputs_and_outputs() -> None:
    """These were refused. Values out of bounds are told, and FMUs have them."""
    text = """
    model M
      input Force u[2](each min = -1 N, max = {1 N, 2 N}, each nominal = 0.5 N);
      coordinate Length x;
      kinetic 1/2*(1 kg)*der(x)^2;
      force u[1] + u[2] on x;
      output Length y(min = 0 m, max = 3 m, nominal = 1 m) = x;
    end M;"""
    flat, sink = run(text, model="M")
    assert flat is not None and not sink.diagnostics
    assert [(i.minimum, i.maximum, i.nominal) for i in flat.inputs] == [(-1.0, 1.0, 0.5), (-1.0, 2.0, 0.5)]
    (output,) = flat.outputs
    assert (output.minimum, output.maximum, output.nominal) == (0.0, 3.0, 1.0)
    for value, told in ((1.0, []), (5.0, ["W0328"]), (([0.0, 1.0], [0.0, -2.0]), ["W0328"])):
        found = Sink()
        signals(flat, np.zeros(2), {"u[1]": value}, (0.0, 1.0), found)
        assert [each.code for each in found.diagnostics] == told
    with pytest.raises(ValueError, match="finite"):
        signals(flat, np.zeros(2), {"u[1]": float("nan")}, (0.0, 1.0), Sink())


@pytest.mark.parametrize(
    ("declaration", "code"),
    [
        ("input Force u(max = 1 N, start = 5 N);", "W0328"),
        ("input Force u(min = 1 N);", "W0328"),
        ("input Force u(min = 2 N, max = 1 N);", "E0517"),
        ("input Force u; output Length y(min = 3 m, max = 2 m) = x;", "E0517"),
        ("input Force u; output Length y(nominal = -1 m) = x;", "E0517"),
        ("input Force u; output Length y(min = 1 s) = x;", "E0415"),
    ],
)
def test_impossible_limits(declaration: str, code: str) -> None:
    text = f"model M {declaration} coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; force u on x; end M;"
    flat, sink = run(text, model="M")
    if flat is not None:
        check_physics(flat, sink)
    assert code in {each.code for each in sink.diagnostics}
