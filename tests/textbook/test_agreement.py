"""The oracle: on every model of the corpus the graph route and the literal derivation give the same functions."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.derive import derive as derive_on_graph
from lagdsl.pipeline import front, read
from lagdsl.semantics.flat_model import FlatModel
from lagdsl.textbook.derive import derive
from lagdsl.textbook.lower import lower
from textbook.compare import FUNCTIONS, disagreement, names, random_arguments

_MODELS = sorted((Path(__file__).parents[2] / "models").glob("*.lag"))


def flat_model(path: Path) -> FlatModel:
    sink = Sink()
    file = read(path, sink)
    assert file is not None
    flat = front(file, sink)
    assert flat is not None, sink.diagnostics
    return flat


@pytest.mark.parametrize("path", _MODELS, ids=lambda path: path.stem)
def test_both_derivations_agree(path: Path) -> None:
    flat = flat_model(path)
    graph, textbook = derive_on_graph(flat), lower(derive(flat), flat)
    assert names(graph) == names(textbook)
    arguments = random_arguments(graph, np.random.default_rng(11), states=50)
    for function in FUNCTIONS:
        worst = disagreement(graph, textbook, function, arguments)
        assert all(value < 1e-12 for value in worst.values()), (function, worst)
