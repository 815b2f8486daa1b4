"""Runs: what repeats in a sequence."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from lagdsl.derivation.program.passes.repeat import Run, runs

elements = st.integers(0, 3)
sequences = st.lists(
    st.tuples(st.lists(elements, min_size=1, max_size=5), st.integers(1, 12)).map(lambda pair: pair[0] * pair[1]),
    max_size=6,
).map(lambda parts: [element for part in parts for element in part])


@given(sequences)
def test_runs_are_the_sequence(sequence: list[int]) -> None:
    found = runs(sequence)
    assert [run.start for run in found] == [0, *(run.stop for run in found)][: len(found)]
    assert (found[-1].stop if found else 0) == len(sequence)
    for run in found:
        pattern = sequence[run.start : run.start + run.period]
        assert sequence[run.start : run.stop] == pattern * run.count


def test_what_repeats_is_found_between_other_things() -> None:
    assert runs([7, *[1, 2, 3] * 5, 8, 9]) == (Run(0, 1, 1), Run(1, 3, 5), Run(16, 2, 1))
    assert runs([1, 1, 2] * 10) == (Run(0, 3, 10),)
    assert runs([4] * 30) == (Run(0, 1, 30),)
    assert runs([1, 2] * 2) == (Run(0, 4, 1),)
    assert runs([]) == ()
