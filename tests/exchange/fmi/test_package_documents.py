"""Documents in an FMU: pictures if they can be drawn, a motion as far as there is one, licenses."""

from __future__ import annotations

import html
import re
import struct

import pytest

from lagdsl.documents.plot.sheet import icon
from lagdsl.engines.runtime.building import build as building
from lagdsl.engines.runtime.building.platforms import platform_of, this_machine
from lagdsl.exchange.fmi import documentation
from lagdsl.exchange.fmi.contents import texts
from lagdsl.exchange.fmi.documentation import documentation_files
from lagdsl.exchange.fmi.export_model import export_model
from lagdsl.exchange.fmi.extra import extra_files
from lagdsl.exchange.fmi.package.binary import Objects, objects_of
from lagdsl.exchange.fmi.reference import reference
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import compile_flat, flatten_file

ELSEWHERE = Objects("Fall", (), {})  # nothing was compiled for this machine
HEADER = "/* Copyright (C) them.\n   Do\n     what you like.\n*/"
FALL = """model Fall
  parameter Length h = 4.9 m;
  coordinate Length x(start = h);
  gravity = 0;
  mass 1 kg at {x, 0};
  force -10 N on x;
equation
  assert(x > 0 m, "it has arrived");
  annotation(experiment(StopTime = 3, Interval = 0.25, Tolerance = 1e-6));
end Fall;
"""


def made(text, **start):
    sink = Sink()
    flat = flatten_file(SourceFile("text.lag", text), sink)
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return export_model(compilation, 2, ("cs",), {}, start, sink)


@pytest.fixture(scope="module")
def fall():
    return made(FALL)


@pytest.fixture(scope="module")
def known(fall):
    return reference(fall, ELSEWHERE)


def test_a_motion_that_ends_early_is_told_as_far_as_it_goes(fall, known):
    times = known.motion.time
    assert known.ended is not None
    assert "it has arrived" in known.ended
    assert times[-1] == 1.0  # the first row after x = 4.9 - 5 t^2 is zero
    assert known.motion["x"] == pytest.approx(4.9 - 5.0 * times**2, abs=1e-6)
    page = documentation_files(fall, known, HEADER)["documentation/index.html"].decode()
    assert "It ends early: " in page


def test_where_nothing_begins_there_is_nothing_to_compare_with():
    stuck = made(FALL.replace("x > 0 m", "x > 6 m"))
    assert reference(stuck, ELSEWHERE) is None
    files = documentation_files(stuck, None, HEADER)
    assert set(files) == {"documentation/index.html", "documentation/licenses/license.txt"}
    assert b"reference.csv" not in files["documentation/index.html"]
    assert extra_files(None, {}) == {}


def test_without_matplotlib_there_are_no_pictures(fall, known, monkeypatch):
    monkeypatch.setattr(documentation, "find_spec", lambda name: None)
    files = documentation_files(fall, known, HEADER)
    assert "model.png" not in files
    assert b"<img" not in files["documentation/index.html"]
    assert b"reference.csv" in files["documentation/index.html"]


def test_the_license_of_the_headers_is_theirs(fall):
    words = documentation_files(fall, None, HEADER)["documentation/licenses/license.txt"].decode()
    assert words.endswith("\n\nCopyright (C) them.\nDo\nwhat you like.\n")


def test_an_icon_is_square_and_the_same_every_time(known):
    first = icon(known.motion)
    assert first == icon(known.motion)
    assert struct.unpack(">II", first[16:24]) == (256, 256)


def test_tolerances_of_the_motion_are_below_those_of_the_experiment_but_possible(fall):
    tight = made(FALL.replace("1e-6", "1e-12"))
    assert reference(tight, ELSEWHERE).tolerance == 1e-11
    assert reference(fall, ELSEWHERE).tolerance == 1e-8


@pytest.mark.skipif(not this_machine().startswith("linux"), reason="elsewhere the compiler hides what is not exported")
def test_the_motion_is_computed_by_what_the_library_is_linked_from(fall, known, monkeypatch):
    objects = objects_of(texts(fall)[1], fall.stem, [platform_of(this_machine())])
    monkeypatch.setattr(building, "build", lambda *_, **__: pytest.fail("compiled once more"))
    found = reference(fall, objects)
    assert found.motion.names == known.motion.names
    for column in known.motion.columns:
        assert found.motion[column.name] == pytest.approx(column.values, rel=1e-12, abs=1e-12), column.name


def test_the_page_lists_ports_parameters_and_statements_with_their_components():
    compilation = made(
        """type Way = enumeration(off "no <way>", on);
model Part
  parameter Length l(min = 0.1 m) = 1 m "<b>long</b>";
  coordinate Length x(start = 1 m);
  mass 1 kg at {x*l/(1 m), 0};
end Part;
model Whole
  input Way way "which <way>";
  input Force f(min = -2 N, max = 2 N);
  gravity = 0;
  Part left, right;
  force (if way == Way.on then f else 0) on left.x;
  output Length far(nominal = 2 m) = left.x + right.x;
end Whole;
"""
    )
    page = documentation_files(compilation, None, HEADER)["documentation/index.html"].decode()
    rows = [
        [html.unescape(re.sub("<[^>]+>", "", cell)) for cell in re.findall("<td[^>]*>(.*?)</td>", row, re.DOTALL)]
        for row in re.findall("<tr>(.*?)</tr>", page, re.DOTALL)
    ]
    found = [" | ".join(cell.strip() for cell in row if cell.strip()) for row in rows]
    assert "way | input, discrete | Way | 1 off (no <way>), 2 on | 1 | which <way>" in found
    assert "f | input, continuous | Force [N] | -2 to 2 | 0.0" in found
    assert "far | output, continuous | Length [m]" in found
    assert "left.l | 1.0 | m | from 0.1 | at any time | <b>long</b>" in found
    assert "left | mass 1 kg at {x*l/(1 m), 0};" in found
    assert "right | mass 1 kg at {x*l/(1 m), 0};" in found
    assert "Whole | force (if way == Way.on then f else 0) on left.x;" in found
