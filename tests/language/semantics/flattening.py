"""Texts to flat models, and what was said on the way."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Values, evaluate
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.settings.structure import check_structure
from lagdsl.language.syntax.parser import parse

PENDULUM = """model M
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  gravity = {0, -9.81 m/s2};
  mass m at {l*sin(theta), -l*cos(theta)};
"""


def run(
    text: str, structural: Mapping[str, float] | None = None, **options: object
) -> tuple[fm.FlatModel | None, Sink]:
    """The flat model of a text and the sink; parsing must succeed."""
    sink, given = Sink(), structural or {}
    unit = parse(SourceFile("x.lag", text), sink)
    assert unit is not None, sink.diagnostics
    flat = flatten(unit, sink, structural=lambda each, _: given.get(each.name), **options)  # type: ignore[arg-type]
    if flat is not None:
        check_structure(flat, given, sink)
    return flat, sink


def pendulum(body: str) -> tuple[fm.FlatModel | None, Sink]:
    """A pendulum (m, l, theta) with more in its body."""
    return run(f"{PENDULUM}{body}\nend M;\n")


def accepted(body: str) -> fm.FlatModel:
    """The flat model of a pendulum with `body`, which must have no error."""
    flat, sink = pendulum(body)
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    return flat


def said(sink: Sink) -> list[tuple[str, str]]:
    """Codes with the text at their caret."""
    return [(d.code, d.labels[0].span.text if d.labels else "") for d in sink.diagnostics]


def value_of(expression: str, kind: str = "Real", **coordinates: float) -> float:
    """The number that an expression of `x`, `y` (coordinates without a dimension) means."""
    motion = "coordinate Angle x, y; kinetic (1 J.s2)*(der(x)^2 + der(y)^2);"
    text = f"model M {motion}\noutput {kind} r = {expression};\nend M;"
    flat, sink = run(text)
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    return evaluate(flat, flat.outputs[0].value, Values(variables=coordinates))


def output(flat: fm.FlatModel, name: str) -> fx.FlatExpression:
    return next(item.value for item in flat.outputs if item.name == name)
