"""LaTeX of derivations through a TeX engine, where there is one: no errors, and nothing beside the page."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from choice import chosen

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import flatten_file, read

_MODELS = Path(__file__).parents[3] / "models"
_EVERY = sorted(str(path.relative_to(_MODELS).with_suffix("")) for path in _MODELS.rglob("*.lag"))
# Letters of TeX and of the model, δ, vectors too wide for a line, tables with code, contacts, no equations, chapters.
_SOME = ["double_pendulum", "ball_on_moving_table", "library/parts_with_play", "library/blocks_linear"]
_OVERFULL = re.compile(r"^Overfull \\hbox \(([\d.]+)pt too wide\)", re.MULTILINE)
_NARROW = 40.0


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no TeX engine")
@pytest.mark.parametrize("name", chosen(_EVERY, _SOME))
def test_latex_compiles(name: str, tmp_path: Path) -> None:
    sink = Sink()
    file = read(_MODELS / f"{name}.lag", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    (tmp_path / "derivation.tex").write_text(render(recipe(flat), "latex", units=True), encoding="utf-8")
    done = subprocess.run(
        ["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "derivation.tex"],
        cwd=tmp_path,
        capture_output=True,
        timeout=120,
        check=False,
    )
    log = (tmp_path / "derivation.log").read_text(encoding="latin-1")
    assert done.returncode == 0, log[-2000:]
    assert all(float(width) < _NARROW for width in _OVERFULL.findall(log))
    assert "[U+" not in (tmp_path / "derivation.tex").read_text(encoding="utf-8")
