"""Records: complete with the first object, however it is made."""

import copy
import pickle
import subprocess
import sys
from dataclasses import field, fields, replace

import pytest

from lagdsl.record import record
from lagdsl.source import SourceFile
from lagdsl.units.dimension import LENGTH


@record()
class Base:
    a: int
    b: int = 2


@record(kw_only=True)
class Derived(Base):
    c: list[int] = field(default_factory=list, compare=False, repr=False)


@record()
class Special:
    a: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Special)

    def __hash__(self) -> int:
        return 7


def test_inherited_fields_come_first_and_defaults_hold():
    made = Derived(1, c=[3])
    assert [f.name for f in fields(made)] == ["a", "b", "c"]
    assert (made.a, made.b, made.c) == (1, 2, [3])
    assert repr(made) == "Derived(a=1, b=2)"
    with pytest.raises(TypeError):
        Derived(1, 2, [3])


def test_comparison_regards_the_class_and_the_fields_that_count():
    assert Derived(1, c=[1]) == Derived(1, c=[2]) != Base(1)
    assert hash(Derived(1, c=[1])) == hash(Derived(1, c=[2]))
    assert replace(Base(1), b=5) == Base(1, 5) != Base(1)


def test_a_class_keeps_what_it_says_of_comparison_itself():
    assert Special(1) == Special(2)
    assert hash(Special(1)) == 7
    assert SourceFile("a.lag", "x") != SourceFile("a.lag", "x")


def test_there_is_no_place_for_other_attributes():
    with pytest.raises(AttributeError):
        Base(1).other = 1  # type: ignore[attr-defined]


@pytest.mark.parametrize("made", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])
def test_copies_are_equal(made):
    assert made(Derived(1, c=[3])) == Derived(1)
    assert made(Derived(1, c=[3])).c == [3]


def test_a_process_that_only_unpickles_has_whole_records():
    text = pickle.dumps(LENGTH).hex()
    check = f"import pickle; one, other = (pickle.loads(bytes.fromhex({text!r})) for _ in range(2))"
    check += "; print(one == other, hash(one) == hash(other), one)"
    done = subprocess.run([sys.executable, "-c", check], capture_output=True, text=True, check=True)
    assert done.stdout == f"True True {LENGTH!r}\n"
