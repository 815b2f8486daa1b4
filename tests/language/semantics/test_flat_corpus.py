"""Drop a text into tests/corpus/flat: its flat model stands beside it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from choice import spread, together
from flattening import run

from lagdsl.foundation.diagnostics import Severity
from lagdsl.language.flat.text import flat_text

CORPUS = Path(__file__).parents[2] / "corpus" / "flat"
MODELS = Path(__file__).parents[3] / "models"


@pytest.mark.parametrize("path", sorted(CORPUS.glob("*.lag")), ids=lambda path: path.stem)
def test_flat(path: Path) -> None:
    flat, sink = run(path.read_text(encoding="utf-8"))
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    text = flat_text(flat)
    expectation = path.with_suffix(".flat")
    if os.environ.get("LAGDSL_UPDATE") or not expectation.exists():
        expected = expectation.read_text(encoding="utf-8") if expectation.exists() else None
        expectation.write_text(text, encoding="utf-8")
        assert expected is not None, f"{expectation.name} was missing and has been written: read it"
    assert text == expectation.read_text(encoding="utf-8")


@together("path", spread(sorted(MODELS.glob("*.lag")), 30))
def test_models_are_accepted(path: Path) -> None:
    flat, sink = run(path.read_text(encoding="utf-8"))
    assert flat is not None
    assert all(d.severity is Severity.NOTE for d in sink.diagnostics), [d.message for d in sink.diagnostics]
