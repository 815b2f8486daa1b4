"""Constraints whose gradient vanishes, jumps or does not exist where they hold; constraints that touch; structures."""

from __future__ import annotations

import pytest
from choice import spread

from lagdsl.derivation.structure.points import Geometry
from lagdsl.foundation.diagnostics import Diagnostic, Severity
from lagdsl.foundation.numerics.levenberg_marquardt import Minimizer
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import check

_MODEL = """
model M
  parameter Length l = 1 m, r = 0.5 m;
  coordinate Length x(start = {x} m), y(start = {y} m), z;
  coordinate Angle a(start = {a} rad);
  gravity = -g_n*world.z;
  mass 1 kg at {{x, y, z}};
  mass 1 kg at {{l*sin(a), 2*r, -l*cos(a)}};
  {constraints}
end M;
"""


def told(constraints: str, x: float = 0.0, y: float = 0.0, a: float = 0.0) -> dict[str, Diagnostic]:
    text = _MODEL.format(constraints=constraints, x=x, y=y, a=a)
    found, _ = check(SourceFile("M.lag", text))
    return {each.code: each for each in found}


@pytest.mark.parametrize(
    ("condition", "start", "rewrite"),
    spread(
        [
            ("(x - l)^2 = 0", (1.0, 0.0, 0.0), "`x = l`"),
            ("(x - l)^2 = 0", (1.5, 0.0, 0.0), "`x = l`"),
            ("(x - 1 m)*(x - 1 m) = 0", (1.2, 0.0, 0.0), "`x = 1 m`"),
            ("x^2 - 2*x*l + l^2 = 0", (1.2, 0.0, 0.0), None),
            ("(x - l)^3 = 0", (1.0, 0.0, 0.0), "`x = l`"),
            ("x^4 + y^4 = 0", (0.1, 0.1, 0.0), "`x = 0` and `y = 0`"),
            ("(x - l)^2 + 0.0001*(y - l)^2 = 0", (1.3, 1.0, 0.0), "`x = l` and `y = l`"),
            ("sqrt(x^2 + y^2) = 0", (1.5, 0.0, 0.0), "`x = 0` and `y = 0`"),
            ("norm({x - l, y, 0}) = 0", (0.5, 0.5, 0.0), "`x = l` and `y = 0`"),
            ("abs(x) = 0", (0.1, 0.0, 0.0), "`x = 0`"),
            ("max(abs(x), abs(y)) = 0", (0.2, 0.1, 0.0), None),
            ("1 - cos(a) = 0", (0.0, 0.0, 0.3), "`a = 0`"),
            ("cos(a) = -1", (0.0, 0.0, 3.0), None),
            ("(sin(a) - 0.5)^2 = 0", (0.0, 0.0, 0.4), "`sin(a) = 0.5`"),
            ("(x^2 + y^2 - l^2)^2 = 0", (1.0, 0.1, 0.0), "`x^2 + y^2 = l^2`"),
            ("(x - l*(1 + time/(1 s)))^2 = 0", (1.0, 0.0, 0.0), None),
            ("x^2 + y^2 = (l - 2*r)^2", (0.5, 0.2, 0.0), None),
            ("{x^2, y*l, 0} = {0, 0, 0}", (0.1, 0.0, 0.0), "`x = 0`"),
            ("x*abs(x) = 0", (0.3, 0.0, 0.0), None),
        ],
        8,
    ),
)
def test_no_gradient_where_it_holds(condition: str, start: tuple[float, float, float], rewrite: str | None) -> None:
    """These were dropped as identically satisfied, or ended in accelerations that are not numbers."""
    found = told(f"constraint c: {condition};", *start)
    assert "E0609" in found and "N0605" not in found
    if rewrite is not None:
        assert found["E0609"].help == f"write {rewrite}"


