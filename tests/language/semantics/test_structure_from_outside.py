"""Structural parameters that are set from outside, by numbers and by texts: one flattening reads all of them."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.motion.pipeline import flatten_set, flatten_unit, parse_file

# Values of some decide how many elements there are, and so which others can be set.
TEXT = """model Bar
  structural parameter Integer n(min = 1, max = 9) = 1;
  coordinate Real x[n];
  kinetic 1/2*(1 kg.m2)*sum(der(x[i])^2 for i in 1:n);
end Bar;
model Row
  structural parameter Integer k = 1;
  Bar bar[k, 2];
end Row;
model Rows
  structural parameter Integer N = 2, a[2] = {1, 2};
  Row row[N];
  Bar last[N];
  output Real o = a[1] + a[2];
end Rows;
"""


def set_to(pairs: Mapping[str, str]) -> tuple[FlatModel | None, Sink]:
    sink = Sink()
    unit = parse_file(SourceFile("rows.lag", TEXT), sink)
    assert unit is not None
    return flatten_set(unit, sink, model="Rows", pairs=pairs), sink


def sizes(flat: FlatModel | None) -> dict[str, float]:
    assert flat is not None
    return {each.name: each.value for each in flat.parameters if each.name.endswith(".n")}


@pytest.mark.parametrize("turn", [1, -1])
def test_values_bring_names_that_others_set(turn: int) -> None:
    """N brings the third row, k there a second pair of bars; the order of the settings is that of the user."""
    pairs = {"N": "3", "row[3].k": "2", "row[3].bar[2,1].n": "4", "last.n": "{1, 2, 3}"}
    found = sizes(set_to(dict(list(pairs.items())[::turn]))[0])
    assert len(found) == 2 + 2 + 4 + 3
    assert {name: value for name, value in found.items() if value != 1.0} == {
        "row[3].bar[2,1].n": 4.0,
        "last[2].n": 2.0,
        "last[3].n": 3.0,
    }


def test_values_in_braces_go_through_arrays_of_components_row_by_row() -> None:
    found = sizes(set_to({"row.k": "{2, 2}", "row.bar.n": "{{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}}"})[0])
    assert {name: value for name, value in found.items() if name.startswith("row")} == {
        f"row[{i}].bar[{j},{k}].n": float(4 * (i - 1) + 2 * (j - 1) + k) for i in (1, 2) for j in (1, 2) for k in (1, 2)
    }


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ({"last.n": "{1, 2, 3}"}, "`last.n` has 2 elements"),
        ({"N": "3", "last.n": "{1, 2}"}, "`last.n` has 3 elements"),
        ({"last[1].n": "0"}, "at least 1"),
        ({"last[3].n": "1"}, r"no parameter `last\[3\].n`"),
        ({"N": "1, 2"}, "one value stands here"),
        ({"last.n": "2"}, "`last.n` is an array"),
    ],
)
def test_texts_that_do_not_fit(pairs: dict[str, str], message: str) -> None:
    with pytest.raises(SettingError, match=message):
        set_to(pairs)


@pytest.mark.parametrize("pairs", [{"a[1]": "4"}, {"a": "{4, 5}"}])
def test_elements_of_arrays_are_refused(pairs: dict[str, str]) -> None:
    flat, sink = set_to(pairs)
    assert flat is None
    assert {d.code for d in sink.diagnostics} == {"E0222"}


@pytest.mark.parametrize("name", ["a", "a[1]", "last[3].n"])
def test_numbers_that_nothing_takes_are_refused(name: str) -> None:
    sink = Sink()
    unit = parse_file(SourceFile("rows.lag", TEXT), sink)
    assert unit is not None
    assert flatten_unit(unit, sink, model="Rows", structural={name: 4.0}) is None
    assert [d.code for d in sink.diagnostics] == ["E0222"]
