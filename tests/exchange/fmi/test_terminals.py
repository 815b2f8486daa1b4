"""Ports of mechanisms in terminalsAndIcons.xml: valid, with members that are variables, and only where they fit."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import fmpy
from lxml import etree

from fmi.described import of_text, table_of
from lagdsl.exchange.fmi.description.terminals import terminals

SCHEMA = etree.XMLSchema(etree.parse(Path(fmpy.__file__).parent / "schema" / "fmi3" / "fmi3TerminalsAndIcons.xsd"))

PORTS = """model Ports
  parameter Mass m = 1 kg;
  parameter Inertia J = 1 kg.m2;
  input Force F;
  input Torque tau[2];
  input Force unseen;
  input Length road(smooth = 3);
  coordinate Length x(start = 1 m), y, s;
  coordinate Angle phi, psi;
  Velocity v = der(x);
  Force G = F;
  output Length position = x;
  output Velocity speed = v;
  output Angle angle = phi;
  output AngularAcceleration acceleration = der(der(phi));
  output Angle sum = phi + psi;
  output Length twice = 2*s;
  mass m at {x, road, y};
  kinetic 1/2*J*der(phi)^2 + 1/2*J*der(psi)^2 + 1/2*m*der(s)^2;
  gravity = 0;
  force G on x;
  force F on s;
  force unseen on y;
  torque tau[1] on phi;
  torque 2*tau[2] on psi;
end Ports;
"""


def ports(text: str, version: int = 3) -> dict[str, list[tuple[str, ...]]] | None:
    given = table_of(of_text(text), 3 if version == 3 else 2)
    found = terminals(given)
    if found is None:
        return None
    SCHEMA.assertValid(etree.fromstring(found.encode()))
    names = {variable.name for variable in given.variables}
    result = {}
    for terminal in ElementTree.fromstring(found).iter("Terminal"):
        assert terminal.attrib["matchingRule"] == "plug"
        members = [(m.attrib["memberName"], m.attrib["variableName"], m.attrib["variableKind"]) for m in terminal]
        assert all(variable in names for _, variable, _ in members)
        result[terminal.attrib["name"]] = members
    return result


def test_forces_meet_the_motion_that_they_act_on() -> None:
    """Through definitions, too. A coordinate that no output tells, and an output of more than one, make no port; nor do
    entries of arrays, which have no names of their own."""
    assert ports(PORTS) == {
        "x": [("s", "position", "signal"), ("v", "speed", "signal"), ("f", "F", "inflow")],
        "road": [
            ("s", "road", "signal"),
            ("v", "der(road)", "signal"),
            ("a", "der(road,2)", "signal"),
            ("d3s", "der(road,3)", "signal"),
        ],
    }


def test_what_turns_has_an_angle_and_a_torque() -> None:
    text = PORTS.replace("tau[2];", "tau;").replace("tau[1]", "tau").replace("torque 2*tau[2] on psi;", "")
    found = ports(text)
    assert found is not None
    assert found["phi"] == [("phi", "angle", "signal"), ("a", "acceleration", "signal"), ("tau", "tau", "inflow")]


def test_most_models_have_an_icon_only() -> None:
    text = "model Still coordinate Length x; gravity = 0; mass 1 kg at {x, 0}; end Still;"
    assert ports(text) == {}
    assert ports(text, version=2) is None
