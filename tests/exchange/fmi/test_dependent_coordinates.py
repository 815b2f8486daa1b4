"""Charges that Kirchhoff's laws tie to others, and coordinates that any constraint with constant coefficients ties, are
no states of an FMU: their number, their values, the motion."""

from __future__ import annotations

from functools import cache
from unittest.mock import patch

import fmpy
import numpy as np
import pytest
from choice import ALL, chosen
from models.corpus import MODELS, compiled

from fmi.described import table_of_model
from fmi.exported import Exported, export_quickly, exported, place
from fmi.importing import Floats, Model, exchanged
from fmi.texts import exported_text
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.exchange.fmi.variables.scalar import Role

# Independent loops of the networks, that is branches less nodes and one for each part, and what else moves: twice for
# charges and rates.
NETWORKS = {
    "library/ladder_filter": 2 * 3,  # three coils in a row, two capacitors across
    "library/rlc_circuit": 2 * 1,
    "library/coupled_circuits": 2 * 2,  # two loops, coupled by fields only
    "library/tank_circuit": 2 * 2,
    "library/dc_motor": 2 * 2,  # a loop and a shaft
    "library/generator": 2 * 2,
    "library/geophone": 2 * 3,  # a loop, the ground that is shaken and the proof mass
    "library/voice_coil": 2 * 2,
    "library/u_tube": 2 * 1,
    "atwood": 2 * 1,
}
# Rows whose coefficients are constant for another reason than that they are numbers.
UNSEEN = {"library/planar_rolling_disc": 1}  # cos(slope)^2 + sin(slope)^2
TEXT = """
model Tied "A circuit and a rope that is stopped now and then"
  import Lag.Electrical.*;
  VoltageSource source(v = 10 V*sin(300 rad/s*time));
  Resistor R(R = 5 Ohm);
  Inductor L(L = 5 mH), M(L = 3 mH);
  Capacitor C(C = 20 uF, q(start = 1e-4 C, fixed = true));
  Ground ground;
  connect(source.p, R.p);
  connect(R.n, L.p);
  connect(L.n, C.p, M.p);
  connect(source.n, C.n, M.n, ground.p);
  coordinate Length x[3](start = {0.2 m, 0.8 m, 0.1 m});
  gravity = -9.81 m/s2*world.y;
  mass 1 kg at {0 m, x[1]};
  mass 3 kg at {1 m, x[2]};
  mass 1 kg at {2 m, x[3]};
  potential 1/2*(10 N/m)*x[3]^2;
  constraint rope: x[1] + x[2] = 1 m;
  when sample(1 ms, 1 ms) then
    reinit(der(x[2]), 0 m/s);
  end when;
  annotation(experiment(StopTime = 0.003, Tolerance = 1e-10));
end Tied;
"""


GROUPS = (Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P)


def constant_rows(name: str) -> Floats:
    """Rows of J that hold rates only and are the same wherever one looks, (rows, nq), by numbers."""
    compilation = compiled(name).compilation
    functions, layout = ProgramFunctions(compilation.program), compilation.program.layout
    random, seen = np.random.default_rng(2), []
    for _ in range(3):
        state = [random.uniform(0.5, 1.5, size=layout.size(group)) for group in GROUPS]
        residual, rows = functions.evaluate("velocity_constraint", random.uniform(), *state)
        seen.append(np.where(np.abs(residual - rows @ state[1])[:, None] < 1e-14, rows, np.nan))
    same = np.all([np.all(rows == seen[0], axis=1) for rows in seen], axis=0)
    same[sorted(contact_rows(compilation.flat))] = False
    return seen[0][same]


@pytest.mark.parametrize("name", chosen(MODELS, [*NETWORKS, "four_bar", "double_atwood", "clutch"]))
def test_number_of_states(name: str) -> None:
    """All of x less two for each independent row that numbers make constant."""
    compilation = compiled(name).compilation
    rows = constant_rows(name)
    fewer = (int(np.linalg.matrix_rank(rows)) if rows.size else 0) - UNSEEN.get(name, 0)
    table = table_of_model(name, 2)
    count = sum(variable.count for _, variable in table.of(Role.STATE))
    whole = 2 * len(compilation.flat.coordinates) + len(compilation.flat.states)
    assert count == whole - 2 * fewer == len(table.structure.derivatives)
    assert count == NETWORKS.get(name, count)


@cache
def with_all_states(name: str, version: int) -> Exported:
    """The FMU in which every coordinate is a state."""
    path = place() / f"{name.replace('/', '-')}-{version}-all.fmu"
    with patch("lagdsl.exchange.fmi.variables.variables.dependent_coordinates", return_value=()):
        export_quickly(compiled(name).compilation, path, version=version)
    fmpy.extract(str(path), str(path.with_suffix("")))
    return Exported(path, path.with_suffix(""))


