"""Reports of the corpus in all four formats. A missing expectation is written, and fails once, so that it is read."""

from __future__ import annotations

from pathlib import Path

import pytest
from choice import chosen

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import FORMATS, render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read

_CORPUS = Path(__file__).parents[2] / "corpus" / "derive"
_MODELS = Path(__file__).parents[3] / "models"
_TEXTS = chosen(
    ("bead_on_hoop", "double_pendulum", "four_bar", "gyroscope_in_gimbals", "robot_arm"),
    ("bead_on_hoop", "four_bar", "robot_arm"),
)
_DERIVED = sorted(_CORPUS.glob("*.lag"))
_QUICK = [path for path in _DERIVED if path.stem != "rolling_coin"]
_SUFFIX = {"text": ".txt", "markdown": ".md", "latex": ".tex", "html": ".html"}


def flat_model(path: Path) -> FlatModel:
    sink = Sink()
    file = read(path, sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None, sink.diagnostics
    return flat


@pytest.mark.parametrize("path", chosen(_DERIVED, _QUICK), ids=lambda path: path.stem)
def test_reports_are_as_reviewed(path: Path) -> None:
    found = recipe(flat_model(path))
    missing = []
    for to in FORMATS:
        text, expected = render(found, to), path.with_suffix(_SUFFIX[to])
        if not expected.exists():
            expected.write_text(text, encoding="utf-8")
            missing.append(expected.name)
            continue
        assert text == expected.read_text(encoding="utf-8"), f"{expected.name} differs; delete it to write it anew"
    assert not missing, f"written, read them: {missing}"


@pytest.mark.parametrize("name", _TEXTS)
def test_texts_of_models_read_as_reviewed(name: str) -> None:
    text = render(recipe(flat_model(_MODELS / f"{name}.lag")), "text")
    expected = _CORPUS / f"{name}.txt"
    if not expected.exists():
        expected.write_text(text, encoding="utf-8")
        raise AssertionError(f"written, read it: {expected.name}")
    assert text == expected.read_text(encoding="utf-8"), f"{expected.name} differs; delete it to write it anew"
