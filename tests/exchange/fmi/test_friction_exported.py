"""Exported models with dry friction, contacts of rates and loads of friction move as closed forms say, in both kinds.

Each model has machines beside each other, so that guards of several are there at the same time.
"""

from __future__ import annotations

import fmpy
import pytest
from attack.test_friction import carried
from choice import chosen, repeats
from fmpy import simulate_fmu

from fmi.exact_importer import Instance, ends_exactly
from fmi.texts import exported_text

STOP = 8.0
# A block that stops, one that is thrown back, one that breaks away, a stick-slip belt, a clutch, a puck on a belt.
PLANES = """model Planes
  coordinate Real s(der(start = 3)), r(der(start = 1)), w, c(der(start = 0.5));
  coordinate Real a(der(start = 4)), b, x, y(der(start = 2));
  kinetic der(s)^2 + 1/2*(der(r)^2 + der(w)^2 + der(c)^2) + der(a)^2 + 1.5*der(b)^2 + 1/2*(der(x)^2 + der(y)^2);
  potential c^2;
  force -6 on r;
  force 2*time on w;
  friction stops: der(s) with limit = 6;
  friction reverses: der(r) with limit = 2;
  friction breaks: der(w) with limit = 1, sticking = 3;
  friction carried: der(c) - 0.5 with limit = 1, sticking = 1.5;
  friction plates: der(a) - der(b) with limit = 6;
  friction pad: {der(x) - 1, der(y)} with limit = 1;
  annotation(units = "none", experiment(StopTime = 8, Tolerance = 1e-8));
end Planes;
"""
BELT = carried(1.5, 1.0, STOP)
PLANES_END = {
    "s": 1.5,  # stops at 1 s
    "der(s)": 0.0,
    "der(r)": -4.0 * (STOP - 1 / 8),  # comes to rest at 1/8 s
    "der(w)": STOP**2 - STOP - 0.75,  # slips from 1.5 s on with 2 t - 1
    "c": BELT["x"],
    "der(c)": BELT["der(x)"],
    "der(a)": 1.6,  # the momentum 8 of both
    "der(b)": 1.6,
    "x": STOP - 5**0.5 / 2,  # slips with sqrt(5) at first, on a straight line
    "y": 5**0.5,
}
# A block that bounces with friction, one that its load lets slip and lift off, and a freewheel.
CONTACTS = """model Contacts
  coordinate Real x(der(start = 2)), h(start = 0.05), u, v, a, b;
  gravity = {0, -10, 0};
  mass 1 at {x, h, 0};
  contact floor: h >= 0 with restitution = 0.5, friction = 0.2, slip = der(x);
  mass 1 at {u, v, 1};
  force 1 on u;
  force 15*time on v;
  contact table: v >= 0 with restitution = 0;
  friction drags: der(u) with limit = 0.2*multiplier(table);
  kinetic der(a)^2 + 1.5*der(b)^2;
  force (time - 1)*(time - 2) on a;
  contact wheel: der(b) - 2*der(a) >= 0;
  output Real drag = multiplier(drags);
  annotation(units = "none", experiment(StopTime = 3, Tolerance = 1e-8));
end Contacts;
"""
# The block loses 0.6, 0.3, ... at its bounces, lies from 0.3 s on with 1.4, and stops at 1 s. The other one slips from
# 1/3 s on with 3 t - 1, and flies from 2/3 s on. The wheels part at 1 s and meet at 2.5 s.
CONTACTS_END = {"x": 1.01, "der(x)": 0.0, "der(u)": 1 / 6 + 7 / 3, "der(a)": 1.5 / 14, "der(b)": 3 / 14}
KINDS = [("ModelExchange", 2), ("CoSimulation", 2), ("ModelExchange", 3), ("CoSimulation", 3)]


def _check(ends: dict[str, float], found: dict[str, float], near: float) -> None:
    for name, value in ends.items():
        assert found[name] == pytest.approx(value, rel=near, abs=near), name


@pytest.mark.parametrize(("kind", "version"), chosen(KINDS, KINDS[:1] + KINDS[3:]))
def test_friction_that_sticks_and_slips(kind: str, version: int) -> None:
    fmu = exported_text(PLANES, version)
    rows = simulate_fmu(str(fmu.folder), fmi_type=kind, stop_time=STOP, output_interval=0.8, output=[*PLANES_END])
    _check(PLANES_END, {name: rows[name][-1] for name in PLANES_END}, 1e-6)


@pytest.mark.parametrize(("kind", "version"), chosen(KINDS, KINDS[1:3]))
def test_friction_under_contacts(kind: str, version: int) -> None:
    fmu = exported_text(CONTACTS, version)
    names = [*CONTACTS_END, "drag"]
    rows = simulate_fmu(str(fmu.folder), fmi_type=kind, stop_time=3.0, output_interval=0.5, output=names)
    _check(CONTACTS_END, {name: rows[name][-1] for name in CONTACTS_END}, 3e-5)
    drag = rows["drag"][rows["time"] == 0.5]
    assert drag == pytest.approx(-0.2 * 2.5, abs=1e-9)  # the table bears 2.5


@repeats("test_friction_that_sticks_and_slips")
def test_an_exact_importer_of_friction() -> None:
    _check(PLANES_END, ends_exactly(exported_text(PLANES, 2), STOP, [*PLANES_END], {}), 1e-9)


def test_indicators_are_those_of_relations_contacts_and_friction() -> None:
    assert exported_text(PLANES, 2).description.numberOfEventIndicators == 6
    assert exported_text(CONTACTS, 3).description.numberOfEventIndicators == 3 + 2


def test_loads_of_forces_have_no_directional_derivatives() -> None:
    fmu = exported_text(CONTACTS, 3)
    told = (fmu.folder / "modelDescription.xml").read_text(encoding="utf-8")
    assert told.count('providesDirectionalDerivatives="false"') == 2
    assert told.count('providesAdjointDerivatives="false"') == 2
    one = Instance(fmu, 3.0, {})
    with pytest.raises(fmpy.fmi1.FMICallException):
        one.fmu.getDirectionalDerivative(
            [fmu.variables["der(x,2)"].valueReference], [fmu.variables["x"].valueReference], [1.0]
        )
    one.fmu.freeInstance()
