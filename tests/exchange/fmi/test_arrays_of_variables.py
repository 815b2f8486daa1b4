"""When numbers become arrays of FMI 3: complete, in order, alike; and nothing is lost or doubled in any case."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from fmi.described import of_text, table_of, tree
from lagdsl.exchange.fmi.variables.arrays import grouped
from lagdsl.exchange.fmi.variables.names import Name
from lagdsl.exchange.fmi.variables.scalar import Attributes, Initial, Role, Scalar

LENGTH = Attributes(role=Role.OUTPUT, unit="m")
MASS = Attributes(role=Role.OUTPUT, unit="kg")


def scalar(name: str, first: int, attributes: Attributes = LENGTH, initial: Initial = "calculated") -> Scalar:
    path, _, rest = name.partition("[")
    indices = tuple(int(index) for index in rest.rstrip("]").split(",") if index)
    return Scalar(name=Name(path, indices), first=first, attributes=attributes, initial=initial, key=attributes)


def shapes(*scalars: Scalar) -> list[tuple[str, tuple[int, ...]]]:
    return [(variable.name, variable.shape) for variable in grouped(scalars, arrays=True)]


def numbered(*names: str) -> list[Scalar]:
    return [scalar(name, place) for place, name in enumerate(names)]


def test_complete_arrays_are_arrays() -> None:
    assert shapes(*numbered("q[1]", "q[2]", "x", "A[1,1]", "A[1,2]", "A[1,3]", "A[2,1]", "A[2,2]", "A[2,3]")) == [
        ("q", (2,)),
        ("x", ()),
        ("A", (2, 3)),
    ]
    assert shapes(*numbered("a[1]", "b[1]")) == [("a", (1,)), ("b", (1,))]


def test_others_stay_numbers() -> None:
    alone = ()
    assert shapes(*numbered("q[2]")) == [("q[2]", alone)]
    assert shapes(*numbered("q[1]", "q[3]")) == [("q[1]", alone), ("q[3]", alone)]
    assert shapes(*numbered("q[2]", "q[1]")) == [("q[2]", alone), ("q[1]", alone)]
    assert shapes(*numbered("A[1,1]", "A[2,2]")) == [("A[1,1]", alone), ("A[2,2]", alone)]
    assert shapes(*numbered("q[1]", "x", "q[2]")) == [("q[1]", alone), ("x", alone), ("q[2]", alone)]
    assert shapes(scalar("q[1]", 0), scalar("q[2]", 2)) == [("q[1]", alone), ("q[2]", alone)]
    assert shapes(scalar("q[1]", 0), scalar("q[2]", 1, MASS)) == [("q[1]", alone), ("q[2]", alone)]


def test_one_entry_that_is_searched_for_makes_the_start_of_all_a_guess() -> None:
    (found,) = grouped([scalar("q[1]", 0, initial="exact"), scalar("q[2]", 1, initial="approx")], arrays=True)
    assert found.initial == "approx"


@given(st.lists(st.tuples(st.sampled_from("ab"), st.integers(1, 3), st.booleans()), unique_by=lambda e: e[:2]))
def test_every_number_is_there_once(entries: list[tuple[str, int, bool]]) -> None:
    scalars = [
        scalar(f"{path}[{index}]", place, MASS if heavy else LENGTH)
        for place, (path, index, heavy) in enumerate(entries)
    ]
    found = grouped(scalars, arrays=True)
    assert [entry for variable in found for entry in variable.entries] == list(range(len(entries)))
    assert len({variable.name for variable in found}) == len(found)


def test_types_have_names_of_their_own() -> None:
    """Not that of a variable, as FMI asks; texts outside of p are constants; there may be no types at all."""
    text = """type speed = Velocity;
    model Names
      parameter String way = "abc";
      coordinate Length x; gravity = 0; mass 1 kg at {x, 0};
      output speed v = der(x);
      output Real speed = x/(1 m);
    end Names;"""
    root = tree(table_of(of_text(text), 2))
    assert [kind.attrib["name"] for kind in root.findall("TypeDefinitions/SimpleType")] == ["Length", "speed_"]
    (way,) = (v for v in root.iter("ScalarVariable") if v.attrib["name"] == "way")
    assert way.attrib["variability"] == "constant" and way[0].attrib == {"start": "abc"}
    plain = "model Plain state Real z(start = 1); equation der(z) = -z/(1 s); end Plain;"
    for version in (2, 3):
        assert tree(table_of(of_text(plain), 2 if version == 2 else 3)).find("TypeDefinitions") is None
