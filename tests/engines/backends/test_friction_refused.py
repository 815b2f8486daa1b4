"""Targets that have no words for dry friction, or would not find a load that depends on its own accelerations."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner
from friction_texts import BEARING, BLOCK, FREEWHEEL, GEAR

import lagdsl
from lagdsl.engines.backends.modelica.capability_checks import report_inexpressible
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.main import lag


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (BLOCK, ["friction `dry`"]),
        (FREEWHEEL, ["contact `wheel`"]),
        (BEARING, ["friction `journal`", "load `limit(journal)`"]),
    ],
)
def test_modelica_has_no_friction(text: str, what: list[str]) -> None:
    sink = Sink()
    report_inexpressible(lagdsl.compile(text)._compilation.flat, sink)
    assert [each.code for each in sink.diagnostics] == ["E0915"] * len(what)
    assert all(each in told.message for each, told in zip(what, sink.diagnostics, strict=True))


@pytest.mark.parametrize("target", ["casadi", "jax", "numpy"])
@pytest.mark.parametrize("text", [BLOCK, GEAR], ids=["block", "gear"])
def test_modules_that_do_not_find_a_load_are_refused(text: str, target: str, tmp_path: Path) -> None:
    source = tmp_path / "model.lag"
    source.write_text(text, encoding="utf-8")
    found = CliRunner().invoke(lag, ["build", str(source), "--target", target, "-o", str(tmp_path / "out")])
    refused = text == GEAR and target != "numpy"
    assert (found.exit_code != 0) == refused, found.output
    assert ("E0916" in found.output) == refused
    assert (tmp_path / "out").exists() != refused
