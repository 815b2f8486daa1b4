"""Coordinates that the equations couple are one component; others are another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from derived_programs import derive

import lagdsl
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.textbook.derive import derive as textbook_derive
from lagdsl.derivation.textbook.lower import lower
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

ROOT = Path(__file__).parents[3]

BESIDE = "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2;"


def program(text: str, derivation: str = "graph") -> Program:
    sink = Sink()
    header = "initial equation" if "initial equation" in text else "equation"
    items, _, equations = text.partition(header)
    section = f"{header}\n  {equations}\n" if equations else ""
    whole = f'model M\n  {items}\n  annotation(units = "none");\n{section}end M;\n'
    flat = flatten_file(SourceFile("<text>", whole), sink)
    assert flat is not None, sink.diagnostics
    return derive(flat) if derivation == "graph" else lower(textbook_derive(flat), flat)


APART = [
    "",
    "potential a^2 + b^4;",
    "force time on a; force sin(time) on b;",
    "force (if time > 1 then 1 else 2) on a; force (if time > 1 then 3 else 2) on b;",
    "parameter Real k = 3; potential k*a^2 + k*b^2;",
    "input Real u; force u on a; force 2*u on b;",
    "output Real both = a + b; invariant E: energy();",
    "contact one: a >= -1 with restitution = 1; contact two: b >= -1 with restitution = 0;",
    "friction one: der(a) with limit = 1; friction two: der(b) with limit = 2;",
    "contact one: der(a) >= 0; contact two: der(b) >= 0;",
    "constraint one: a = sin(time); force -multiplier(one)^2 on a; friction two: der(b) with limit = time;",
    "force (if a > 1 then -1 else 0) on a; force (if b > 1 then -1 else 0) on b;",
    "constraint one: a = 0.1*time; constraint two: b = 0;",
    "discrete Integer n(start = 0); equation when a > 1 then n = pre(n) + 1; end when;",
]
TOGETHER = [
    "potential (a - b)^2;",
    "kinetic der(a)*der(b);",
    "dissipation 1/2*(der(a) - der(b))^2;",
    "force a on b;",
    "force (if a > 1 then -1 else 0) on b;",
    "constraint one: a + b = 0;",
    "constraint one: der(a) = der(b);",
    "contact one: a >= b with restitution = 1;",
    "contact one: der(a) >= der(b);",
    "friction one: der(a) - der(b) with limit = 1;",
    "friction one: {der(a), der(b)} with limit = 1;",
    "friction one: der(a) with limit = b^2;",
    "friction one: der(a) with limit = 1, sticking = 1 + b^2;",
    "constraint one: a = sin(time); friction two: der(b) with limit = abs(multiplier(one));",
    "constraint one: a = sin(time); force multiplier(one) on b;",
    "state Real c(start = 0); equation der(c) = a - b;",
    "state Real c(start = 0); force c on b; equation der(c) = a;",
    "initial equation der(a) + der(b) = 1;",
    "discrete Real n(start = 0); force n on b; equation when a > 1 then n = 1; end when;",
    "equation when a > 1 then reinit(der(b), 3); end when;",
    "discrete Integer n(start = 0); equation when a > b then n = pre(n) + 1; end when;",
]


@pytest.mark.parametrize("text", APART)
def test_apart(text: str) -> None:
    assert program(f"{BESIDE} {text}").layout.components == (0, 1)


@pytest.mark.parametrize("text", TOGETHER)
def test_together(text: str) -> None:
    assert set(program(f"{BESIDE} {text}").layout.components) == {0}


def test_both_derivations_find_the_same() -> None:
    text = "coordinate Real a, b, c; kinetic 1/2*(1 + a^2)*der(a)^2 + 1/2*der(b)^2 + 1/2*der(c)^2; potential (a - c)^2;"
    for derivation in ("graph", "textbook"):
        assert program(text, derivation).layout.components == (0, 1, 0)


def test_natural_sizes_and_tolerances_are_those_of_the_component() -> None:
    """A millimetre beside a coordinate of a gigametre: the pendulum's energy is kept as if it were alone."""
    pendulum = """
      coordinate Length x(start = 0.6 mm), y(start = -0.8 mm); parameter Mass m = 1 kg;
      kinetic 1/2*m*(der(x)^2 + der(y)^2); potential m*g_n*y; constraint rod: x^2 + y^2 = (1 mm)^2;
      output Real E = 1e3*(1/2*(der(x)^2 + der(y)^2)/(1 m2/s2) + 9.80665*y/(1 m));"""
    far = "coordinate Length s(start = 1e9 m, der(start = 1e9 m/s)); kinetic 1/2*m*der(s)^2;"
    for beside in ("", far):
        text = f"model M {pendulum} {beside} end M;"
        motion = lagdsl.compile(text, engine="tape").simulate(stop=0.1, interval=0.001, tolerance=1e-9)
        assert np.ptp(motion["E"]) < 1e-6
