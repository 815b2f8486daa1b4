"""Inputs that are given between steps: numbers, vectors and values by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import isfinite
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.foundation.diagnostics import Sink, failed, refused
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.inputs import is_allowed

# All inputs that a step can set, in the order of the model, a number where there is one, or some of them by name:
# numbers in SI units or texts such as `2 N`.
Command: TypeAlias = "float | Sequence[float] | ArrayLike | Mapping[str, float | str | ArrayLike]"


class Commands:
    """Puts what a caller gives into the held inputs of a run. Inputs that `follow` time are not to be given, nor those
    of which the model needs the derivative, but for `speeds`; `read` makes a number of the value of an input."""

    def __init__(
        self,
        flat: FlatModel,
        follow: Sequence[bool],
        speeds: Sequence[bool],
        read: Callable[[str, object], float],
    ) -> None:
        self._flat, self._read = flat, read
        self._names = [item.name for item in flat.inputs]
        self._places = {name: place for place, name in enumerate(self._names)}
        self._why = [_why_not(self._names, k, follow[k], k < len(speeds) and speeds[k]) for k in range(len(follow))]
        self._open = [k for k, why in enumerate(self._why) if why is None]
        limited = [i.base != "Real" or i.minimum is not None or i.maximum is not None for i in flat.inputs]
        self._limited = [k for k, flag in enumerate(limited) if flag]
        self._warned: set[int] = set()
        self._plain = not self._limited and len(self._open) == len(self._names)

    def put(self, given: Any, u: Floats, sink: Sink) -> None:
        """`given` of one run into u (nu,). Raises CallRefused (E0893), UnknownName, and CompilationFailed for what an
        Integer, a Boolean or an enumeration cannot be; warnings go to `sink`."""
        if self._plain and type(given) is dict and given.keys() <= self._places.keys() and _are_plain(given.values()):
            for name, value in given.items():
                u[self._places[name]] = value
            return
        if self._plain and self._is_plain(given):
            u[:] = given
            return
        values = u.copy()
        for place, value in self._entries(given, ()):
            values[place] = value
        self._check(values, sink)
        u[:] = values

    def _is_plain(self, given: Any) -> bool:
        """True for finite numbers of all inputs, as most callers give them: nothing else is to be looked at."""
        kind = type(given)
        if kind is float:
            return len(self._names) == 1 and isfinite(given)
        if kind is list or kind is tuple:
            return len(given) == len(self._names) and _are_plain(given)
        plain = kind is np.ndarray and given.dtype == np.float64 and given.shape == (len(self._names),)
        return plain and isfinite(given.sum())

    def put_many(self, given: Any, u: Floats, sink: Sink) -> None:
        """`given` of many runs into u (runs, nu): values, and for every input a number or (runs,)."""
        values = u.copy()
        for place, value in self._entries(given, (len(u),)):
            values[:, place] = value
        self._check(values, sink)
        u[:] = values

    def _entries(self, given: Any, lead: tuple[int, ...]) -> list[tuple[int, Any]]:
        """Places with their values."""
        if isinstance(given, Mapping):
            return [self._entry(name, value, lead) for name, value in given.items()]
        try:
            vector = np.asarray(given, dtype=np.float64)
        except (TypeError, ValueError):
            raise self._unfit(f"{str(given)[:40]!r} is no vector of numbers") from None
        count = len(self._open)
        if count == 1 and vector.shape in ((), lead):
            vector = vector[..., None]
        if vector.shape not in ((count,), (*lead, count)):
            raise self._unfit(f"there are {count} inputs to set, and the values have the shape {vector.shape}")
        return [(k, vector[..., place]) for place, k in enumerate(self._open)]

    def _entry(self, name: str, value: Any, lead: tuple[int, ...]) -> tuple[int, Any]:
        if name not in self._places:
            raise unknown_among("input", name, self._names)
        place = self._places[name]
        why = self._why[place]
        if why is not None:
            raise self._unfit(why)
        if np.ndim(value) == 0:
            return place, self._read(name, value)
        array = np.array([self._read(name, each) for each in np.asarray(value, dtype=object).ravel().tolist()])
        if np.shape(value) != lead:
            raise self._unfit(f"`{name}` has values of the shape {np.shape(value)}")
        return place, array

    def _check(self, values: Floats, sink: Sink) -> None:
        """Refuses values that are no numbers, or that inputs cannot have."""
        if not np.isfinite(values).all():
            column = int(np.flatnonzero(~np.isfinite(values).reshape(-1, values.shape[-1]).all(axis=0))[0])
            raise self._unfit(f"`{self._names[column]}` must be a finite number")
        own = Sink()
        for k in (each for each in self._limited if each not in self._warned):
            count = len(own.diagnostics)
            if is_allowed(self._flat.inputs[k], np.atleast_1d(values[..., k]), None, own):
                self._warned |= {k} if len(own.diagnostics) > count else set()
        for diagnostic in own.diagnostics:
            sink.add(diagnostic)
        if own.has_errors:
            raise failed(own.diagnostics)

    def _unfit(self, why: str) -> Exception:
        names = ", ".join(f"`{self._names[k]}`" for k in self._open)
        way = f"give all that steps set, in this order, or some by name: {names or 'there are none'}"
        return refused("E0893", why=why, way=way)


def _are_plain(given: Iterable[Any]) -> bool:
    return all(type(each) is float and isfinite(each) for each in given)


def _why_not(names: Sequence[str], k: int, follows: bool, speed: bool) -> str | None:
    """The reason why an input is not set between steps; None where it can be."""
    name = names[k]
    if follows:
        return f"`{name}` follows time, as its signal in `inputs` says"
    if name.startswith("der("):
        return f"`{name}` is the derivative of an input, which only a signal in `inputs` gives"
    if f"der({name})" in names and not speed:
        return f"`{name}` may not jump, as the model needs its derivative: give a signal in `inputs`"
    return None
