"""Rows of a loop that come near to depending on each other: little is left in the equations down to there,
whichever way an engine takes, and elimination gives way to the dense solution in time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import linkages
import mpmath
import numpy as np
import pytest
import test_singular_positions as singular
from choice import ALL, chosen
from compiled_programs import program_of
from models.many_states import left_in_equations

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine

MODELS = Path(__file__).parents[2] / "models"
DISTANCES = 10.0 ** -np.arange(1.0, 9.0)
RATES = 4
LEFT = 1e-10  # of the size of the terms

Positions = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """Positions by coordinate as mpmath numbers, on the constraints, for one angle per loop: all zero is singular.

    There rows depend on each other, or, `pruned_dependencies`, the only one is zero.
    """

    source: str | Path
    positions: Callable[..., Positions]
    loops: int = 1
    pruned_dependencies: bool = False
    parameters: Mapping[str, float] = field(default_factory=dict)


def drawn_out(e: Any) -> Positions:
    """Crank 1, coupler 3, rocker 2, base 4: the crank lies at pi, and the rest in one line."""
    a = mpmath.pi + e
    x, y = mpmath.cos(a), mpmath.sin(a)
    along, across = 4 - x, -y
    to_pin = along**2 + across**2
    far = mpmath.sqrt(to_pin)
    inner = mpmath.acos((to_pin + 9 - 4) / (6 * far)) * mpmath.sign(e)
    coupler = mpmath.atan2(across, along) + inner
    rocker = mpmath.atan2(y + 3 * mpmath.sin(coupler), x + 3 * mpmath.cos(coupler) - 4)
    return {"A": a, "B": coupler - a, "C": rocker - coupler}


def bars(count: int) -> str:
    """Parallel cranks, each pair standing on the coupler of the one before."""
    loops = []
    for i in range(1, count + 1):
        base = "world" if i == 1 else f"coupler{i - 1}"
        loops.append(f"""
  coordinate Angle a{i}(start = 30 deg), b{i}(start = -30 deg), c{i}(start = 30 deg);
  frame crank{i} = {base}.rotz(a{i}).move({{0.4 m, 0, 0}}), coupler{i} = crank{i}.rotz(b{i});
  frame rocker{i} = {base}.move({{1 m, 0, 0}}).rotz(c{i}).move({{0.4 m, 0, 0}});
  body on_crank{i}(m = 1 kg, com = {{-0.2 m, 0, 0}}, Izz = 0.01 kg.m2) on crank{i};
  body on_coupler{i}(m = 2 kg, com = {{0.4 m, 0.1 m, 0}}, Izz = 0.2 kg.m2) on coupler{i};
  body on_rocker{i}(m = 0.5 kg, com = {{-0.3 m, 0, 0}}, Izz = 0.01 kg.m2) on rocker{i};
  constraint pin{i}: rocker{i}.origin = coupler{i}.point({{1 m, 0, 0}});""")
    return f"model Bars\n  gravity = -g_n*world.y;{''.join(loops)}\nend Bars;\n"


def standing(*e: Any) -> Positions:
    pairs = enumerate(e, 1)
    return {name: x for i, own in pairs for name, x in ((f"a{i}", own), (f"b{i}", -own), (f"c{i}", own))}


def crank_and_rod(e: Any) -> Positions:
    return {"th": mpmath.pi / 2 - e, "ph": e - mpmath.pi / 2}


PARALLEL = {"crank.l": 0.4, "coupler.l": 1.0, "rocker.l": 0.4}
CASES = {
    "parallelogram": Case(singular.PARALLELOGRAM, lambda e: {"A": e, "B": -e, "C": e}),
    "two parallelograms, one on the other": Case(
        singular.STACKED, lambda e, f: {"A": e, "B": -e, "C": e, "D": f, "F": -f, "G": f}, loops=2
    ),
    "three, each on the one before": Case(bars(3), standing, loops=3),
    "third bar": Case(linkages.THREE_BARS, lambda e: {"A": e, "B": -e, "C": e, "D": e}),
    "drawn out": Case(singular.NEUTRAL, drawn_out),
    "crank as long as its rod": Case(singular.SLIDER_CRANK, crank_and_rod, pruned_dependencies=True),
    "model four_bar_angles": Case(
        MODELS / "four_bar_angles.lag", lambda e: {"a": e, "b": 0 * e, "c": e}, parameters={"l3": 0.4}
    ),
    "model four_bar_points": Case(
        MODELS / "four_bar_points.lag", lambda e: {"a": e, "b": 0 * e, "c": e}, parameters={"l3": 0.4}
    ),
    "model four_bar": Case(
        MODELS / "four_bar.lag", lambda e: {"A.q": e, "B.q": -e, "C.q": e - mpmath.pi}, parameters=PARALLEL
    ),
    "model four_bar_spatial": Case(
        MODELS / "four_bar_spatial.lag",
        lambda e: {"A.q": e, "B.q": -e, "C.q": e - mpmath.pi},
        parameters={"l3": 0.4},
    ),
    "model slider_crank": Case(
        MODELS / "slider_crank.lag", crank_and_rod, parameters={"r": 0.15}, pruned_dependencies=True
    ),
}


def states(case: Case, program: Program) -> dict[Group, np.ndarray]:
    """RATES states at each distance, the nearest last; loops beside the first are at distances of their own."""
    random = np.random.default_rng(7)
    names = [slot.name for slot in program.layout.coordinates]
    rows = []
    with mpmath.workdps(60):
        for distance in np.repeat(DISTANCES, RATES):
            apart = distance * random.uniform(0.5, 2.0, case.loops)
            place = [mpmath.mpf(float(x)) for x in apart]
            pace = [mpmath.mpf(float(x)) for x in random.normal(size=case.loops)]

            def moved(t: Any, place: list[Any] = place, pace: list[Any] = pace) -> list[Any]:
                found = case.positions(*(x + v * t for x, v in zip(place, pace, strict=True)))
                return [found[name] for name in names]

            step = mpmath.mpf(10) ** -20 * min(abs(x) for x in place)
            ahead, behind = moved(step), moved(-step)
            q = [float(x) for x in moved(0)]
            rows.append((q, [float((x - y) / (2 * step)) for x, y in zip(ahead, behind, strict=True)]))
    named = zip(program.layout.parameters, program.layout.defaults, strict=True)
    p = [case.parameters.get(slot.name, default) for slot, default in named]
    layout = program.layout
    sizes = {Group.Z: len(layout.states), Group.U: len(layout.inputs), Group.W: len(layout.discretes)}
    count = len(rows)
    return {
        Group.TIME: np.zeros(count),
        Group.Q: np.array([q for q, _ in rows]),
        Group.QD: np.array([qd for _, qd in rows]),
        Group.P: np.tile(p, (count, 1)),
        **{group: np.zeros((count, size)) for group, size in sizes.items()},
    }


IN_C = ("two parallelograms, one on the other", "model four_bar_spatial", "drawn out")


@pytest.mark.parametrize("name", chosen(CASES, ("parallelogram", "third bar", "model slider_crank")))
def test_little_is_left_in_the_equations(name: str) -> None:
    case = CASES[name]
    program = program_of(case.source)
    here = states(case, program)
    arguments = [here[group] for group in STATE]
    *_, pivot = NumpyEngine(program).evaluate_many("elimination", *arguments)
    assert pivot[0] > 1e-4
    assert case.pruned_dependencies or abs(pivot[-1]) < 1e-12
    dense = replace(program, functions=tuple(f for f in program.functions if f.name != "elimination"), kept_rows=())
    compiled = [CEngine(program)] if ALL or name in IN_C else []
    for engine in (NumpyEngine(program), *compiled, NumpyEngine(dense)):
        qdd, lam = engine.solve_many(*arguments)
        assert left_in_equations(program, here, qdd, lam) < LEFT
