"""Discretes of the start hold at the first instant: in accelerations, rates, constraints, assertions; in every engine,
when a model is checked, and in FMUs."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import fmpy
import pytest
from choice import chosen, engines
from fmi.texts import export_text

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.record import record
from lagdsl.motion.simulate.failure import SimulationFailed

ENGINES = engines(("tape", "c", "numpy"))


@record(kw_only=True)
class Case:
    """Values at the first row and at the last, at `stop`."""

    name: str
    items: str
    stop: float
    first: dict[str, float]
    last: dict[str, float]
    initial: str = ""


LATER = "when time > 9 then {} end when;"
CASES = [
    Case(
        name="mass",
        items="coordinate Real x; discrete Real m(start = 2); kinetic 1/2*m*der(x)^2; force 6 on x;"
        "output Real a = der(der(x));" + LATER.format("m = 4;"),
        stop=1.0,
        first={"a": 3.0, "der(x)": 0.0},
        last={"x": 1.5, "der(x)": 3.0},
    ),
    Case(
        name="mass of a parameter",
        items="parameter Real M = 5; coordinate Real x; discrete Real m(start = 2*M); kinetic 1/2*m*der(x)^2;"
        "force 6 on x;"
        "output Real a = der(der(x));" + LATER.format("m = 4;"),
        stop=1.0,
        first={"a": 0.6},
        last={"der(x)": 0.6},
    ),
    Case(
        name="least kinetic energy",
        items="coordinate Real c, d; discrete Real m(start = 1), k(start = 5); kinetic 1/2*m*der(c)^2 + 1/2*k*der(d)^2;"
        "constraint total: der(c) + der(d) = 1;" + LATER.format("m = 3; k = 1;"),
        stop=1.0,
        first={"der(c)": 5.0 / 6.0, "der(d)": 1.0 / 6.0},
        last={"c": 5.0 / 6.0, "d": 1.0 / 6.0},
    ),
    Case(
        name="a constraint that is switched on",
        # the written rate holds, and the other follows
        items="coordinate Real x(der(start = 4)), y; discrete Boolean held(start = true);"
        "kinetic 1/2*3*der(x)^2 + 1/2*der(y)^2;"
        "constraint tie: (if held then der(x) - der(y) else 0) = 0;" + LATER.format("held = false;"),
        stop=1.0,
        first={"der(x)": 4.0, "der(y)": 4.0, "held": 1.0},
        last={"x": 4.0, "y": 4.0},
    ),
    Case(
        name="radius of a circle",
        items="coordinate Real x(start = 2), y; discrete Real r(start = 3); kinetic 1/2*(der(x)^2 + der(y)^2);"
        "constraint rim: x^2 + y^2 = r^2;" + LATER.format("r = 1;"),
        stop=1.0,
        # the written start holds, as the other one can move
        first={"x": 2.0, "y": 5.0**0.5},
        last={"x": 2.0},
    ),
    Case(
        name="shelf",
        items="coordinate Real h(start = 2); discrete Real w(start = 2); kinetic 1/2*der(h)^2; force -10 on h;"
        "contact c: h >= w with restitution = 0; output Real load = multiplier(c);" + LATER.format("w = 1;"),
        stop=1.0,
        first={"load": 10.0, "h": 2.0},
        last={"load": 10.0, "h": 2.0},
    ),
    Case(
        name="branch",
        items="coordinate Real x; discrete Boolean on(start = true); kinetic 1/2*der(x)^2;"
        "force (if on then 7 else -7) on x;"
        "output Real a = der(der(x));" + LATER.format("on = false;"),
        stop=1.0,
        first={"a": 7.0},
        last={"der(x)": 7.0},
    ),
    Case(
        name="initial equation",
        items="coordinate Real x(start = 1); discrete Integer n(start = 3); kinetic 1/2*der(x)^2;"
        "potential 1/2*4*(x - n)^2;" + LATER.format("n = 4;"),
        stop=1.0,
        initial="der(x) = 0; der(der(x)) = 0;",
        first={"x": 3.0},
        last={"x": 3.0},
    ),
    Case(
        name="tick at the start",
        items="coordinate Real x; discrete Real m(start = 1); kinetic 1/2*m*der(x)^2; force 8 on x;"
        "output Real a = der(der(x));"
        "when sample(0, 5) then m = pre(m) + 3; end when;",
        stop=1.0,
        first={},
        last={"a": 2.0, "der(x)": 2.0},
    ),
]


def _text(case: Case) -> str:
    items, _, clauses = case.items.partition("when ")
    initial = f"initial equation {case.initial}" if case.initial else ""
    return f'model Begun {items} annotation(units = "none"); equation when {clauses} {initial} end Begun;'


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_motion(case: Case, engine: str) -> None:
    motion = lagdsl.compile(_text(case), engine=engine).simulate(stop=case.stop, tolerance=1e-11)
    for name, value in case.first.items():
        assert motion[name][0] == pytest.approx(value, abs=1e-9), name
    for name, value in case.last.items():
        assert motion[name][-1] == pytest.approx(value, abs=1e-8), name


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_check(case: Case) -> None:
    assert [d.code for d in lagdsl.check(_text(case)) if d.severity == "error"] == []


@pytest.mark.parametrize(("k", "fmi"), chosen(product((0, 5, 7), (2, 3)), [(0, 2), (5, 3)]))
def test_fmu(k: int, fmi: int, tmp_path: Path) -> None:
    case = CASES[k]
    export_text(_text(case), tmp_path / "begun.fmu", fmi)
    names = sorted({*case.first, *case.last})
    for kind in ("CoSimulation", "ModelExchange"):
        motion = fmpy.simulate_fmu(
            str(tmp_path / "begun.fmu"), fmi_type=kind, stop_time=case.stop, output=names, relative_tolerance=1e-9
        )
        for name, value in case.first.items():
            assert motion[name][0] == pytest.approx(value, abs=1e-9), (kind, name)
        for name, value in case.last.items():
            assert motion[name][-1] == pytest.approx(value, abs=1e-6), (kind, name)


ASSERTION = """
model Counted
  coordinate Real x(der(start = 1));
  kinetic 1/2*der(x)^2;
  discrete Integer n(start = {0});
  annotation(units = "none");
equation
  assert(n > 2, "too few");
  when x > 5 then
    n = 4;
  end when;
end Counted;
"""


def test_assertion_of_a_start() -> None:
    assert [d.code for d in lagdsl.check(ASSERTION.format(3)) if d.severity == "error"] == []
    assert [d.code for d in lagdsl.check(ASSERTION.format(2)) if d.severity == "error"] == ["E0810"]


@pytest.mark.parametrize("engine", ENGINES)
def test_assertion_of_a_run(engine: str) -> None:
    assert lagdsl.compile(ASSERTION.format(3), engine=engine).simulate(stop=1.0)["n"][-1] == 3.0
    with pytest.raises((SimulationFailed, CompilationFailed)) as failure:
        lagdsl.compile(ASSERTION.format(2), engine=engine).simulate(stop=1.0)
    assert "E0810" in [d.code for d in failure.value.diagnostics]


def test_assertion_in_an_fmu(tmp_path: Path) -> None:
    export_text(ASSERTION.format(3), tmp_path / "counted.fmu")
    motion = fmpy.simulate_fmu(str(tmp_path / "counted.fmu"), fmi_type="CoSimulation", stop_time=1.0, output=["n"])
    assert motion["n"][-1] == 3
