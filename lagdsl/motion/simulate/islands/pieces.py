"""Parts of a run of one island: its part of the settings and of the start of the whole model."""

from __future__ import annotations

from collections.abc import Sequence

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
    of constraints, and which of these depend on others."""

    engine: Engine
    island: Island
    settings: RunSettings
    x: Floats
    row_sizes: Floats
    dependent: Sequence[bool]


def pieces_of(engine: Engine, run: Run, initial: InitialState) -> list[Piece]:
    """Of the motion that `run` would make from `initial`, in the order of the islands. Empty where everything moves
    together, or where functions of Python tell the inputs."""
    settings, program = run.settings, engine.program
    classes = island_classes(program)
    if not classes or not isinstance(settings.inputs, (np.ndarray, TabledInputs)):
        return []
    cut = _Cut(program.layout, settings, run, initial)
    engines, places = _engines(program), Places(program.layout)
    found: list[Piece] = []
    for number, each in enumerate(classes):
        if (engine.name, number) not in engines:
            engines[engine.name, number] = engine_of(each.program, engine.name)
        own, start = engines[engine.name, number], _start(each, initial.t)
        found += [cut.piece(own, member, start) for member in each.members]
    return sorted(found, key=lambda piece: int(places.of_state(piece.island)[0]))


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
    """Cuts settings and start of a whole model."""

    def __init__(self, layout: Layout, settings: RunSettings, run: Run, initial: InitialState) -> None:
        self._places, self._settings, self._p, self._initial = Places(layout), settings, run.p, initial
        self._row_sizes, self._dependent = run.row_sizes, np.array(initial.redundant, dtype=np.bool_)
        self._redundant = np.array(layout.redundant, dtype=np.bool_)

    def piece(self, engine: Engine, member: Member, start: Start) -> Piece:
        own, rows = self._settings, member.island.places["nc"]
        tolerance = own.invariant_tolerance
        settings = RunSettings(
            p=np.concatenate([self._p[list(member.parameters)], member.numbers]),
            inputs=self._inputs(list(member.inputs)),
            measures=self._measures(member.island, start),
            times=own.times,
            tolerance=own.tolerance,
            part=own.part,
            method=own.method,
            step=own.step,
            length=own.length,
            invariant_tolerance=None if tolerance is None else tolerance[member.island.places["ni"]],
        )
        x = self._initial.x[self._places.of_state(member.island)]
        return Piece(engine, member.island, settings, x, self._row_sizes[rows], self._dependent[rows].tolist())

    def _inputs(self, places: list[int]) -> Floats | TabledInputs:
        inputs = self._settings.inputs
        if isinstance(inputs, TabledInputs):
            return TabledInputs(inputs.u[places], [inputs.tables[place] for place in places])
        assert isinstance(inputs, np.ndarray), "no function of Python tells them"
        return inputs[places]

    def _measures(self, island: Island, start: Start) -> Measures:
        whole, rows = self._settings.measures, island.places["nc"]
        places = self._places.of_state(island)
        _, group = np.unique(whole.group[places], return_inverse=True)
        return Measures(
            start=start,
            group=_kept(group.astype(np.float64)),
            natural=_kept(whole.natural[places]),
            cap=_kept(whole.cap[places]),
            lasting=_kept(whole.lasting[rows]),
            general=int(np.sum((whole.lasting[rows] != 0.0) & ~self._redundant[rows])),
        )


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
