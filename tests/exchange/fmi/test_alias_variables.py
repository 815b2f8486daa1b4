"""Other names of merged coordinates in descriptions: aliases of the variable, for arrays of the whole array."""

from __future__ import annotations

import pytest
from fmpy.model_description import read_model_description
from fmpy.validation import validate_model_description

from fmi.described import description, of_text, table_of, table_of_text, tree
from fmi.description_rules import broken, entries
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.foundation.diagnostics import Sink

PENDULUMS = """
model Row
  model Chain
    coordinate Angle a[2](each start = 0.1 rad);
    kinetic 1/2*(1 kg.m2)*(der(a[1])^2 + der(a[2])^2);
  end Chain;
  model Springs
    coordinate Angle b[2] "of the spring";
    potential 1/2*(4 N.m)*(b[1]^2 + b[2]^2);
  protected
    coordinate Angle inner[2];
  equation
    connect(inner, b);
  end Springs;
  Chain chain;
  Springs springs;
  connect(chain.a, springs.b);
end Row;
"""


def aliases(version: int, **ports: object) -> dict[str, str]:
    """By other name the variable that it is."""
    root = tree(table_of(of_text(PENDULUMS), version, ports=Ports(**ports), sink=Sink()))
    if version == 3:
        return {a.attrib["name"]: v.attrib["name"] for v in root.find("ModelVariables") for a in v.findall("Alias")}
    found = entries(root)
    references = [v.attributes["valueReference"] for v in found]
    first = {reference: v.name for reference, v in zip(reversed(references), reversed(found), strict=True)}
    named = [(v.name, first[reference]) for reference, v in zip(references, found, strict=True)]
    return {name: own for name, own in named if name != own}


@pytest.mark.parametrize("version", [2, 3])
def test_descriptions_with_aliases_keep_the_rules(version):
    assert broken(tree(table_of_text(PENDULUMS, version))) == []
    assert "of the spring" in description(table_of_text(PENDULUMS, version))


def test_arrays_are_aliases_as_wholes_and_protected_names_are_none():
    assert aliases(3) == {
        "springs.b": "chain.a",
        "der(springs.b)": "der(chain.a)",
        "der(springs.b,2)": "der(chain.a,2)",
    }
    assert aliases(2)["springs.b[2]"] == "chain.a[2]" and len(aliases(2)) == 6
    assert aliases(3, scalar=True)["der(springs.b[1])"] == "der(chain.a[1])"


def test_an_alias_of_an_initial_unknown_is_a_variable_of_its_own(tmp_path):
    """The coordinates are outputs; with a constraint their starts are where a search begins. fmpy takes an alias of
    such an output for an unknown that is missing."""
    text = PENDULUMS.replace("Chain chain;", "constraint sin(chain.a[1]) = sin(0.1 rad); Chain chain;")
    found = table_of_text(text, 3)
    (other,) = [variable for variable in found.variables if variable.name == "springs.b"]
    assert (other.attributes.causality, other.attributes.doc, other.count) == ("local", "of the spring", 2)
    assert broken(tree(found)) == []
    (tmp_path / "modelDescription.xml").write_text(description(found), encoding="utf-8")
    read = read_model_description(str(tmp_path), validate=False)
    assert validate_model_description(read, validate_model_structure=True) == []


def test_names_that_are_hidden_or_asked_for():
    assert "springs.b" not in aliases(3, hidden=("springs.b",)) and "der(springs.b)" in aliases(
        3, hidden=("springs.b",)
    )
    shown = table_of(of_text(PENDULUMS), 3, ports=Ports(outputs=("der(springs.b)",)), sink=Sink())
    assert [v.name for v in shown.variables if v.attributes.causality == "output"] == ["der(chain.a)"]
