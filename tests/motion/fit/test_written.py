"""`-o fitted.lag`: numbers in the text, and nothing else."""

import pytest
from fit.measured_models import DAMPED

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.settings.target import targets
from lagdsl.motion.fit.written import written
from lagdsl.motion.pipeline import flatten_file

MACHINE = """model Part "With values of its own"
  parameter Mass m = 1 kg;
  parameter Stiffness k = 3 N/m;
  coordinate Length x(start = 1 cm);
  mass m at {x, 0};
  potential 1/2*k*x^2;
end Part;
model Machine "Parts with and without modifiers"
  Part a(m = 2 kg, x(start = 2 cm)), b;  // stays
end Machine;
"""

ARRAY = """model Masses
  parameter Mass m[2] = {1 kg, 2000 g};
  parameter Real k(unit = "N/m") = 3;
  parameter Stiffness kk[2] = {n*1 N/m for n in 1:2};
  coordinate Length x[2](start = {1 cm, -2 cm});
  mass m[1] at {x[1], 0};
  mass m[2] at {x[2], 0};
  potential 1/2*k*(x[1] - x[2])^2 + 1/2*kk[1]*x[1]^2 + 1/2*kk[2]*x[2]^2;
end Masses;
"""


def changed(text, values):
    """The lines that the values change, and the diagnostics."""
    source, sink = SourceFile("a.lag", text), Sink()
    flat = flatten_file(source, sink)
    known = targets(flat)
    found = written(source, flat, [(known[name], value) for name, value in values.items()], sink)
    lines = zip(text.splitlines(), (found or text).splitlines(), strict=True)
    return [new.strip() for old, new in lines if old != new], [
        each.code for each in sink.diagnostics if each.code[0] == "E"
    ]


@pytest.mark.parametrize(
    ("text", "values", "lines"),
    [
        (DAMPED, {"l": 0.625}, ["parameter Length l = 62.5 cm;"]),
        (DAMPED, {"theta.start": 0.0}, ["coordinate Angle theta(start = 0 deg);"]),
        (
            DAMPED,
            {"der(theta).start": -3.141592653589793},
            ["coordinate Angle theta(start = 40 deg, der(start = -180 deg/s));"],
        ),
        (ARRAY, {"m[2]": 3.0}, ["parameter Mass m[2] = {1 kg, 3000 g};"]),
        (ARRAY, {"x[2].start": 0.05}, ["coordinate Length x[2](start = {1 cm, 5 cm});"]),
        (ARRAY, {"k": 4.0}, ['parameter Real k(unit = "N/m") = 4;']),
        (MACHINE, {"a.m": 2.5}, ["Part a(m = 2.5 kg, x(start = 2 cm)), b;  // stays"]),
        (MACHINE, {"a.k": 2.5}, ["Part a(m = 2 kg, x(start = 2 cm), k = 2.5 N/m), b;  // stays"]),
        (MACHINE, {"b.m": 0.5}, ["Part a(m = 2 kg, x(start = 2 cm)), b(m = 0.5 kg);  // stays"]),
        (
            MACHINE,
            {"a.x.start": 0.5, "b.x.start": -1},
            ["Part a(m = 2 kg, x(start = 50 cm)), b(x(start = -1 m));  // stays"],
        ),
    ],
)
def test_numbers_stand_where_they_stood(text, values, lines):
    assert changed(text, values) == (lines, [])


@pytest.mark.parametrize(("text", "name"), [(ARRAY, "kk[1]")])
def test_what_has_no_place_is_refused(text, name):
    assert changed(text, {name: 1.5}) == ([], ["E1116"])


def test_a_fit_writes_its_text(tmp_path):
    (tmp_path / "a.lag").write_text(DAMPED, encoding="utf-8")
    model = lagdsl.compile(tmp_path / "a.lag")
    motion = model.simulate(stop=2.0, interval=0.05, parameters={"l": 0.6})
    found = model.fit({"time": motion.time, "theta": motion["theta"]}, "l")
    found.write(tmp_path / "b.lag")
    found.report(tmp_path / "b.html")
    again = lagdsl.compile(tmp_path / "b.lag")
    assert again.defaults[again.parameters.index("l")] == pytest.approx(0.6, rel=1e-7)
    assert "Nothing was found" in (tmp_path / "b.html").read_text(encoding="utf-8")
    assert found._repr_html_().startswith("<iframe")
