"""Vectors by the names of their entries: `{"tau": [1.0, 2.0]}` stands for entries `tau[1]`, `tau[2]`."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
_FLOAT = np.dtype(np.float64)
_SUBSCRIPTS = re.compile(r"\[([^\[\]]*)\]")


def real_numbers(name: str, value: ArrayLike) -> Floats:
    """An array of floats. Raises ValueError for what is none, complex numbers included: NumPy would drop the imaginary
    parts."""
    if value.__class__ is np.ndarray and value.dtype is _FLOAT:
        return value
    try:
        if value is None:
            raise TypeError("there is nothing")
        given = np.asarray(value)
        if np.iscomplexobj(given):
            raise TypeError("these are complex")
        return np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be made of real numbers in SI units: {error}") from error


def with_entries(
    what: str, names: Sequence[str], given: Mapping[str, ArrayLike], others: ArrayLike | None = None
) -> Floats:
    """(..., n): the values of `given` by name, those of an array along its last axes; what is left out from `others`.

    Raises ValueError for a name that is none of `names`, one that is given twice or left out where there are no
    `others`, and for a number of elements that does not fit.
    """
    found: dict[int, Floats] = {}
    for name, value in given.items():
        places = _places(what, names, name)
        array = real_numbers(name, value)
        single = _elements(name, array, places, names) if names[places[0]] != name else [array]
        for place, element in zip(places, single, strict=True):
            if place in found:
                raise ValueError(f"{what}: `{names[place]}` is given twice")
            found[place] = element
    if others is None and len(found) < len(names):
        missing = [name for place, name in enumerate(names) if place not in found]
        raise ValueError(f"{what}: there is no value for {', '.join(missing)}")
    rest = np.zeros(len(names)) if others is None else real_numbers(what, others)
    columns = [found[place] if place in found else rest[..., place] for place in range(len(names))]
    return np.stack(np.broadcast_arrays(*columns), axis=-1) if columns else np.zeros(0)


def own_entries(aliases: Mapping[str, str], given: Mapping[str, Any]) -> dict[str, Any]:
    """`given` by the names of entries, in place of other names of them or of arrays of them. Raises ValueError where
    two names are those of one entry."""
    found: dict[str, Any] = {}
    for name, value in given.items():
        bases = {_base(own) for other, own in aliases.items() if _base(other) == name}
        own = aliases.get(name, bases.pop() if len(bases) == 1 else name)
        if own in found:
            raise ValueError(f"`{own}` is given twice, once as `{name}`")
        found[own] = value
    return found


def arrays_of(names: Sequence[str], values: Floats) -> dict[str, Floats]:
    """The entries of `values` (..., n) by name, elements of an array together along its own axes."""
    found: dict[str, Floats] = {}
    for base in dict.fromkeys(map(_base, names)):
        places = _places("the vector", names, base)
        shape = _shape(names, places) if names[places[0]] != base else ()
        chosen = values[..., places]
        found[base] = chosen.reshape((*values.shape[:-1], *shape)) if shape else chosen[..., 0]
    return found


def _base(name: str) -> str:
    return _SUBSCRIPTS.sub("", name)


def _places(what: str, names: Sequence[str], name: str) -> list[int]:
    """Indices of the entries that `name` stands for."""
    places = [place for place, each in enumerate(names) if each == name]
    places = places or [place for place, each in enumerate(names) if _base(each) == name]
    if not places:
        raise ValueError(f"{what} has no entry `{name}`; there are {', '.join(names) or 'none'}")
    return places


def _shape(names: Sequence[str], places: Sequence[int]) -> tuple[int, ...]:
    """Lengths of the axes of an array, by the last of its subscripts; one axis where they do not tell."""
    subscripts = [",".join(_SUBSCRIPTS.findall(names[place])).split(",") for place in places]
    last = [int(each) if each.isdigit() else 0 for each in subscripts[-1]]
    return tuple(last) if int(np.prod(last)) == len(places) else (len(places),)


def _elements(name: str, array: Floats, places: Sequence[int], names: Sequence[str]) -> list[Floats]:
    shape = _shape(names, places)
    if array.shape[-len(shape) :] != shape:
        lengths = " by ".join(map(str, shape))
        raise ValueError(f"`{name}` has {lengths} elements along its last axes, the shape given is {array.shape}")
    flat = array.reshape((*array.shape[: array.ndim - len(shape)], len(places)))
    return [flat[..., k] for k in range(len(places))]
