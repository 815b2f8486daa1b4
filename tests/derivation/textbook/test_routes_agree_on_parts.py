"""The two derivations of models by hand, which between them hold every kind of item, give the same functions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from choice import chosen
from derived_programs import derive as derive_on_graph

from lagdsl.derivation.program.verify import verify
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.lower import lower
from lagdsl.language.flat.model import FlatModel
from textbook import models
from textbook.compare import FUNCTIONS, disagreement, names, random_arguments


@pytest.mark.parametrize("make", chosen(models.ALL, models.ALL[:7:2]), ids=lambda make: make.__name__)
def test_all_functions_agree(make: Callable[[], FlatModel]) -> None:
    flat = make()
    graph, textbook = derive_on_graph(flat), lower(derive(flat), flat)
    verify(textbook)
    assert names(graph) == names(textbook)
    arguments = random_arguments(graph, np.random.default_rng(7), states=20)
    for function in FUNCTIONS:
        worst = disagreement(graph, textbook, function, arguments)
        assert all(value < 1e-12 for value in worst.values()), (function, worst)
