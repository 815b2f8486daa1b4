"""The functions of one state as words, for all tapes of a program.

They are written once. A tape with further functions has more constants, and more that follows from parameters, at the
beginning of the row: what the words say of places is moved, as linkers do.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import blake2b
from typing import Final

import numpy as np

from lagdsl.derivation.program import functions as known
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.tape.function import NO_CODE, Code, Result, preparation, results_of, words_of
from lagdsl.engines.backends.tape.nodes import Ints, Nodes, distinct, live_sets
from lagdsl.engines.backends.tape.settled import Settled, settle
from lagdsl.foundation.record import record

# Functions by number, as lag_function counts them.
FUNCTIONS: Final = tuple(function.name for function in known.FUNCTIONS if function.single)


@record()
class Base:
    """Beginning of the row, `constants` and what is settled, and the codes of prepare() and of the functions of one
    state: one object for equal functions."""

    constants: list[float]
    settled: Settled
    codes: list[Code]


@record()
class OneState:
    """The functions of one state `alone`. They need the nodes `live`, `roots` among them as results."""

    parameters: int
    live: Ints
    roots: Ints
    alone: Base


def one_state(program: Program, nodes: Nodes) -> OneState:
    """The functions of one state of `program`."""
    count, parameters = len(nodes.op), len(program.layout.parameters)
    every = [results_of(program.function(name).results) if program.has(name) else [] for name in FUNCTIONS]
    roots = [distinct(count, *(result.roots for result in own)) for own in every]
    lives = live_sets(nodes, roots)
    settled, constants, hoisted = settle(nodes, parameters, lives, roots)
    codes = [_prepare(nodes, hoisted, settled, parameters)]
    made: dict[tuple[tuple[int, bytes], ...], Code] = {}  # without constraints two functions are one
    for name, live, own in zip(FUNCTIONS, lives, every, strict=True):
        key = tuple((number, _key(result)) for number, result in enumerate(own) if result.count)
        if program.has(name) and key not in made:
            made[key] = words_of(nodes, live, own, settled)
        codes.append(made[key] if program.has(name) else NO_CODE)
    return OneState(parameters, distinct(count, *lives), distinct(count, *roots), Base(constants, settled, codes))


def beside(state: OneState, nodes: Nodes, lives: Sequence[Ints], roots: Sequence[Ints]) -> Base:
    """The same beside functions that are computed from the nodes of `lives`, with these `roots`; the graph may have
    grown."""
    if not lives:
        return state.alone
    before = state.alone.settled
    settled, constants, hoisted = settle(nodes, state.parameters, [state.live, *lives], [state.roots, *roots])
    there = np.flatnonzero(before.place >= 0)
    places = np.arange(before.first)
    places[before.place[there]] = settled.place[there]
    further = settled.first - before.first
    codes = state.alone.codes[1:]
    moved = {id(code): code.moved(places, further) for code in codes if code is not NO_CODE}
    first = _prepare(nodes, hoisted, settled, state.parameters)
    return Base(constants, settled, [first, *(moved.get(id(code), code) for code in codes)])


def _prepare(nodes: Nodes, hoisted: Ints, settled: Settled, parameters: int) -> Code:
    live = np.array(nodes.graph.live(hoisted.tolist()), dtype=np.int64)
    return preparation(nodes, live, hoisted, settled, parameters)


def _key(result: Result) -> bytes:
    """Equal for equal results."""
    return blake2b(np.concatenate([[result.count], result.places, result.nodes]).tobytes()).digest()
