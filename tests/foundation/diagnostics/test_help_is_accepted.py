"""A help that writes a text is right as it stands: no help leads to another fault."""

import re

import pytest
from choice import spread

from lagdsl.foundation.diagnostics import Diagnostic, Severity
from lagdsl.foundation.diagnostics.render import render_all
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.written import literal_text
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.settings.literal import literal
from lagdsl.motion.pipeline import check

_MODEL = """model Plant
  parameter Real n = 2;
  coordinate Length x, y(start = 1 m);
  gravity = 0;
  mass 1 kg at {x, y};
  potential n*(0.5 N/m)*(x^2 + y^2);
  STATEMENT
end Plant;
"""


def found(statement: str) -> tuple[Diagnostic, ...]:
    return check(SourceFile("plant.lag", _MODEL.replace("STATEMENT", statement)))[0]


def errors(statement: str) -> list[Diagnostic]:
    return [each for each in found(statement) if each.severity is Severity.ERROR]


def help_of(statement: str, code: str) -> str:
    (first, *_) = errors(statement)
    assert first.code == code, render_all((first,))
    assert first.help is not None
    return first.help


def quoted(help: str) -> list[str]:
    return re.findall(r"`([^`]+)`", help)


@pytest.mark.parametrize(
    "statement",
    [
        "parameter AngularVelocity w = 2*pi/86164;",
        "parameter Length a = 3*4;",
        "parameter Stiffness k = 3*2;",
        "parameter Velocity v = 100/3.6;",
        "parameter Time T = -(2*pi)/1000;",
        "parameter SpecificHeatCapacity c = 4*1000;",
        "parameter Curvature c = 1/20;",
    ],
)
def test_a_unit_that_is_missing_in_a_product(statement: str) -> None:
    literal, number = quoted(help_of(statement, "E0407"))
    assert errors(statement.replace(f"{number}", literal)) == []


@pytest.mark.parametrize(
    ("statement", "code"),
    [
        ("parameter Time T = 1/30 s;", "E0407"),
        ("discrete Real k(start = 0); when sample(0, 1/30 s) then k = pre(k) + 1; end when;", "E0415"),
        ("parameter Length a = 1 m + 1/2 m;", "E0401"),
        ("potential (1/2 N/m)*x^2;", "E0404"),
    ],
)
def test_a_unit_at_the_wrong_place_of_a_quotient(statement: str, code: str) -> None:
    wrong, right = quoted(help_of(statement, code))
    assert errors(statement.replace(wrong, right)) == []


@pytest.mark.parametrize(
    "equation",
    ["x = 3 m", "y - x = 3 m", "2*x = y", "-x = 3 m", "x^2 + y^2 = 1 m2"],
)
def test_an_equation_between_coordinates_is_a_constraint(equation: str) -> None:
    (way,) = quoted(help_of(f"{equation};", "E0103"))
    assert way == f"constraint {equation};"
    assert errors(way) == []


def test_an_equation_in_a_loop_goes_with_the_loop_behind_equation() -> None:
    loop = "Length d[2];\n  for i in 1:2 loop\n    d[i] = i*x;\n  end for;"
    help = help_of(loop, "E0103")
    lines = _MODEL.replace("STATEMENT", loop).split("\n")
    (number,) = re.findall(r"above line (\d+)", help)
    lines.insert(int(number) - 1, "equation")
    text = "\n".join(lines)
    assert not [each for each in check(SourceFile("plant.lag", text))[0] if each.severity is Severity.ERROR]


@pytest.mark.parametrize(
    ("declaration", "used"),
    [
        ("Length d = i*x;", "potential (1 N/m)*d^2;"),
        ("point P = {i*x, y};", "mass 1 kg at P;"),
        ("parameter Mass m = i*(2 kg);", "mass m at {x, y};"),
        ("output Length d = i*x;", ""),
        ("coordinate Length z;", "mass 1 kg at {z, x};"),
    ],
)
def test_a_declaration_in_a_loop_becomes_an_array(declaration: str, used: str) -> None:
    array, element = quoted(help_of(f"for i in 1:2 loop {declaration} {used} end for;", "E0340"))
    name = declaration.partition(" =")[0].rstrip(";").split()[-1]
    used = re.sub(rf"\b{name}\b", f"{name}[i]", used)
    assert errors(f"{array} for i in 1:2 loop {element if '=' in element else ''} {used} end for;") == []


def test_every_unit_is_written_as_texts_take_it() -> None:
    """Units of all types, in models and as values by name."""
    for name, each in spread(prelude.TYPES.items(), 20):
        if each.base != "Real" or each.shape or each.unit == "1":
            continue
        text = literal_text("2", each.unit)
        assert errors(f"constant {name} c = {text};") == [], text
        assert literal("c", text).dimension == each.dimension, text
        for unit in (each.display_unit,) if each.display_unit else ():
            assert literal("c", literal_text("2", unit)).dimension == each.dimension, unit