@pytest.mark.parametrize(
    ("condition", "start"),
    [
        ("x^2 + y^2 = l^2", (0.0, 0.0, 0.0)),  # zero at the start only
        ("x*y = 0", (0.0, 0.0, 0.0)),
        ("x^2 = y^2", (0.0, 0.0, 0.0)),
        ("x^2*l = y^3", (0.0, 0.0, 0.0)),
        ("x^2*y = 0", (1.0, 0.01, 0.0)),
        ("(x - l)^2 = 1e-6 m2", (1.0, 0.0, 0.0)),
        ("1e-8*(x - l) = 0", (0.4, 0.0, 0.0)),
        ("sin(1000*a) = 0", (0.0, 0.0, 0.001)),
        ("cos(a) = 0.99999", (0.0, 0.0, 0.01)),
        ("x + abs(y) = 0", (0.0, 0.0, 0.0)),
        ("(if x > 0 then x else 2*x) = 0", (0.2, 0.0, 0.0)),
        ("x^2/l^2 + y^2/(1e-3*l)^2 = 1", (1.0, 0.0, 0.0)),
        ("log(x/l) = 0", (0.8, 0.0, 0.0)),
    ],
)
def test_rows_that_only_look_so(condition: str, start: tuple[float, float, float]) -> None:
    found = told(f"constraint c: {condition};", *start)
    assert not {"E0609", "E0610", "N0605", "N0607"} & found.keys()


@pytest.mark.parametrize(
    ("condition", "fault"),
    [
        ("sign(x) = 1", "in jumps only"),
        ("floor(x/l) = 1", "in jumps only"),
        ("(if x > 0 then 1 else 2) = 1", "in jumps only"),
        ("(if noEvent(x > 0) and y < l then l else r) = l", "in jumps only"),
        ("{x, l*sign(y), l} = {l, l, l}", "in jumps only"),
        ("sign(der(x)) = 1", "in jumps only"),
        ("floor(time/(1 s)) = 0", "no coordinate enters it"),
        ("time = 0", "no coordinate enters it"),
        ("(if time < 1 s then l else r) = l", "no coordinate enters it"),
        ("u = 0; input Length u(smooth = 2)", "no coordinate enters it"),
    ],
)
def test_rows_that_change_without_a_gradient(condition: str, fault: str) -> None:
    """A row that is constant between its jumps was accepted, and left out of the degrees of freedom."""
    assert fault in told(f"constraint c: {condition};", x=1.0, y=1.0)["E0609"].message


@pytest.mark.parametrize(
    "condition",
    ["(if n == 1 then x - y else 0) = 0; discrete Integer n(start = 1)", "sign(x)*x = l", "ceil(x/l)*l = y"],
)
def test_rows_that_jump_and_move_are_none_of_these(condition: str) -> None:
    assert "E0609" not in told(f"constraint c: {condition};", x=1.0, y=1.0)


def test_zero_everywhere_is_another_thing() -> None:
    assert "N0605" in told("constraint c: sin(a)^2 + cos(a)^2 = 1;", a=1.0)


def test_zero_where_others_hold_follows_from_them() -> None:
    found = told("constraint a1: x = 0; constraint b1: y = 0; constraint c: x*y = 0;")
    assert "`a1` and `b1`" in found["N0607"].message and not {"N0605", "E0609", "E0610"} & found.keys()


_SHAFT = """
model Shaft
  coordinate Angle a(start = 0.3 rad), b(start = 0.1 rad), c(start = 0.2 rad);
  frame turned = world.rotx(a).roty(b).rotz(c);
  gravity = 0;
  body d(m = 1 kg, I = {1, 1, 1}) on turned;
  constraint axis: turned.x = world.x;
end Shaft;
"""


def test_component_of_a_unit_vector_follows_from_the_others() -> None:
    """It is 1 where they are 0, and has no gradient there: cos(b) = 1 alone would be an error."""
    found, compilation = check(SourceFile("Shaft.lag", _SHAFT))
    assert compilation is not None and "E0609" not in {each.code for each in found}
    assert compilation.structure.freedom == 1


@pytest.mark.parametrize(
    "pair",
    [
        ("x^2 + y^2 = l^2", "x = l"),
        ("x^2 + y^2 = l^2", "(x - 3*l)^2 + y^2 = (2*l)^2"),
        ("x = y", "x*y = 0"),
        ("x^2 + y^2 = l^2", "x + y = sqrt(2)*l"),
        ("y*l = x^2", "y = 0"),
    ],
)
def test_constraints_that_touch(pair: tuple[str, str]) -> None:
    """The first four were accepted, and the motion ended with E0830 at once."""
    found = told(f"constraint c: {pair[0]}; constraint d: {pair[1]};", 0.9, 0.2)
    assert "E0610" in found and "constraint `c` and constraint `d`" in found["E0610"].message


