"""Names of the structured naming convention: any text has one, and no two texts have the same."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.exchange.fmi.variables.names import Name, apart, aside, belonging, named, structured

# The grammar of FMI 2.0.5, section 2.2.9, and of FMI 3.0.2, section 2.4.7.5.1, without the escapes.
B_NAME = r"(?:[_A-Za-z][_A-Za-z0-9]*|'[_A-Za-z0-9!#$%&()*+,\-./:;<>=?@\[\]^{}|~ ]+')"
INDICES = r"(?:\[[0-9]+(?:,[0-9]+)*\])?"
IDENTIFIER = rf"{B_NAME}{INDICES}(?:\.{B_NAME}{INDICES})*"
CONVENTION = re.compile(rf"{IDENTIFIER}|der\({IDENTIFIER}(?:,[1-9][0-9]*)?\)")

WORDS = st.tuples(st.sampled_from("azAZ_"), st.text("bY_09", max_size=4)).map("".join)
PARTS = st.builds(lambda word, index: f"{word}[{index}]" if index else word, WORDS, st.integers(0, 12))
PATHS = st.lists(PARTS, min_size=1, max_size=4).map(".".join)


@pytest.mark.parametrize(
    ("text", "order", "expected"),
    [
        ("theta", 0, "theta"),
        ("theta", 1, "der(theta)"),
        ("theta", 2, "der(theta,2)"),
        ("arm.q[2]", 1, "der(arm.q[2])"),
        ("wheel[2].spin", 2, "der(wheel[2].spin,2)"),
        ("A[1,2]", 0, "A[1,2]"),
        ("der(road)", 0, "der(road)"),
        ("der(der(road))", 0, "der(road,2)"),
        ("der(road[3])", 1, "der(road[3],2)"),
    ],
)
def test_names_of_variables(text: str, order: int, expected: str) -> None:
    assert named(text, order).text == expected


@pytest.mark.parametrize(
    ("row", "expected", "of_array"),
    [
        ("wire", "wire.multiplier", "wire.multiplier"),
        ("pin[2]", "pin.multiplier[2]", "pin.multiplier"),
        ("gear.mesh", "gear.mesh.multiplier", "gear.mesh.multiplier"),
        ("closure(D)[2]", "D.closure.multiplier[2]", "D.closure.multiplier"),
        ("closure(leg[1].ball)[3]", "leg[1].ball.closure.multiplier[3]", "leg[1].ball.closure.multiplier"),
        ("node(section[3].coil.n)", "section[3].coil.n.node.multiplier", "section[3].coil.n.node.multiplier"),
        ("norm(pose.e)", "pose.e.norm.multiplier", "pose.e.norm.multiplier"),
    ],
)
def test_what_belongs_to_a_row_is_named_after_what_it_is_about(row: str, expected: str, of_array: str) -> None:
    assert belonging(row, "multiplier").text == expected
    assert belonging(row, "multiplier").array == of_array


@given(PATHS, st.integers(0, 3))
def test_names_of_models_stay_as_they_are(path: str, order: int) -> None:
    text = named(path, order).text
    assert CONVENTION.fullmatch(text)
    assert path in text and "'" not in text


@given(st.text(max_size=20), st.integers(0, 2))
def test_any_text_has_a_name_of_the_convention(text: str, order: int) -> None:
    assert CONVENTION.fullmatch(Name(structured(text), (), order).text)


@given(st.text(max_size=8), st.text(max_size=8))
def test_different_texts_have_different_names(first: str, second: str) -> None:
    assert (structured(first) == structured(second)) == (first == second)


@given(st.lists(PATHS, max_size=10))
def test_what_is_added_begins_like_nothing_else(paths: list[str]) -> None:
    taken = [named(path, order).text for path in [*paths, "energy", "energy_.x"] for order in (0, 1)]
    free = aside("energy", taken)
    assert free == "energy__"
    assert not any(re.match(rf"(?:der\()?{free}(?:$|[.\[)])", text) for text in taken)


def test_arrays_move_aside_together() -> None:
    names = [Name("pin.multiplier", (1,)), Name("pin.multiplier", (2,)), Name("wire.multiplier")]
    moved = apart(names, ["pin.multiplier[2]", "pin.multiplier_[1]", "wire"])
    assert [name.text for name in moved] == ["pin.multiplier__[1]", "pin.multiplier__[2]", "wire.multiplier"]
