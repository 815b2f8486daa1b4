"""The nearest name."""

import pytest
from choice import together
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.foundation.diagnostics.suggest import distance, nearest

_NAMES = st.text("abcA", max_size=8)


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("", "", 0),
        ("", "abc", 3),
        ("theta", "thta", 1),
        ("theta", "tehta", 1),
        ("kitten", "sitting", 3),
        ("ca", "abc", 3),
    ],
)
def test_known_distances(left, right, expected):
    assert distance(left, right) == expected


@given(_NAMES, _NAMES)
def test_distance_is_symmetric_and_bounded(left, right):
    assert distance(left, right) == distance(right, left)
    assert (distance(left, right) == 0) == (left == right)
    assert abs(len(left) - len(right)) <= distance(left, right) <= max(len(left), len(right))


@given(_NAMES, _NAMES, st.integers(0, 4))
def test_a_bound_changes_no_distance_within_it(left, right, most):
    exact, bounded = distance(left, right), distance(left, right, most)
    assert bounded == exact if exact <= most else bounded > most


@given(_NAMES, st.text("abc", min_size=1, max_size=3), _NAMES)
def test_common_ends_do_not_count(prefix, middle, suffix):
    assert distance(prefix + middle + suffix, prefix + suffix) == len(middle)


@together(
    ("name", "candidates", "expected"),
    [
        ("thta", ["phi", "theta", "beta"], "theta"),
        ("Theta", ["theta", "thetas"], "theta"),
        ("strat", ["start", "state"], "start"),
        ("M", ["m", "l"], "m"),
        ("x", ["y", "z"], None),
        ("ma", ["mb", "xa"], "mb"),
        ("l1", ["l2", "m1"], "l2"),
        ("velocity", ["Velocity", "Acceleration"], "Velocity"),
        ("zzzz", ["theta"], None),
        ("", ["theta"], None),
        ("a" * 1000, ["a" * 999], None),
        ("theta", ["theta"], None),
        ("Frce", ["force", "Force"], "Force"),
    ],
)
def test_nearest(name, candidates, expected):
    assert nearest(name, candidates) == expected


@given(_NAMES, st.lists(_NAMES, max_size=6), st.randoms(use_true_random=False))
def test_order_of_candidates_does_not_matter(name, candidates, random):
    shuffled = candidates[:]
    random.shuffle(shuffled)
    assert nearest(name, candidates) == nearest(name, shuffled)
