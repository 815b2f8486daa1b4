"""Instances have their own values, however these reach them: as the same text written out by hand."""

from __future__ import annotations

import os

import numpy as np
import pytest
from properties.random_class_trees import class_tree

import lagdsl

COUNT = 200 if os.environ.get("LAGDSL_EXPLORE") else 4


@pytest.mark.parametrize("seed", range(COUNT))
def test_instances_are_what_is_written_out(seed: int) -> None:
    pair = class_tree(seed)
    classes, by_hand = (lagdsl.compile(text, engine="numpy") for text in (pair.classes, pair.by_hand))
    assert len(classes.coordinates) == len(by_hand.coordinates)
    one, two = classes.initial_state(), by_hand.initial_state()
    np.testing.assert_array_equal(one.q, two.q)
    rng = np.random.default_rng(seed)
    q, qd = rng.normal(size=(2, len(one.q)))
    np.testing.assert_allclose(classes.mass_matrix(0.0, q), by_hand.mass_matrix(0.0, q), rtol=1e-14)
    np.testing.assert_allclose(
        classes.forward_dynamics(0.0, q, qd)[0], by_hand.forward_dynamics(0.0, q, qd)[0], rtol=1e-12, atol=1e-12
    )
