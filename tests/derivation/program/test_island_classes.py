"""An island shares nothing but time, inputs and parameters, and its program computes its part of the whole."""

from __future__ import annotations

import numpy as np
import pytest
from test_components import program

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.derivation.program.islands.classes import IslandClass, Member, island_classes
from lagdsl.derivation.program.program import Program

BALLS = """
  parameter Real m = 1; coordinate Real h[3](start = {1, 2, 3}); input Real wind = 1;
  for i in 1:3 loop
    mass m at {i + 1/2, h[i]}; force wind*m*(i + 1/2) on h[i]; contact floor: h[i] >= 0 with restitution = 1/2;
  end for;
"""
# Two balls on springs of their own, a pendulum with a stop, and what has no instants.
DIFFERENT = """
  parameter Real k = 2; coordinate Real a, b, s, x, y; discrete Integer n(start = 0);
  mass 1 at {0, a}; potential 1/2*k*a^2; contact one: a >= 0 with restitution = 1/2;
  mass 2 at {1, b}; potential 1/2*k*b^2; contact other: b >= 0 with restitution = 1/2;
  mass 3 at {sin(s), -cos(s)}; when s > 1 then n = pre(n) + 1; end when;
  mass 1 at {x, y}; potential x^2*y^2;
"""

PAIR = """
  coordinate Real a, b; mass 1 at {0, a}; mass 1 at {1, b};
  contact one: a >= 0 with restitution = 0; contact other: b >= 0 with restitution = 0;
"""


def _member(whole: Program, coordinate: str) -> tuple[IslandClass, Member]:
    place = [slot.name for slot in whole.layout.coordinates].index(coordinate)
    return next(
        (each, member)
        for each in island_classes(whole)
        for member in each.members
        if place in member.island.places["nq"]
    )


def test_islands_that_differ_in_numbers_share_a_program() -> None:
    (balls,) = island_classes(program(BALLS))
    assert [member.island.places["nq"].tolist() for member in balls.members] == [[0], [1], [2]]
    assert [member.island.count("ncontact") for member in balls.members] == [1, 1, 1]
    assert len({member.numbers.tobytes() for member in balls.members}) == 3
    assert all(len(member.inputs) == 1 for member in balls.members)


def test_what_has_no_guards_is_one_island() -> None:
    found = [
        member.island.places["nq"].tolist() for each in island_classes(program(DIFFERENT)) for member in each.members
    ]
    assert sorted(found) == [[0], [1], [2], [3, 4]]


@pytest.mark.parametrize(
    "tie",
    [
        "potential 1/2*(a - b)^2;",
        "constraint rod: a - b = 0;",
        "friction pad: der(a) - der(b) with limit = 1;",
        "contact both: a - b >= 0 with restitution = 0;",
        "when a > 1 then reinit(der(b), 0); end when;",
        'when a > 1 and b > 1 then terminate("over"); end when;',
        "output Real sum = a + b;",
    ],
)
def test_what_couples_them(tie: str) -> None:
    assert island_classes(program(PAIR))
    assert not island_classes(program(PAIR + tie))


@pytest.mark.parametrize(
    ("text", "coordinate"), [(BALLS, "h[2]"), (DIFFERENT, "b"), (DIFFERENT, "s"), (DIFFERENT, "x")]
)
def test_an_island_computes_its_part(text: str, coordinate: str) -> None:
    whole = program(text)
    of, member = _member(whole, coordinate)
    random = np.random.default_rng(3)
    axes = {Group.Q: "nq", Group.QD: "nq", Group.QDD: "nq", Group.Z: "nz", Group.W: "nw", Group.LAMBDA: "nc"}
    values = {group: random.uniform(0.5, 1.0, whole.layout.size(group)) for group in Group if group < Group.DIRECTION_Q}
    own = {group: values[group][member.island.places[axis]] for group, axis in axes.items()}
    own[Group.TIME], own[Group.U] = values[Group.TIME], values[Group.U][list(member.inputs)]
    own[Group.P] = np.concatenate([values[Group.P][list(member.parameters)], member.numbers])
    for function in of.program.functions:
        if not all(group in own for group in function.arguments) or function.name == "start":
            continue
        for result, block, all_ in zip(
            BY_NAME[function.name].results, function.results, whole.function(function.name).results, strict=True
        ):
            if not result.shape or result.name == "entry":
                continue
            expected = np.reshape(evaluate(whole.graph, all_.elements, values), all_.shape)
            expected = expected[np.ix_(*(member.island.places[axis] for axis in result.shape))]
            found = np.reshape(evaluate(of.program.graph, block.elements, own), block.shape)
            np.testing.assert_allclose(found, expected, rtol=1e-12, err_msg=f"{function.name} {result.name}")


@pytest.mark.parametrize("text", [BALLS, DIFFERENT])
def test_energies_are_sums_over_islands(text: str) -> None:
    whole = program(text)
    values = {group: np.full(whole.layout.size(group), 0.7) for group in Group if group < Group.DIRECTION_Q}
    expected = evaluate(whole.graph, [block.elements[0] for block in whole.function("energies").results], values)
    total = np.zeros(len(expected))
    for each in island_classes(whole):
        for member in each.members:
            own = {group: np.full(each.program.layout.size(group), 0.7) for group in values}
            own[Group.P] = np.concatenate([np.full(len(member.parameters), 0.7), member.numbers])
            blocks = each.program.function("energies").results
            total += evaluate(each.program.graph, [block.elements[0] for block in blocks], own)
    np.testing.assert_allclose(total, expected, rtol=1e-12)
