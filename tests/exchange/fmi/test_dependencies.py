"""Declared dependencies against the derivatives that importers get, entry by entry; kinds by closed forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import EXPLORE, chosen
from derivatives_in_c import GROUPS, MOVED, Probe, program_of
from hypothesis import given
from hypothesis import strategies as st
from named_models import compiled

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.exchange.fmi.variables.dependencies import Entry, dependencies
from lagdsl.exchange.fmi.variables.scalar import Role
from lagdsl.motion.analysis.sparsity.coupling import components, matching
from lagdsl.motion.analysis.sparsity.influence import Kind
from lagdsl.motion.pipeline import with_names

# If only the parameters of a factor cancel, all declared dependencies are true ones.
EXACT = (
    "double_pendulum",
    "cart_double_pendulum",
    "bouncing_ball_modelica",
    "furuta_swing_up",
    "chain",
    "van_der_pol",
    "heavy_top",
    "maglev",
    "coupled_oscillators",
    "two_mass_drive",
    "kapitza_pendulum",
    "library/gear_train",
    "library/torsional_train",
)
OTHERS = (
    "four_bar",
    "rolling_coin",
    "newtons_cradle",
    "clutch",
    "pendulum_two_dependent_constraints",
    "four_bar_crank",
    "library/dc_motor",
    "library/ladder_filter",
    "library/parts_with_play",
)
POINTS = 4


def unknowns_of(program: Program) -> list[Entry]:
    """In the order in which the probe tells how they change."""
    layout = program.layout
    n, z = len(layout.coordinates), len(layout.states)
    lengths = {Role.DERIVATIVE: 2 * n + z, Role.OUTPUT: len(layout.outputs), Role.LOCAL: len(layout.definitions)}
    lengths |= {Role.ENERGY: 3, Role.MULTIPLIER: len(layout.constraints)}
    return [(role, index) for role, length in lengths.items() for index in range(length)]


def knowns_of(program: Program) -> list[Entry]:
    layout = program.layout
    lengths = {Role.STATE: 2 * len(layout.coordinates) + len(layout.states), Role.INPUT: len(layout.inputs)}
    lengths |= {Role.PARAMETER: len(layout.parameters), Role.TIME: 1}
    return [(role, index) for role, length in lengths.items() for index in range(length)]


def jacobian(path: Path, at: dict[Group, np.ndarray]) -> np.ndarray:
    """Of all unknowns with respect to all knowns, by the C runtime; accelerations are those that are pulled."""
    program, _ = program_of(path)
    unknowns, count, n = unknowns_of(program), len(knowns_of(program)), len(program.layout.coordinates)
    multipliers = sum(role is Role.MULTIPLIER for role, _ in unknowns)
    columns = []
    for unit in np.eye(count):
        ends = np.cumsum([program.layout.size(group) for group in MOVED])
        along = dict(zip(MOVED, np.split(unit[:-1], ends[:-1]), strict=True))
        changes, pulled = (Probe(path, at, along, unit[-1], rate).changes for rate in (0.0, 3.0))
        changes[n : 2 * n] = pulled[n : 2 * n]
        first = len(unknowns) - multipliers
        columns.append(np.concatenate([changes[:first], changes[len(changes) - multipliers :]]))
    return np.array(columns).T


def nonzeros(path: Path) -> np.ndarray:
    """Entries that are not zero at one random state at least, if there are accelerations. If rows depend on each other
    on the constraints only, the state is that of the start."""
    program, start = program_of(path)
    random = np.random.default_rng(1)
    found = np.zeros((len(unknowns_of(program)), len(knowns_of(program))), bool)
    for _ in range(POINTS):
        at = {group: random.uniform(0.1, 0.9, program.layout.size(group)) for group in GROUPS}
        at[Group.P] = start[Group.P] * random.uniform(0.8, 1.2, len(start[Group.P]))
        at = dict(start) if any(program.layout.redundant) else at
        kinds = program.layout.kinds
        at[Group.W] = np.array(
            [random.uniform(0.1, 0.9) if k == "variable" else random.integers(2) for k in kinds], float
        )
        try:
            there = np.abs(jacobian(path, at))
        except AssertionError:
            continue
        found |= (there > 1e-9 * np.max(there, axis=1, keepdims=True)) & (there > 1e-15 * np.max(there))
    assert np.any(found)
    return found


def pattern(program: Program) -> np.ndarray:
    rows = dependencies(program).moving
    knowns = knowns_of(program)
    named = ({entry for entry, _ in rows[unknown]} for unknown in unknowns_of(program))
    return np.array([[known in own for known in knowns] for own in named])


def path_of(root: Path, name: str) -> Path:
    return root / "models" / f"{name}.lag"


FOLDER = Path(__file__).parents[3] / "models"
EVERY = [str(path.relative_to(FOLDER).with_suffix("")) for path in sorted(FOLDER.rglob("*.lag"))]


@pytest.mark.parametrize("name", EVERY if EXPLORE else chosen((*EXACT, *OTHERS), (*EXACT[::6], *OTHERS[::4])))
def test_nothing_is_missed(root: Path, name: str) -> None:
    path = path_of(root, name)
    program, _ = program_of(path)
    missed = np.argwhere(nonzeros(path) & ~pattern(program))
    unknowns, knowns = unknowns_of(program), knowns_of(program)
    assert [(unknowns[i], knowns[j]) for i, j in missed] == []


@pytest.mark.parametrize("name", chosen(EXACT, EXACT[::6]))
def test_nothing_is_said_beyond_what_there_is(root: Path, name: str) -> None:
    path = path_of(root, name)
    program, _ = program_of(path)
    knowns = knowns_of(program)
    moving = np.array([role is not Role.PARAMETER for role, _ in knowns])
    excess = np.argwhere(pattern(program) & ~nonzeros(path) & moving)
    assert [(unknowns_of(program)[i], knowns[j]) for i, j in excess] == []


def test_small_effects_of_large_parameters_count(root: Path) -> None:
    """Accelerations follow the speed of light, far below the rounding of the rest energy."""
    program, _ = program_of(path_of(root, "relativistic_particle"))
    moving, n = dependencies(program).moving, len(program.layout.coordinates)
    light = (Role.PARAMETER, [slot.name for slot in program.layout.parameters].index("c"))
    assert any(light in dict(moving[Role.DERIVATIVE, n + i]) for i in range(n))


KINDS = """
model Kinds
  parameter Real a = 2;
  parameter Real b = 3;
  input Real u;
  state Real x(start = a + 1);
  state Real y(start = 1);
  state Real free;
  discrete Real d(start = 1);
  Real half = a/2;
  Real linear = 3*x - u/4;
  Real scaled = a*x + half*u;
  Real held = d*x + y;
  Real bent = x*u + sin(y);
  Real chosen = if b > 2 then 2*x else x + u;
  Real late = time*x;
