"""Parts of a run of one island: its part of the settings and of the start of the whole model."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.islands.classes import IslandClass, Member, island_classes
from lagdsl.derivation.program.islands.partition import Island
from lagdsl.derivation.program.program import Layout, Program
from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.engines.engine import Engine, EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_options import Measures, RunSettings
from lagdsl.engines.runtime.signal_tables import TabledInputs
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered
from lagdsl.motion.simulate.initialize import InitialState

Indices = NDArray[np.intp]


@record()
class Piece:
    """An island with the settings of its run but for the times of rows, and its start: the state x, the sizes of rows
    of constraints, and which of these depend on others. Pieces of one `kind` differ in names alone: they have one
    motion."""

    engine: Engine
    island: Island
    settings: RunSettings
    x: Floats
    row_sizes: Floats
    dependent: Sequence[bool]
    kind: tuple[object, ...]


def pieces_of(engine: Engine, run: Run, initial: InitialState) -> list[Piece]:
    """Of the motion that `run` would make from `initial`, in the order of the islands. Empty where everything moves
    together, or where functions of Python tell the inputs."""
    settings, program = run.settings, engine.program
    classes = island_classes(program)
    if not classes or not isinstance(settings.inputs, (np.ndarray, TabledInputs)):
        return []
    cut = _Cut(program.layout, settings, run, initial)
    engines = _engines(program)
    found: list[tuple[int, Piece]] = []
    for number, each in enumerate(classes):
        if (engine.name, number) not in engines:
            engines[engine.name, number] = engine_of(each.program, engine.name)
        found += cut.pieces(engines[engine.name, number], number, each)
    return [piece for _, piece in sorted(found, key=lambda each: each[0])]


@remembered
def _engines(program: Program) -> dict[tuple[EngineName, int], Engine]:
    """Engines of the classes of islands so far."""
    return {}


def _start(each: IslandClass, t: float) -> Start:
    """Attributes of a start that is found already: nobody reads them."""
    n = len(each.program.layout.coordinates)
    size = 2 * n + len(each.program.layout.states)
    zeros = (0.0,) * size
    none = (False,) * size
    return Start(t, zeros, none, (0,) * size, zeros, zeros[:n], zeros[:n])


class _Cut:
    """Cuts settings and start of a whole model, those of a class of islands together."""

    def __init__(self, layout: Layout, settings: RunSettings, run: Run, initial: InitialState) -> None:
        self._places, self._settings, self._p, self._initial = Places(layout), settings, run.p, initial
        self._row_sizes, self._dependent = run.row_sizes, np.array(initial.redundant, dtype=np.bool_)
        self._redundant = np.array(layout.redundant, dtype=np.bool_)

    def pieces(self, engine: Engine, number: int, islands: IslandClass) -> Iterator[tuple[int, Piece]]:
        """Islands of the class of this number, each behind the place of its first coordinate or state."""
        members = islands.members
        states = np.array([self._places.of_state(each.island) for each in members])
        rows = np.array([each.island.places["nc"] for each in members])
        measures = self._measures(states, rows, _start(islands, self._initial.t))
        x, row_sizes, dependent = self._initial.x[states], self._row_sizes[rows], self._dependent[rows]
        for k, member in enumerate(members):
            settings = self._of(member, measures[k])
            watched = b"" if settings.invariant_tolerance is None else settings.invariant_tolerance.tobytes()
            numbers = (settings.p, x[k], row_sizes[k], dependent[k])
            kind = (number, id(measures[k]), tuple(member.inputs), watched, *(each.tobytes() for each in numbers))
            piece = Piece(engine, member.island, settings, x[k], row_sizes[k], dependent[k].tolist(), kind)
            yield int(states[k, 0]), piece

    def _of(self, member: Member, measures: Measures) -> RunSettings:
        own, tolerance = self._settings, self._settings.invariant_tolerance
        return RunSettings(
            p=np.concatenate([self._p[list(member.parameters)], member.numbers]),
            inputs=self._inputs(list(member.inputs)),
            measures=measures,
            times=own.times,
            tolerance=own.tolerance,
            part=own.part,
            method=own.method,
            step=own.step,
            length=own.length,
            invariant_tolerance=None if tolerance is None else tolerance[member.island.places["ni"]],
        )

    def _inputs(self, places: list[int]) -> Floats | TabledInputs:
        inputs = self._settings.inputs
        if isinstance(inputs, TabledInputs):
            return TabledInputs(inputs.u[places], [inputs.tables[place] for place in places])
        assert isinstance(inputs, np.ndarray), "no function of Python tells them"
        return inputs[places]

    def _measures(self, states: Indices, rows: Indices, start: Start) -> list[Measures]:
        """Of islands with these states (k, n) and rows (k, m); one for all that have the same."""
        whole = self._settings.measures
        group, natural, cap = _ranked(whole.group[states]), whole.natural[states], whole.cap[states]
        lasting = whole.lasting[rows]
        general = np.sum((lasting != 0.0) & ~self._redundant[rows], axis=1)
        known: dict[bytes, Measures] = {}
        found = []
        for k, every in enumerate(np.hstack([group, natural, cap, lasting, general[:, None]])):
            key = every.tobytes()
            if key not in known:
                known[key] = Measures(
                    start=start,
                    group=_kept(group[k].copy()),
                    natural=_kept(natural[k].copy()),
                    cap=_kept(cap[k].copy()),
                    lasting=_kept(lasting[k].copy()),
                    general=int(general[k]),
                )
            found.append(known[key])
        return found


def _ranked(values: Floats) -> Floats:
    """The number (k, n) of each value among those of its row, the least first; equal ones have one number."""
    order = np.argsort(values, axis=1, kind="stable")
    ascending = np.take_along_axis(values, order, axis=1)
    numbers = np.zeros(values.shape)
    numbers[:, 1:] = np.cumsum(ascending[:, 1:] != ascending[:, :-1], axis=1)
    found = np.empty(values.shape)
    np.put_along_axis(found, order, numbers, axis=1)
    return found


def _kept(values: Floats) -> Floats:
    """Nobody can write to it."""
    values.flags.writeable = False
    return values


class Places:
    """Places of the numbers of islands in those of the whole model."""

    def __init__(self, layout: Layout) -> None:
        self._n = len(layout.coordinates)
        self.size = 2 * self._n + len(layout.states)
        self._variables = sum(kind == "variable" for kind in layout.kinds)
        self.width = self.size + self._variables + len(layout.outputs)

    def of_state(self, island: Island) -> Indices:
        """Of x = (q, qd, z) of the island in x of all."""
        q = island.places["nq"]
        return np.concatenate([q, self._n + q, 2 * self._n + island.places["nz"]])

    def of_columns(self, island: Island) -> Indices:
        """Of x, discrete variables and outputs of the island in those of all: a row but for time and checks."""
        own = island.places["nw"]
        variables = self.size + own[own < self._variables]
        return np.concatenate([self.of_state(island), variables, self.size + self._variables + island.places["ny"]])
