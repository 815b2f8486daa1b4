"""Texts that are spelled alike have one value in their scope; energies that show that they are not negative."""

from __future__ import annotations

import pytest
from flattening import run

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.traversal import records
from lagdsl.language.semantics.wellformed.semidefinite import Semidefinite

BEAM = """model M
  parameter Mass m = 1 kg;
  parameter Real k(unit = "N/m") = 2;
  coordinate Length x[3];
  for i in 1:3 loop
    kinetic 1/2*m*der(x[i])^2;
    potential 1/2*k*(x[i] - (if i == 1 then 0 else x[max(i-1, 1)]))^2;
    potential k*(x[i] - (if i == 1 then 0 else x[max(i-1, 1)]))*(1 m);
  end for;
end M;
"""


def differences(energy: fx.FlatExpression) -> list[fx.Binary]:
    return [node for node in records(energy) if isinstance(node, fx.Binary) and node.operator == "-"]


def test_a_text_has_one_node_in_a_turn_and_another_in_the_next() -> None:
    flat, _ = run(BEAM)
    assert flat is not None
    potentials = [term.value for term in flat.energies if term.kind == "potential"]
    nodes = [differences(value)[0] for value in potentials]
    assert [nodes[2 * i] is nodes[2 * i + 1] for i in range(3)] == [True] * 3
    assert len({id(node) for node in nodes}) == 3
    assert nodes[2] == fx.Binary("-", fx.Variable("x[2]"), fx.Variable("x[1]"))


def test_a_text_without_the_index_has_one_node_in_all_turns() -> None:
    flat, _ = run(BEAM)
    assert flat is not None
    kinetic = [term.value for term in flat.energies if term.kind == "kinetic"]
    halves = [value.left for value in kinetic if isinstance(value, fx.Binary)]
    assert halves[0] is halves[1] is halves[2]


def test_an_index_hides_the_one_around_it() -> None:
    flat, _ = run("""model M
  coordinate Length x[2];
  for i in 1:2 loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    potential (1 N)*x[i]*sum(i for i in 1:2);
    for i in 2:2 loop
      potential (1 N)*x[i];
    end for;
  end for;
end M;
""")
    assert flat is not None
    inner = [term.value for term in flat.energies if term.kind == "potential"][1::2]
    assert {str(node.name) for value in inner for node in records(value) if isinstance(node, fx.Variable)} == {"x[2]"}


def test_operands_of_one_turn_are_of_another_type() -> None:
    """A sum is checked once for operands of the same types: where they differ it is checked again."""
    _, sink = run("""model M
  coordinate Length x[4];
  for i in 1:4 loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    potential (1 N)*(x[i] - (if i == 3 then 2 s else 1 m));
  end for;
end M;
""")
    assert [each.code for each in sink.diagnostics] == ["E0401"]


def test_a_zero_of_one_turn_stays_one() -> None:
    flat, _ = run("""model M
  coordinate Length x[3];
  for i in 1:3 loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    potential (1 N)*(x[i] + x[1]*(if i == 2 then 0 else 3));
  end for;
end M;
""")
    assert flat is not None
    sums = [
        term.value.right for term in flat.energies if isinstance(term.value, fx.Binary) and term.kind == "potential"
    ]
    added = [value.right for value in sums if isinstance(value, fx.Binary)]
    product = fx.Binary("*", fx.Variable("x[1]"), fx.Number(3.0))
    assert added == [product, fx.ZERO, product]


def test_every_place_of_a_fault_is_told() -> None:
    _, sink = run("model M\n  coordinate Length x;\n  kinetic (x + 1 kg)*(x + 1 kg);\nend M;\n")
    places = {(each.code, each.labels[0].span.start) for each in sink.diagnostics if each.code == "E0401"}
    assert len(places) == 2


def test_discontinuities_of_both_places_are_met() -> None:
    flat, _ = run("""model M
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  output Real a = (if x > 0 m then 1 else 0) + (if x > 0 m then 1 else 0);
end M;
""")
    assert flat is not None
    assert {each.name for each in flat.events.relations} == {"x > 0 m"}


@pytest.mark.parametrize(
    ("energy", "shown"),
    [
        ("1/2*m*v^2", True),
        ("1/2*k*v^2", False),
        ("m*(v*v + 3*v^4)/2", True),
        ("m*(v*v - 3*v^4)/2", False),
        ("m*v*w", False),
        ("m*(v + w)*(v + w)", True),
        ("-m*v^2", False),
        ("m*abs(v)^3", True),
        ("m*v^3", False),
        ("if v > 0 then m*v^2 else 0", True),
    ],
)
def test_energies_that_show_that_they_are_not_negative(energy: str, shown: bool) -> None:
    flat, _ = run(f"""model M
  annotation(units = "none");
  parameter Real m = 1;
  parameter Real k = -1;
  coordinate Real v;
  coordinate Real w;
  kinetic 1/2*der(v)^2 + 1/2*der(w)^2;
  potential {energy};
end M;
""")
    assert flat is not None
    assert Semidefinite(flat).of(flat.energies[1].value) is shown
