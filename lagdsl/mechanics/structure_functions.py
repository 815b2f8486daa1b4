"""The functions of a program by the meaning of its graph: what `lag check` evaluates before there is an engine."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from lagdsl.graph.tape import Tape
from lagdsl.mechanics.rank import Floats
from lagdsl.program.lanes import OMITTED, Lanes
from lagdsl.program.program import Layout, Program


@dataclass(frozen=True, slots=True)
class ProgramFunctions:
    """`evaluate` as an engine has it, for one state at a time."""

    program: Program
    _tapes: dict[str, Tape] = field(default_factory=dict, compare=False, repr=False)
    _written: list[Lanes] = field(default_factory=list, compare=False, repr=False)

    @property
    def layout(self) -> Layout:
        return self.program.layout

    def _lanes(self) -> Lanes:
        if not self._written:
            self._written.append(Lanes(self.program))
        return self._written[0]

    def restricted(self, rows: list[int]) -> ProgramFunctions:
        """The same with all other rows of the position constraints, and of J there, zero."""
        program, kept = self.program, set(rows)
        zero = program.graph.zero
        definition = program.function("position_constraint")
        count = max(len(program.layout.constraints), 1)
        blocks = []
        for block in definition.results:
            width = len(block.elements) // count
            elements = tuple(
                node if index // max(width, 1) in kept else zero for index, node in enumerate(block.elements)
            )
            blocks.append(replace(block, elements=elements))
        changed = replace(definition, results=tuple(blocks))
        functions = tuple(changed if f is definition else f for f in program.functions)
        return ProgramFunctions(replace(program, functions=functions))

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        """Result blocks of `function`; what is not a number comes out as nan or inf."""
        if function in OMITTED and all(f.name != function for f in self.program.functions):
            return self._lanes().evaluate(function, *arguments)
        definition = self.program.function(function)
        tape = self._tapes.get(function)
        if tape is None:
            roots = [node for block in definition.results for node in block.elements]
            tape = self._tapes[function] = Tape(self.program.graph, roots)
        values = tape(
            {
                group: argument.tolist() if isinstance(argument, np.ndarray) else float(argument)
                for group, argument in zip(definition.arguments, arguments, strict=True)
            }
        )
        blocks, first = [], 0
        for block in definition.results:
            blocks.append(values[first : first + len(block.elements)].reshape(block.shape))
            first += len(block.elements)
        return tuple(blocks)