equation
  der(x) = linear;
  der(y) = scaled - y;
  der(free) = 1;
  when sample(0, 0.5) then
    d = pre(d) + x;
  end when;
  annotation(units = "none");
end Kinds;
"""


def kinds() -> tuple[dict[str, dict[str, Kind]], dict[str, dict[str, Kind]]]:
    """By name of the definition or `der` of a state, and name of what it depends on; moving, then at the start."""
    program = with_names(compiled(KINDS))
    layout = program.layout
    names = {(Role.STATE, i): slot.name for i, slot in enumerate(layout.states)}
    names |= {(Role.DERIVATIVE, i): f"der({slot.name})" for i, slot in enumerate(layout.states)}
    names |= {(Role.INPUT, 0): "u", (Role.TIME, 0): "time"}
    for role, slots in (
        (Role.PARAMETER, layout.parameters),
        (Role.LOCAL, layout.definitions),
        (Role.DISCRETE, layout.discretes),
    ):
        names |= {(role, i): slot.name for i, slot in enumerate(slots)}
    found = dependencies(program)
    told = (
        {
            names[unknown]: {names[known]: kind for known, kind in row}
            for unknown, row in rows.items()
            if unknown in names
        }
        for rows in (found.moving, found.initial)
    )
    moving, initial = told
    return moving, initial


def test_kinds() -> None:
    moving, initial = kinds()
    constant, parameter, discrete, dependent = Kind
    assert moving["half"] == {"a": constant}
    assert moving["linear"] == moving["der(x)"] == {"x": constant, "u": constant}
    assert moving["scaled"] == {"a": dependent, "x": parameter, "u": parameter}
    assert moving["der(y)"] == {"a": dependent, "x": parameter, "u": parameter, "y": constant}
    assert moving["held"] == {"x": discrete, "y": constant, "d": dependent}
    assert moving["bent"] == {"x": dependent, "u": dependent, "y": dependent}
    assert moving["chosen"] == {"b": dependent, "x": parameter, "u": parameter}
    assert moving["late"] == {"x": dependent, "time": dependent}
    assert moving["der(free)"] == {}
    assert initial["x"] == {"x": constant, "a": constant}
    assert initial["y"] == {"y": constant}
    assert initial["linear"] == {"x": constant, "u": constant, "a": constant}
    assert initial["held"]["a"] == discrete


@given(
    st.integers(1, 7).flatmap(
        lambda n: st.lists(st.lists(st.booleans(), min_size=n, max_size=n), min_size=n, max_size=n)
    )
)
def test_blocks_are_those_of_the_inverse(flags: list[list[bool]]) -> None:
    """Of a matrix with a given pattern and random numbers an element of the inverse is zero exactly if it must be."""
    n = len(flags)
    numbers = np.random.default_rng(4).uniform(1.0, 2.0, (n, n)) * np.array(flags)
    equations = [[j for j in range(n) if flags[i][j]] for i in range(n)]
    match = matching(equations, n)
    assert all(unknown in equations[i] for i, unknown in enumerate(match) if unknown >= 0)
    assert len({unknown for unknown in match if unknown >= 0}) == sum(unknown >= 0 for unknown in match)
    assert sum(unknown >= 0 for unknown in match) >= np.linalg.matrix_rank(numbers)
    if min(match) < 0 or np.linalg.cond(numbers) > 1e8:
        return
    owner = {unknown: i for i, unknown in enumerate(match)}
    successors = [[owner[unknown] for unknown in equations[i]] for i in range(n)]
    reached: dict[int, set[int]] = {}
    for members in components(successors):
        behind = set(members)
        for member in members:
            for other in successors[member]:
                behind |= reached.get(other, set())
        reached |= dict.fromkeys(members, behind)
    inverse = np.abs(np.linalg.inv(numbers))
    pattern_of_inverse = inverse > 1e-12 * np.max(inverse)
    told = np.array([[equation in reached[owner[unknown]] for equation in range(n)] for unknown in range(n)])
    assert not np.any(pattern_of_inverse & ~told)
    assert np.array_equal(pattern_of_inverse, told)