def motion(one: Model, names: list[str], stop: float, steps: int) -> Floats:
    """Values after each step of the classical Runge-Kutta method, which keeps linear invariants."""
    one.initialize()
    one.update()
    x, h, rows = one.states, stop / steps, [one.get(*names)]

    def rates(t: float, x: Floats) -> Floats:
        one.move(t, x)
        return one.derivatives

    for t in h * np.arange(steps):
        a = rates(t, x)
        b = rates(t + h / 2, x + h / 2 * a)
        c = rates(t + h / 2, x + h / 2 * b)
        d = rates(t + h, x + h * c)
        x = x + h / 6 * (a + 2 * b + 2 * c + d)
        one.move(t + h, x)
        rows.append(one.get(*names))
    return np.array(rows)


@pytest.mark.parametrize(("name", "version"), [(n, 2 + i % 2) for i, n in enumerate(NETWORKS) if ALL or i == 0])
def test_motion_is_that_of_all_states(name: str, version: int) -> None:
    """Every real variable, outputs and potentials among them."""
    fmu, other = exported(name, version), with_all_states(name, version)
    names = [
        v.name
        for v in fmu.variables.values()
        if v.variability == "continuous" and not v.shape and not v.name.startswith("residual.")
    ]
    stop = compiled(name).compilation.flat.experiment.stop_time / 20  # steps are short for coils of small inductance
    with exchanged(fmu) as few, exchanged(other) as all_:
        assert few.nx < all_.nx
        found, expected = motion(few, names, stop, 400), motion(all_, names, stop, 400)
    units = np.array([fmu.variables[each].unit or "1" for each in names])
    for unit in set(units.tolist()):
        of = units == unit
        assert np.max(np.abs(found[:, of] - expected[:, of])) <= 1e-10 * max(np.max(np.abs(expected[:, of])), 1e-12)


@pytest.mark.parametrize("version", [2, 3])
def test_values_follow_the_states(version: int) -> None:
    """Currents and charges by the laws of the nodes, lengths by the rope, whatever states the importer sets; what stays
    of them is found anew at events."""
    fmu = exported_text(TEXT, version, scalar=True)
    random = np.random.default_rng(1)
    with exchanged(fmu) as one:
        one.initialize({"source.q": 3e-4})
        one.update()
        states = [item.variable.derivative.name for item in fmu.description.derivatives]
        assert one.nx == len(states) == 8
        assert {"C.q", "der(C.q)", "M.q", "x[2]", "der(x[3])"} < set(states)
        begin = one.get("R.q", "M.q", "C.q", "source.q")
        assert begin[2] == 1e-4
        for t in (1e-4, 2e-4):
            x = one.states + random.normal(size=8) * 1e-3
            one.move(t, x)
            assert one.get(*states).tolist() == x.tolist()
            i = dict(zip("RLMC", one.get("der(R.q)", "der(L.q)", "der(M.q)", "der(C.q)"), strict=True))
            np.testing.assert_allclose([i["R"], i["L"]], i["M"] + i["C"], rtol=1e-14)
            np.testing.assert_allclose(-one.get("der(source.q)")[0], i["R"], rtol=1e-14)
            moved = one.get("R.q", "M.q", "C.q", "source.q") - begin
            np.testing.assert_allclose([moved[0], -moved[3]], moved[1] + moved[2], atol=1e-17)
            np.testing.assert_allclose(sum(one.get("x[1]", "x[2]")), 1.0, rtol=1e-15)
            assert one.get("der(x[1])")[0] == -one.get("der(x[2])")[0]
            assert np.max(one.get("residual.position", "residual.velocity")) < 1e-12
        rate = x[states.index("der(x[2])")]
        seed = np.eye(8)[states.index("der(M.q)")]
        np.testing.assert_array_equal(one.directional(["der(R.q)", "der(x[1])", "der(C.q)"], states, seed), [1, 0, 0])
        one.raw.enterEventMode()
        one.raw.setTime(1e-3)
        one.update()
        assert rate != 0.0
        assert abs(one.get("der(x[1])")[0]) < 1e-14 < abs(rate)
        saved = one.serialized()
        one.move(1.1e-3, one.states + 1e-3)
        expected = one.get("R.q", "x[1]", "der(x[1])").tolist()
        one.restore(saved)
        one.move(1.1e-3, one.states + 1e-3)
        assert one.get("R.q", "x[1]", "der(x[1])").tolist() == expected
