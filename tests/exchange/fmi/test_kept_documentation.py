"""Documentation is written once for all that it follows from."""

from __future__ import annotations

import pytest

from lagdsl.exchange.fmi import documentation, kept_documentation
from lagdsl.exchange.fmi.export_model import export_model
from lagdsl.exchange.fmi.kept_documentation import kept_documentation as kept
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import compile_flat, flatten_file

SPRING = """model Spring
  parameter Mass m = 2 kg;
  coordinate Length x(start = 1 m);
equation
  kinetic m*der(x)^2/2;
  potential 3 N/m*x^2/2;
end Spring;
"""


def exported(text=SPRING):
    compilation = compile_flat(flatten_file(SourceFile("spring.lag", text), Sink()), Sink())
    return export_model(compilation, 2, ("me", "cs"), {}, {}, Sink())


@pytest.fixture
def written(monkeypatch, tmp_path):
    """What was written, where nothing is kept yet."""
    asked = []

    def write(export_model, known, header):
        asked.append(export_model)
        return {"documentation/index.html": b"page %d" % len(asked), "model.png": bytes(100)}

    monkeypatch.setattr(documentation, "documentation_files", write)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return asked


def test_the_same_model_finds_it_written(written):
    first = kept(exported(), "<fmi/>", None, "header")
    assert kept(exported(), "<fmi/>", None, "header") == first
    assert len(written) == 1
    assert first["documentation/index.html"] == b"page 1"


@pytest.mark.parametrize(
    "old, new", [("2 kg", "3 kg"), ("3 N/m*x^2/2", "3 N/m*x*x/2"), ("m = 2 kg;", 'm = 2 kg "of the block";')]
)
def test_another_text_is_written_anew(written, old, new):
    kept(exported(), "<fmi/>", None, "header")
    assert old in SPRING
    found = kept(exported(SPRING.replace(old, new)), "<fmi/>", None, "header")
    assert found["documentation/index.html"] == b"page 2"


def test_another_description_is_written_anew(written):
    """It has variables and the token of the sources."""
    kept(exported(), "<fmi/>", None, "header")
    kept(exported(), "<other/>", None, "header")
    kept(exported(), "<fmi/>", None, "another header")
    assert len(written) == 3


def test_other_writers_write_anew(written, monkeypatch):
    kept(exported(), "<fmi/>", None, "header")
    monkeypatch.setattr(kept_documentation, "_writers", lambda: ["another version"])
    kept(exported(), "<fmi/>", None, "header")
    assert len(written) == 2
