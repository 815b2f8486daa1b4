"""Immutable records: dataclasses that are made ten times as fast, for a command that checks ten lines imports hundreds.

`dataclass(frozen=True)` compiles six functions for every class, a quarter of the start-up time of `lag check` once. A
record is completed as a dataclass when its first object is made, and compiles `__init__` alone; comparison, hash and
text are shared functions over the fields, unless the class has its own. That a record is never changed is checked by
mypy, not at run time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, TypeVar, dataclass_transform

_Class = TypeVar("_Class", bound=type)


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(*, kw_only: bool = False) -> Callable[[_Class], _Class]:
    """Make the decorated class a record; `kw_only` as for dataclasses. Inherited fields come first."""

    def decorate(cls: _Class) -> _Class:
        return _with_slots(cls, kw_only)  # type: ignore[no-any-return]

    return decorate


def _with_slots(cls: Any, kw_only: bool) -> Any:
    """The class anew, with slots; what belongs to a dataclass besides comes with its first object."""
    names = cls.__annotations__
    taken = {slot for base in cls.__mro__[1:] for slot in base.__dict__.get("__slots__", ())}
    own = tuple(name for name in names if name not in taken)
    members = {k: v for k, v in cls.__dict__.items() if k not in names and k not in ("__dict__", "__weakref__")}

    def first_init(self: Any, *arguments: Any, **named: Any) -> None:
        _complete(made)
        made.__init__(self, *arguments, **named)

    members |= {"__slots__": own, "__qualname__": cls.__qualname__, "__planned__": (cls, kw_only)}
    members |= {"__init__": first_init, "__setstate__": _restore}
    shared = {"__eq__": _equal, "__hash__": _hash, "__repr__": _text}
    made = type(cls)(cls.__name__, cls.__bases__, shared | members)
    if not names and not taken:  # no object of it has a state that would be restored
        _complete(made)
    return made


def _complete(made: Any) -> None:
    """Make a dataclass of a record, after those that it inherits from."""
    for base in reversed(made.__mro__):
        if base.__dict__.get("__planned__") is None:
            continue
        plain, kw_only = base.__planned__
        plain.__doc__ = plain.__doc__ or plain.__name__  # else dataclass() inspects the signature to write one
        whole: Any = dataclass(kw_only=kw_only, eq=False, repr=False)(plain)
        for name in ("__init__", "__dataclass_fields__", "__dataclass_params__", "__match_args__"):
            setattr(base, name, whole.__dict__[name])
        fields = whole.__dataclass_fields__.values()
        base.__compared__ = tuple(f.name for f in fields if f.compare)
        base.__shown__ = tuple(f.name for f in fields if f.repr)
        base.__planned__ = None


def _restore(self: Any, state: Any) -> None:
    """What copying and unpickling call in place of `__init__`."""
    _complete(type(self))
    for name, value in state[1].items():
        setattr(self, name, value)


def _equal(self: Any, other: Any) -> Any:
    if self is other:
        return True
    if type(other) is not type(self):
        return NotImplemented
    return all(getattr(self, name) == getattr(other, name) for name in self.__compared__)


def _hash(self: Any) -> int:
    return hash((type(self), *(getattr(self, name) for name in self.__compared__)))


def _text(self: Any) -> str:
    shown = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__shown__)
    return f"{type(self).__name__}({shown})"