@pytest.mark.parametrize(
    "pair",
    [
        ("x^2 + y^2 = l^2", "x = 0.9999*l"),
        ("x^2 + y^2 = l^2", "2*x^2 + 2*y^2 = 2*l^2"),
        ("x^2 + y^2 = l^2", "z = 1e-7*x"),
        ("y*l = x^2", "y = 0.001*x"),
    ],
)
def test_constraints_that_do_not_touch(pair: tuple[str, str]) -> None:
    assert "E0610" not in told(f"constraint c: {pair[0]}; constraint d: {pair[1]};", 0.9, 0.2)


def test_a_structure_is_told() -> None:
    held = "constraint c: {x, y, z} = {0, 0, l}; constraint d: a = 0;"
    assert "N0611" in told(held)
    assert "N0611" not in told("constraint c: {x, y, z} = {0, 0, l}; constraint d: a = 1 rad/s*time;")
    assert "N0611" not in told("constraint c: {x, y, z} = {0, 0, l};")


@pytest.mark.parametrize("row", ["max(x - (1 m), 0 m)", "min(x, 0 m)", "max(x, 0 m)^2", "x*max(y, 0 m)"])
def test_rows_that_hold_in_a_whole_region(row: str) -> None:
    for start in ("-1 m", "0.5 m", "3 m"):
        (error,) = _errors(f"{row} = 0", start)
        assert error.code == "E0609" and "contact" in (error.help or "")


def test_rows_that_hold_nowhere_and_rows_of_any_size() -> None:
    for row, code in (("exp(x/(1 m))", "E0602"), ("1e-300*(x - y)", "E0609"), ("1e300*(x - y)", "E0802")):
        assert [error.code for error in _errors(f"{row} = 0", "1 m")] == [code]


def _errors(row: str, start: str) -> list[Diagnostic]:
    text = f"""model M
      coordinate Length x(start = {start}), y(start = 0.2 m);
      kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
      constraint c: {row};
    end M;"""
    found, _ = check(SourceFile("m.lag", text))
    return [diagnostic for diagnostic in found if diagnostic.code.startswith("E")]


ENDLESS = ["l/x = 0", "(l/x)^3 = 0", "atan(x/l) = pi/2", "exp(-x/l) = 0", "1/(1 + (x/l)^2) = 0"]


@pytest.mark.parametrize("row", spread(ENDLESS, 2))
def test_rows_that_are_met_without_end_only(row: str) -> None:
    """Their gradient was said to jump, and `x = l` was proposed."""
    text = f"""model M
      parameter Length l = 1 m;
      coordinate Length x(start = 1 m), y;
      kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
      constraint c: {row};
    end M;"""
    (found,) = (each for each in check(SourceFile("M.lag", text))[0] if each.severity is Severity.ERROR)
    assert found.code == "E0602" and "without end" in found.notes[0]
    assert not [each for each in check(SourceFile("M.lag", text.replace(row, "x = 1e7*l")))[0] if each.code[0] == "E"]


def test_a_contact_is_not_tried_by_projections(monkeypatch: pytest.MonkeyPatch) -> None:
    """A projection costs as much as the model is large: one for each contact makes a check quadratic."""
    project = Geometry.project
    calls: list[int] = []

    def counted(self: Geometry, q: Floats, rows: list[int]) -> Minimizer:
        calls[-1] += 1
        return project(self, q, rows)

    monkeypatch.setattr(Geometry, "project", counted)
    for n in (2, 20):
        calls.append(0)
        text = f"""model Balls
          coordinate Length h[{n}](each start = 1 m);
          gravity = -g_n*world.y;
          for i in 1:{n} loop
            mass 1 kg at {{i*(1 m), h[i]}};
            contact c: h[i] >= 0 with restitution = 0.5;
          end for;
        end Balls;"""
        assert not any(each.severity is Severity.ERROR for each in check(SourceFile("Balls.lag", text))[0])
    assert calls[0] == calls[1] > 0
