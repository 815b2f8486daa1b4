"""One number of an exported model, before numbers are put together into arrays."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Literal, TypeAlias

from lagdsl.exchange.fmi.variables.names import Name
from lagdsl.foundation.record import record


class Role(StrEnum):
    """lag_role of lag/fmu.h."""

    TIME = "TIME"
    PARAMETER = "PARAMETER"
    FREE = "FREE"
    CONSTANT = "CONSTANT"
    STATE = "STATE"
    DEPENDENT = "DEPENDENT"
    DERIVATIVE = "DERIVATIVE"
    INPUT = "INPUT"
    OUTPUT = "OUTPUT"
    LOCAL = "LOCAL"
    DISCRETE = "DISCRETE"
    MULTIPLIER = "MULTIPLIER"
    INDICATOR = "INDICATOR"
    ENERGY = "ENERGY"
    RESIDUAL = "RESIDUAL"
    OPTION = "OPTION"
    CLOCK = "CLOCK"


Type: TypeAlias = Literal["REAL", "INTEGER", "BOOLEAN", "STRING", "ENUMERATION", "CLOCK"]
Setting: TypeAlias = Literal["NEVER", "START", "TUNABLE", "ALWAYS"]
Causality: TypeAlias = Literal["independent", "parameter", "calculatedParameter", "input", "output", "local"]
Variability: TypeAlias = Literal["constant", "fixed", "tunable", "discrete", "continuous"]
Initial: TypeAlias = Literal["exact", "approx", "calculated"]


@record(kw_only=True)
class Attributes:
    """Fields that the entries of one array share. `unit` is a coherent SI unit, `literals` are those of an
    enumeration, `literal_docs` their texts, `type_doc` is that of the type. `interval`: period and shift
    of a clock [s], where no parameter changes them."""

    role: Role
    type: Type = "REAL"
    causality: Causality = "local"
    variability: Variability = "continuous"
    setting: Setting = "NEVER"
    unit: str | None = None
    display_unit: str | None = None
    minimum: float | None = None
    maximum: float | None = None
    nominal: float | None = None
    doc: str | None = None
    type_name: str | None = None
    literals: tuple[str, ...] = ()
    literal_docs: tuple[str | None, ...] = ()
    interval: tuple[float, float] | None = None
    type_doc: str | None = None


@record()
class Other:
    """Another name of a variable and what it stands for there. `protected`: the model does not show it."""

    name: Name
    doc: str | None = None
    protected: bool = False


@record(kw_only=True)
class Scalar:
    """`first` is its index in the array of its role. `key` is the same for numbers that may be one array: for states
    and their derivatives it is that of the coordinate, so that their arrays have the same shapes."""

    name: Name
    first: int
    attributes: Attributes
    initial: Initial | None
    start: float | str | None = None
    key: object = None
    reinit: bool = False  # events may change the state
    derivative_of: int | None = None  # index of the state whose time derivative it is
    protected: bool = False  # the model does not show it
    others: tuple[Other, ...] = ()


@record(kw_only=True)
class Variable:
    """One variable of an FMU; its value reference is its index. `starts` in row-major order of `shape`, which is empty
    for a scalar. `derivative_of`: index of the variable of whose states it is the time derivative. `others`: names
    under which it is known, too, with their texts."""

    name: str
    first: int
    shape: tuple[int, ...]
    attributes: Attributes
    initial: Initial | None
    starts: tuple[float | str, ...]
    reinit: bool = False
    derivative_of: int | None = None
    others: tuple[tuple[str, str | None], ...] = ()

    @property
    def count(self) -> int:
        size = 1
        for extent in self.shape:
            size *= extent
        return size

    @property
    def entries(self) -> Iterator[int]:
        """Indices in the array of its role."""
        return iter(range(self.first, self.first + self.count))
