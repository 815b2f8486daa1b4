"""Records: complete with the first object, however it is made."""

import copy
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import field, fields, replace

import pytest

import lagdsl.foundation.record
from lagdsl.foundation.record import mutable_record, record, remembered
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.dimension import LENGTH


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


@record()
class Counted:
    values: list[int] = field(default_factory=list)
    total: int = field(init=False)
    seen: list[int] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        self.total = sum(self.values)


def test_fields_that_are_no_arguments_and_what_follows_the_arguments():
    shared: list[int] = []
    made, other = Counted(shared), Counted([1, 2])
    assert made.values is shared  # an empty argument is the argument
    assert (made.total, other.total) == (0, 3)
    assert made.seen is not other.seen
    assert Counted().values is not Counted().values
    with pytest.raises(TypeError):
        Counted([1], 2)


def test_names_of_fields_are_free():
    @record()
    class Names:
        missing: int
        default_b: int = 3
        made: list[int] = field(default_factory=list)

    assert (Names(1).missing, Names(1).default_b, Names(1).made) == (1, 3, [])


def test_mutable_records_equal_themselves_only():
    @mutable_record()
    class Place:
        x: int
        seen: list[int] = field(default_factory=list)

    one, other = Place(1), Place(1)
    one.x = 1
    assert one != other and len({one, other}) == 2
    assert repr(one) == "Place(x=1, seen=[])" and replace(one, x=2).x == 2


def test_positional_patterns():
    match Base(1, 5):
        case Base(a, b):
            assert (a, b) == (1, 5)


def test_fields_are_known_before_the_first_object():
    @record()
    class Late(Base):
        d: float = 0.5

    assert [(f.name, f.default) for f in fields(Late)][1:] == [("b", 2), ("d", 0.5)]
    assert replace(Late(1), d=2.0) == Late(1, d=2.0)


def test_threads_may_make_the_first_objects(monkeypatch):
    """One thread completes the record while another one, which makes an object, has not finished that."""

    @record()
    class Shared:
        a: int

    initializer, others = lagdsl.foundation.record._initializer, []

    def interrupted(known, has_more):
        if not others:
            others.append(None)
            with ThreadPoolExecutor() as pool:
                others[0] = pool.submit(lambda: (Shared(2), Shared(2) == Shared(3), repr(Shared(4)))).result()
        return initializer(known, has_more)

    monkeypatch.setattr("lagdsl.foundation.record._initializer", interrupted)
    assert Shared(2) == others[0][0] and others[0][1:] == (False, "Shared(a=4)")


def test_what_follows_from_a_record_is_found_once_and_forgotten_with_it():
    @record(weak=True)
    class Subject:
        a: int

    found: list[int] = []

    @remembered
    def twice(subject: Subject) -> int:
        found.append(subject.a)
        return 2 * subject.a

    one, same = Subject(1), Subject(1)
    assert [twice(one), twice(one), twice(same), twice(replace(one, a=4))] == [2, 2, 2, 8]
    assert found == [1, 1, 4]
    for k in range(50):  # each lies where the one before it did
        assert twice(Subject(k)) == 2 * k
    assert pickle.loads(pickle.dumps(FlatSubject(3))) == FlatSubject(3)
    assert twice(copy.copy(same)) == 2


@record(weak=True)
class FlatSubject:
    a: int
