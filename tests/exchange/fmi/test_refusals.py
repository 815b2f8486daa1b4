"""A model that the standards cannot express is refused with its place, before anything is compiled."""

from __future__ import annotations

import pytest

from lagdsl.exchange.fmi.capability_checks import refuse
from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file

SLIDER = """model Slider
  {items}
  coordinate Length x;
  gravity = 0;
  mass 1 kg at {{x, 0}};
  force {force} on x;
end Slider;
"""
PARAMETER = "parameter Integer n({bounds}) = {value};"
DISCRETE = "discrete Integer n(start = {value}, max = {most}); when x > 1 m then n = 1; end when;"
FORCE = "-1 N*n*x/(1 m)"


def flat_of(items: str, force: str = FORCE) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("slider.lag", SLIDER.format(items=items, force=force)), sink)
    assert flat is not None, sink.diagnostics
    return flat


def found(items: str, version: int, values: dict[str, float] | None = None, force: str = FORCE) -> list[Diagnostic]:
    sink = Sink()
    refuse(flat_of(items, force), version, ("cs",), values or {}, sink)
    return list(sink.diagnostics)


@pytest.mark.parametrize(
    ("value", "refused_by"),
    [
        *(("2147483647", ()), ("-2147483648", ()), ("2147483648", (2, 3)), ("-2147483649", (2, 3))),
    ],
)
@pytest.mark.parametrize("version", [2, 3])
def test_integers_have_the_range_of_the_standard(value: str, refused_by: tuple[int, ...], version: int) -> None:
    parameters = found(PARAMETER.format(bounds="min = -inf", value=value), version)
    starts = found(DISCRETE.format(value=value, most="inf"), version)
    for told in (parameters, starts):
        assert [d.code for d in told] == (["E0902"] if version in refused_by else [])
    if version in refused_by:
        (label,) = parameters[0].labels
        assert label.span.text == "n"
        assert f"FMI {version}" in parameters[0].message and value in parameters[0].message


def test_bounds_of_integers_are_looked_at_too() -> None:
    (told,) = found(PARAMETER.format(bounds="max = 3000000000", value="2"), 2)
    assert told.message.startswith("the max of `n` is 3000000000,")
    (told,) = found(DISCRETE.format(value="2", most="3000000000"), 2)
    assert told.message.startswith("the max of `n` is 3000000000,")


def test_what_counts_is_the_value_that_is_exported() -> None:
    text = PARAMETER.format(bounds="min = 0", value="3000000000")
    assert [d.code for d in found(text, 2)] == ["E0902"]
    assert found(text, 2, {"n": 7.0}) == []
    # a start that follows a parameter
    text = "parameter Integer k = 1; " + DISCRETE.format(value="k", most="inf")
    assert found(text, 2) == []
    assert [d.code for d in found(text, 2, {"k": 3e9})] == ["E0902", "E0902"]


def test_large_real_numbers_are_no_integers() -> None:
    assert found("parameter Real n = 3e22;", 2) == []


def test_inputs_that_belong_together_are_named() -> None:
    items = "input Length road(smooth = 2);"
    (told,) = found(items, 2, force="-1 N/m*(x - road) - 1 N.s/m*der(road) - 1 kg*der(der(road))")
    assert told.code == "N0903"
    assert "`der(road)`, `der(road,2)`" in told.message
    assert told.labels[0].span.text == "road"
    assert found("input Length road;", 2, force="-1 N/m*(x - road)") == []
