"""Nothing is dropped because another search came by first; one fault is told once."""

from __future__ import annotations

import pytest
from flattening import run

from lagdsl.language.flat.model import FlatModel

ROTOR = """
model Rotor
  coordinate Angle q;
  kinetic 1/2*(2 kg.m2)*der(q)^2;
end Rotor;
"""


def errors(text: str) -> list[tuple[str, str]]:
    flat, sink = run(text, model="M")
    found = [(d.code, d.labels[0].span.text) for d in sink.diagnostics if d.code[0] == "E"]
    assert (flat is None) == bool(found)
    return found


def flat_of(text: str) -> FlatModel:
    flat, sink = run(text, model="M")
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    return flat


@pytest.mark.parametrize(
    "value",
    ["{r[i].q for j in 1:3}", "{(1 + k[i])*r[j].q for j in 1:3}", "fill(r[i].q, 3)", "{r[1].q, r[2].q, r[i].q}"],
)
def test_an_unknown_index_is_told(value: str) -> None:
    body = f"  Rotor r[3];\n  parameter Real k[3] = {{1, 2, 3}};\n  Angle a[3] = {value};\n"
    assert errors(f"{ROTOR}model M\n{body}  potential (1 J)*a*a;\nend M;\n") == [("E0201", "i")]


def test_a_fault_behind_a_subscript_is_told() -> None:
    body = "  Rotor r[3];\n  structural parameter Integer n = 1 + wrong;\n  potential (1 J)*r[n].q^2;\n"
    assert errors(f"{ROTOR}model M\n{body}end M;\n") == [("E0201", "wrong")]


def test_an_index_of_a_sum_hides_a_name_of_the_class() -> None:
    """A spring on angles of joints that close a loop keeps all of them as unknowns, not the one `i` names outside."""
    linkage = """
model M
  import Lag.Planar.*;
  structural parameter Integer i = 1;
  Revolute p[4];
  Link a(l = 0.4 m, m = 1 kg), b(l = 1 m, m = 1 kg), c(l = 0.8 m, m = 1 kg);
  Fixed pin(r = {1 m, 0});
  gravity = 0;
  connect(world, p[1], a, p[2], b, p[3], c, p[4], pin);
  potential (i*1 J)*sum(p[i].q^2 for i in RANGE);
end M;
"""
    assert len(flat_of(linkage.replace("RANGE", "1:4")).coordinates) == 4
    assert len(flat_of(linkage.replace("RANGE", "1:3")).coordinates) == 3


def test_turns_of_a_loop_are_one_fault() -> None:
    joined = "  for k in 1:3 loop\n    connect(world, r[k].frame);\n  end for;\n"
    assert errors(f"{ROTOR}model M\n  Rotor r[3];\n{joined}end M;\n") == [("E0210", "frame")]
    beyond = "  output Real s = sum(r[k].q for k in 2:9);\n"
    assert errors(f"{ROTOR}model M\n  Rotor r[3];\n{beyond}end M;\n") == [("E0316", "k")]


def test_an_equation_of_an_unknown_element_is_one_fault() -> None:
    body = "  Rotor r;\n  Torque t[3];\n  torque t[1] on r.q;\n"
    body += "equation\n  for j in 1:3 loop\n    t[i] = 1 N.m;\n  end for;\n"
    assert errors(f"{ROTOR}model M\n{body}end M;\n") == [("E0201", "i")]


def test_what_hangs_on_an_unknown_component_is_not_told() -> None:
    text = "  import Lag.Planar.*;\n  Revolut pin;\n  Link bar(l = 1 m, m = 1 kg);\n  gravity = -g_n*world.y;\n"
    assert errors(f"model M\n{text}  connect(world, pin, bar);\nend M;\n") == [("E0208", "Revolut")]
