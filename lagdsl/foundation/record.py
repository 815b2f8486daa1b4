"""Immutable records: dataclasses that are made ten times as fast, for a command that checks ten lines imports hundreds.

`dataclass(frozen=True)` compiles six functions for every class, a quarter of the start-up time of `lag check` once. A
record is completed when its first object is made, and compiles `__init__` alone; comparison, hash and text are shared
functions over the fields, unless the class has its own. The attributes that `dataclasses.fields` and `replace` read are
made at their first call. That a record is never changed is checked by mypy, not at run time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, field
from functools import wraps
from operator import attrgetter
from typing import Any, NamedTuple, TypeVar, dataclass_transform
from weakref import ref

_Class = TypeVar("_Class", bound=type)
_Subject = TypeVar("_Subject")
_Found = TypeVar("_Found")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(*, kw_only: bool = False, weak: bool = False) -> Callable[[_Class], _Class]:
    """Make the decorated class a record; `kw_only` as for dataclasses. Inherited fields come first. Of a `weak` one can
    be `remembered` what follows from it."""

    def decorate(cls: _Class) -> _Class:
        return _with_slots(cls, kw_only, weak=weak)  # type: ignore[no-any-return]

    return decorate


@dataclass_transform(eq_default=False, field_specifiers=(field,))
def mutable_record() -> Callable[[_Class], _Class]:
    """Make the decorated class a record whose fields change; an object equals itself only."""

    def decorate(cls: _Class) -> _Class:
        return _with_slots(cls, False, by_value=False)  # type: ignore[no-any-return]

    return decorate


def remembered(function: Callable[[_Subject], _Found]) -> Callable[[_Subject], _Found]:
    """`function` of a weak record, called once for each object; what it found is kept as long as the object lives, to
    which it must not refer. Nobody may change it."""
    known: dict[int, tuple[ref[_Subject], _Found]] = {}

    @wraps(function)
    def found(subject: _Subject) -> _Found:
        key = id(subject)
        if key not in known:
            value = function(subject)
            known[key] = ref(subject, lambda _: known.pop(key, None)), value
            return value
        return known[key][1]

    return found


def _with_slots(cls: Any, kw_only: bool, by_value: bool = True, weak: bool = False) -> Any:
    """The class anew, with slots; what belongs to a dataclass besides comes with its first object."""
    names = cls.__annotations__
    taken = {slot for base in cls.__mro__[1:] for slot in base.__dict__.get("__slots__", ())}
    own = tuple(name for name in names if name not in taken)
    members = {k: v for k, v in cls.__dict__.items() if k not in names and k not in ("__dict__", "__weakref__")}

    def first_init(self: Any, *arguments: Any, **named: Any) -> None:
        _complete(made)
        made.__init__(self, *arguments, **named)

    members |= {
        "__slots__": (*own, "__weakref__") if weak else own,
        "__qualname__": cls.__qualname__,
        "__declared__": (cls, kw_only),
    }
    members |= {"__init__": first_init, "__setstate__": _restore}
    shared: dict[str, object] = {"__repr__": _text, "__dataclass_fields__": _Later()}
    shared |= {"__eq__": _equal, "__hash__": _hash} if by_value else {}
    made = type(cls)(cls.__name__, cls.__bases__, shared | members)
    if not names and not taken:  # no object of it has a state that would be restored
        _complete(made)
    return made


class _Field(NamedTuple):
    """A field as `dataclasses.field` describes it; MISSING where there is no `default`, no `factory` of defaults."""

    default: Any
    factory: Any
    init: bool
    kw_only: bool
    compare: bool
    repr: bool


def _complete(made: Any) -> None:
    """Give a record, and those that it inherits from, what every object needs."""
    for base in reversed(made.__mro__):
        if "__declared__" not in base.__dict__ or "__arguments__" in base.__dict__:
            continue
        plain, kw_only = base.__declared__
        known: dict[str, _Field] = {}
        for inherited in reversed(base.__mro__[1:]):
            known |= inherited.__dict__.get("__arguments__", {})
        known |= {name: _field(plain.__dict__.get(name, MISSING), kw_only) for name in plain.__annotations__}
        positional = tuple(name for name, one in known.items() if one.init and not one.kw_only)
        setattr(base, "__match_args__", positional)  # noqa: B010 mypy wants a literal
        base.__compared__ = _reader(tuple(name for name, one in known.items() if one.compare))
        base.__shown__ = tuple(name for name, one in known.items() if one.repr)
        # A record that several threads make first is completed by each: whoever finds `__init__` or the mark finds all.
        base.__init__ = _initializer(known, hasattr(plain, "__post_init__"))
        base.__arguments__ = known


def _reader(names: tuple[str, ...]) -> Any:
    """The function that gives the values of these fields; one that stands in a class without becoming a method."""
    return attrgetter(*names) if names else type


def _field(given: Any, kw_only: bool) -> _Field:
    if not isinstance(given, Field):
        return _Field(given, MISSING, True, kw_only, True, True)
    own = kw_only if given.kw_only is MISSING else given.kw_only
    return _Field(given.default, given.default_factory, given.init, own, given.compare, given.repr)


def _initializer(known: dict[str, _Field], has_more: bool) -> Any:
    """`__init__` that takes the fields in their order, those for keywords last; `has_more` to do in `__post_init__`."""
    positional = [_argument(name, one) for name, one in known.items() if one.init and not one.kw_only]
    named = [_argument(name, one) for name, one in known.items() if one.init and one.kw_only]
    head = ", ".join(["self", *positional, *(["*"] if named else []), *named])
    body = [_assignment(name, one) for name, one in known.items() if one.init or one.factory is not MISSING]
    body += ["self.__post_init__()"] if has_more else []
    values = {"__missing": MISSING} | {f"__default_{name}": one.default for name, one in known.items()}
    values |= {f"__make_{name}": one.factory for name, one in known.items()}
    exec(f"def __init__({head}):\n " + "\n ".join(body or ["pass"]), values)
    return values["__init__"]


def _argument(name: str, one: _Field) -> str:
    if one.factory is not MISSING:
        return f"{name}=__missing"
    return name if one.default is MISSING else f"{name}=__default_{name}"


def _assignment(name: str, one: _Field) -> str:
    if not one.init:
        return f"self.{name} = __make_{name}()"
    return f"self.{name} = {name}" + (
        f" if {name} is not __missing else __make_{name}()" if one.factory is not MISSING else ""
    )


class _Later:
    """`__dataclass_fields__` of a record, which takes its place when it is first asked for."""

    def __get__(self, made: Any, of: Any) -> Any:
        base = next(base for base in of.__mro__ if "__dataclass_fields__" in base.__dict__)
        plain, kw_only = base.__declared__
        whole = dataclass(init=False, kw_only=kw_only, eq=False, repr=False)(plain)
        base.__dataclass_params__ = whole.__dict__["__dataclass_params__"]
        base.__dataclass_fields__ = whole.__dict__["__dataclass_fields__"]
        return base.__dataclass_fields__


def _restore(self: Any, state: Any) -> None:
    """Constructor for copying and unpickling, in place of `__init__`."""
    _complete(type(self))
    for name, value in state[1].items():
        setattr(self, name, value)


def _equal(self: Any, other: Any) -> Any:
    if self is other:
        return True
    if type(other) is not type(self):
        return NotImplemented
    return self.__compared__(self) == self.__compared__(other)


def _hash(self: Any) -> int:
    return hash((type(self), self.__compared__(self)))


def _text(self: Any) -> str:
    shown = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__shown__)
    return f"{type(self).__name__}({shown})"
