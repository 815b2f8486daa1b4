"""Initial equations that contradict each other, a fixed start or a constraint: all of them are named, no other is."""

from __future__ import annotations

import pytest
from choice import spread

from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check


def told(declarations: str, equations: str) -> dict[str, Diagnostic]:
    text = f"""model M
      {declarations}
      gravity = 0;
      mass 1 kg at {{x, y}};
    initial equation
      {equations}
    end M;"""
    found, _ = check(SourceFile("M.lag", text))
    return {each.code: each for each in found}


_FREE = "coordinate Length x(start = 1 m), y;"


@pytest.mark.parametrize(
    ("declarations", "equations", "names"),
    spread(
        [
            (_FREE, "x = 2 m; x = 3 m;", "`x = 3 m` contradicts `x = 2 m`"),
            (_FREE, "y = 1 m; x = 2 m; x = 3 m;", "`x = 3 m` contradicts `x = 2 m`"),
            (
                _FREE,
                "der(x) + der(y) = 2 m/s; der(x) + der(y) = 3 m/s;",
                "`der(x) + der(y) = 3 m/s` contradicts `der(x) +",
            ),
            (_FREE, "x + y = 1 m; x - y = 0; x = 3 m;", "`x = 3 m` contradicts `x + y = 1 m` and `x - y = 0`"),
            (_FREE, "x^2 + y^2 = 1 m2; x^2 + y^2 = 4 m2;", "`x^2 + y^2 = 4 m2` contradicts `x^2 + y^2 = 1 m2`"),
            (
                "coordinate Length x(start = 1 m, fixed = true), y;",
                "x = 2 m;",
                "`x = 2 m` contradicts the fixed start of `x`",
            ),
            (
                "coordinate Length x(der(start = 1 m/s, fixed = true)), y;",
                "1/2*(1 kg)*der(x)^2 = 2 J;",
                "contradicts the fixed start of `der(x)`",
            ),
            (
                f"{_FREE} constraint c: x + y = 1 m; constraint d: x = 2*y;",
                "x = 2 m;",
                "`x = 2 m` contradicts constraint `c` and constraint `d`",
            ),
            (
                f"{_FREE} constraint c: x + y = 1 m;",
                "der(x) = 1 m/s; der(y) = 1 m/s;",
                "contradicts constraint `c` and `der(x)",
            ),
            (
                f"{_FREE} state Real z(start = 1, fixed = true); ",
                "z = 2;",
                "`z = 2` contradicts the fixed start of `z`",
            ),
        ],
        5,
    ),
)
def test_all_that_contradict_are_named(declarations: str, equations: str, names: str) -> None:
    """These were told as a residual, or as one fixed start too many."""
    if "state" in declarations:
        equations += " equation der(z) = -z/(1 s);"
    found = told(declarations, equations)
    assert names in found["E0839"].message
    assert len(found["E0839"].labels) >= 2 and not {"E0815", "E0801"} & found.keys()


@pytest.mark.parametrize("equations", ["x^2 = -1 m2;", "y = 1 m; x^2 = -1 m2;", "der(der(x)) = 1 m/s2;"])
def test_an_equation_that_never_holds_contradicts_none(equations: str) -> None:
    found = told(_FREE, equations)
    assert "E0815" in found and "E0839" not in found


@pytest.mark.parametrize("equations", ["x = 1 m; 2*x = 2 m;", "x^2 = 4 m2; x = -2 m;", "x*y = 1 m2; x = y;"])
def test_equations_that_agree(equations: str) -> None:
    assert not {"E0839", "E0815", "E0801"} & told(_FREE, equations).keys()


@pytest.mark.parametrize(
    ("equations", "names"),
    [
        ("x = a; x = 2*a; a = 1 m;", "`a = 1 m` contradicts `x = a` and `x = 2*a`"),
        ("y = 3*a; y = 0; a = 1 m;", "`a = 1 m` contradicts `y = 3*a` and `y = 0`"),
        ("a = 1 m; a = 3 m;", "`a = 3 m` contradicts `a = 1 m`"),
    ],
)
def test_contradictions_over_a_free_parameter(equations: str, names: str) -> None:
    """They were told as a residual."""
    found = told(f"parameter Length a(fixed = false, start = 1 m); {_FREE}", equations)
    assert names in found["E0839"].message and not {"E0815", "E0801"} & found.keys()


def test_a_fixed_start_and_a_free_parameter() -> None:
    declarations = "parameter Length a(fixed = false, start = 1 m); coordinate Length x(start = 1 m, fixed = true), y;"
    assert "contradicts the fixed start of `x` and `x = a`" in told(declarations, "x = a; a = 3 m;")["E0839"].message
    assert not told(declarations, "x = a; y = 3*a;").keys() & {"E0839", "E0815", "E0801"}


def test_the_runtime_alone_decides_that_there_is_no_start(monkeypatch: pytest.MonkeyPatch) -> None:
    """The search for contradictions is for words: it runs after a failure, which stands without it."""
    asked = []

    def nothing_found(*arguments: object) -> bool:
        asked.append(arguments)
        return False

    monkeypatch.setattr("lagdsl.derivation.structure.contradictions.report_contradiction", nothing_found)
    assert not {"E0839", "E0815", "E0801"} & told(_FREE, "x = 1 m; 2*x = 2 m;").keys() and not asked
    assert "E0815" in told(_FREE, "x = 2 m; x = 3 m;") and len(asked) == 1
    assert "E0801" in told("coordinate Length x(start = 1 m, fixed = true), y;", "x = 2 m;") and len(asked) == 2
