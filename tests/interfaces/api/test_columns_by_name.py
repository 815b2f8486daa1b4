"""Arrays of columns by their name, of one motion and of many."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl

ROW = """model Row
  coordinate Length x[2](start = {0.1 m, 0.2 m});
  kinetic 1/2*(1 kg)*(der(x[1])^2 + der(x[2])^2);
end Row;
"""


def test_arrays_by_their_name() -> None:
    model = lagdsl.compile(ROW, engine="tape")
    motion = model.simulate(stop=1.0, interval=0.5, start={"der(x)": [1.0, 2.0]})
    assert motion["x"].tolist() == pytest.approx(np.array([[0.1, 0.2], [0.6, 1.2], [1.1, 2.2]]))
    assert motion["der(x)"].shape == (3, 2) and motion["der(x)"][0].tolist() == [1.0, 2.0]
    many = model.simulate_many(start={"x": [[0.1, 0.2], [0.3, 0.4]]}, stop=1.0, interval=0.5)
    assert many["x"].shape == (2, 3, 2) and many["x"][1, 0].tolist() == [0.3, 0.4]
    for columns in (motion, many):
        with pytest.raises(KeyError, match="no column `xx`"):
            columns["xx"]


def test_where_every_run_failed_the_name_of_a_column_is_answered_with_the_reason() -> None:
    text = "model M input Force f; coordinate Length x; kinetic (1 kg)*der(x)^2; force f on x; end M;"
    many = lagdsl.compile(text, engine="tape").simulate_many(
        start={"x": [0.0, 1.0]}, inputs={"f": ([0.0, 1.0], [0.0, 1.0])}, stop=2.0
    )
    with pytest.raises(KeyError, match="every run failed, the first one because E0817: the table of input `f` covers"):
        many["x"]
