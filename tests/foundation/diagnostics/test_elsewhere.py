"""Diagnostics that a model text alone does not draw."""

import sys

import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax.parser import parse
from lagdsl.motion.pipeline import check, flatten_file, flatten_unit
from lagdsl.motion.signals.table_io import write_table

TWO = """model One
  structural parameter Integer count = 1;
  coordinate Length x;
  kinetic 1/2*(1 kg)*count*der(x)^2;
end One;
"""


def test_asked_for_a_model_that_is_not_there():
    sink = Sink()
    assert flatten_file(SourceFile("a.lag", TWO), sink, model="Once") is None
    (diagnostic,) = sink.diagnostics
    assert (diagnostic.code, diagnostic.help) == ("E0217", "did you mean `One`?")


def test_asked_for_a_structural_parameter_that_is_not_there():
    sink = Sink()
    unit = parse(SourceFile("a.lag", TWO), sink)
    assert unit is not None
    assert flatten_unit(unit, sink, structural={"counts": 2.0}) is None
    (diagnostic,) = sink.diagnostics
    assert (diagnostic.code, diagnostic.help) == ("E0222", "did you mean `count`?")


@pytest.mark.parametrize("literal", ["2 m/s", "2 m.s"])
def test_n0106_is_a_note_of_a_dimension_error(literal):
    text = f"""model Slider
  parameter Mass m = 1 kg;
  parameter Time s = 1 s;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
  potential 2*x/s + {literal};
end Slider;
"""
    diagnostics, _ = check(SourceFile("a.lag", text))
    assert diagnostics[0].code == "E0401" or diagnostics[0].code == "E0404"
    (note,) = diagnostics[0].notes
    assert note.startswith(f"`{literal}` is a number with a unit, not a product with `m`")


def test_a_package_that_is_missing(tmp_path, monkeypatch):
    trajectory = lagdsl.compile(TWO).simulate(stop=0.1)
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    sink = Sink()
    write_table(trajectory, tmp_path / "motion.parquet", sink)
    (diagnostic,) = sink.diagnostics
    assert diagnostic.code == "E0825" and "`pyarrow`" in diagnostic.message
    assert list(tmp_path.iterdir()) == []
