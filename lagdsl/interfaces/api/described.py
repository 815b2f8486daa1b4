"""The part of a model that names things: entries of its vectors in order, defaults, diagnostics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.backends.python.support.interface import Interface
from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.interfaces.api.names import Given, Value, entries, known, numbers
from lagdsl.language.flat.admissible import require_value
from lagdsl.language.settings.aliases import by_own_names
from lagdsl.language.settings.target import Kind, Target, targets

if TYPE_CHECKING:
    from lagdsl.derivation.program.program import Slot
    from lagdsl.derivation.textbook.equations import EquationsOfMotion
    from lagdsl.motion.pipeline import Compilation

Floats = NDArray[np.float64]
_WORDS = {"p": "parameter", "u": "input", "q": "coordinate", "z": "state", "qd": "coordinate"}


class Described(Interface):
    """Functions of a model with the names of their entries. `functions` are the arguments of Interface."""

    def __init__(self, compilation: Compilation, *functions: Any) -> None:
        super().__init__(*functions)
        self._compilation = compilation
        self._layout = compilation.program.layout
        self._aliases = dict(self._layout.aliases)
        self._row_factors = np.array(self._layout.row_factors or (1.0,))
        self._known_targets: dict[tuple[Kind, ...], dict[str, Target]] = {}

    def __repr__(self) -> str:
        return f"<Model {self.name}: {', '.join(self.coordinates + self.states)}>"

    @property
    def name(self) -> str:
        """Name of the model."""
        return self._compilation.flat.name

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings and notes of the compilation."""
        return self._compilation.diagnostics

    @cached_property
    def equations(self) -> EquationsOfMotion:
        """The equations of motion in symbols (SymPy), by the textbook's route, in the form that `derive` prints.

        `parameters` holds the values of the symbols. Zeros of library components are numbers there.
        """
        from lagdsl.derivation.textbook.simplified import simplified

        return simplified(self._compilation.flat)

    @property
    def coordinates(self) -> list[str]:
        """Names of the entries of `q` and `qd`."""
        return _names(self._layout.coordinates)

    @property
    def states(self) -> list[str]:
        """Names of the entries of `z`."""
        return _names(self._layout.states)

    @property
    def parameters(self) -> list[str]:
        """Names of the entries of `p`, the independent parameters; those defined by others follow them."""
        return _names(self._layout.parameters)

    @property
    def inputs(self) -> list[str]:
        """Names of the entries of `u`."""
        return _names(self._layout.inputs)

    @property
    def discretes(self) -> list[str]:
        """The entries of `w`: discrete variables, `closed(c)` and `impacts(c)` of contacts, relations as written, and
        what else clauses remember. Truths are 0 and 1."""
        return _names(self._layout.discretes)

    @property
    def outputs(self) -> list[str]:
        """Names of the entries of the outputs."""
        return _names(self._layout.outputs)

    @property
    def constraints(self) -> list[str]:
        """Names of all declared constraint rows, in source order: `wire`, `pin[1]`."""
        return _names(self._layout.constraints)

    @property
    def redundant(self) -> list[bool]:
        """True for rows that depend on others; multipliers are then those of minimum norm."""
        return list(self._layout.redundant)

    @property
    def defaults(self) -> Floats:
        """Values of the independent parameters, shape (np,)."""
        return self._default_values.copy()

    @cached_property
    def _default_values(self) -> Floats:
        return np.array(self._layout.defaults, dtype=np.float64)

    def _parameter_vector(self, given: Given) -> Floats:
        """The defaults with some replaced by name, or all. Raises UnknownName and ValueError for what does not fit."""
        if given is None:
            return self._default_values.copy()
        values = dict(zip(self.parameters, self._layout.defaults, strict=True))
        chosen = entries("parameter" if isinstance(given, Mapping) else "p", given, self._named("parameter"))
        for parameter in self._compilation.flat.parameters:
            if parameter.name in chosen:
                require_value(parameter, chosen[parameter.name])
        return np.array(list({**values, **chosen}.values()), dtype=np.float64)

    def _numbers(self, name: str, given: Mapping[str, Any]) -> Mapping[str, Any]:
        """Values by name in SI units, where texts such as `2 N` are among them. Raises UnknownName."""
        targets = self._targets_of(name)
        return given if targets is None else numbers(_WORDS[name], given, targets)

    def _targets_of(self, name: str) -> dict[str, Target] | None:
        """By the names of entries of an argument; None for those that take numbers only."""
        match name:
            case "p":
                return self._named("parameter")
            case "u":
                return self._named("input")
            case "q" | "z":
                starts = self._named("start")
                return {each: starts[each] for each in self._names[name]}
            case "qd":
                starts = self._named("start")
                return {each: starts[f"der({each})"] for each in self._names[name]}
            case _:
                return None

    def _start_values(self, given: Mapping[str, Value] | None) -> dict[str, float]:
        if not given:
            return {}
        return known("start value", by_own_names(self._compilation.flat, given), self._named("start"))

    def _named(self, *kinds: Kind) -> dict[str, Target]:
        """Targets of values, by the names of the model."""
        if kinds not in self._known_targets:
            found = targets(self._compilation.flat, kinds).values()
            self._known_targets[kinds] = {target.key: target for target in found}
        return self._known_targets[kinds]


def _names(slots: Sequence[Slot]) -> list[str]:
    return [slot.name for slot in slots]
