"""Further outputs of a model that is compiled: the same functions as those of the whole model compiled anew."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.scene.living import living
from lagdsl.derivation.scene.vectors import with_vectors
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.listing import computed_outputs
from lagdsl.motion.pipeline import compile_flat, compile_observed, flatten_file, read

ROOT = Path(__file__).parents[3]
# Without constraints; with ranks; friction that feeds back; turns of cut joints; rows with factors, N0612.
MODELS = (
    *("models/double_pendulum.lag", "models/four_bar.lag", "models/drum_brake.lag", "models/andrews_squeezer.lag"),
    *("models/bouncing_ball.lag", "tests/corpus/reject/N0612.lag"),
)


def values(program):
    """Result blocks by function at random arguments, with the sizes of their terms; layouts have the same lengths."""
    random = np.random.default_rng(1)
    groups = {group for function in program.functions for group in function.arguments} - {Group.TIME}
    symbols = {group: random.uniform(0.5, 1.5, program.layout.size(group)) for group in sorted(groups)}
    symbols[Group.TIME] = 0.3
    found = {}
    for function in program.functions:
        nodes = [node for block in function.results for node in block.elements]
        told = np.array(evaluate_with_size(program.graph, nodes, symbols), dtype=float).reshape(-1, 2)
        found[function.name] = ([(block.name, block.shape) for block in function.results], told)
    return found


def same(observed, anew):
    assert observed.program.layout == anew.program.layout
    assert observed.program.kept_rows == anew.program.kept_rows
    ours, theirs = values(observed.program), values(anew.program)
    assert ours.keys() == theirs.keys()
    for name, (blocks, told) in ours.items():
        expected, wanted = theirs[name]
        assert blocks == expected, name
        close = np.abs(told[:, 0] - wanted[:, 0]) <= 1e-11 * np.maximum(told[:, 1], wanted[:, 1])
        both = ~np.isfinite(told[:, 0]) & ~np.isfinite(wanted[:, 0])
        assert np.all(close | both), name


@pytest.mark.parametrize("name", MODELS)
def test_the_model_with_its_scene_and_with_its_arrows(name):
    flat = flatten_file(read(ROOT / name, Sink()), Sink())
    shown = living(replace(flat, outputs=computed_outputs(flat)), [each.name for each in flat.coordinates]).flat
    assert len(shown.parameters) > len(flat.parameters)
    observed = compile_observed(compile_flat(flat, Sink()), shown)
    same(observed, compile_flat(shown, Sink()))
    arrows = with_vectors(flat, [each.name for each in flat.coordinates]).flat
    same(compile_observed(observed, arrows), compile_flat(arrows, Sink()))
