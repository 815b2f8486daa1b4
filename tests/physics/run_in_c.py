"""A motion by C alone, as exported models have it: no Python looks at singular positions."""

from __future__ import annotations

from collections.abc import Mapping
from ctypes import byref

import numpy as np

import lagdsl
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import contact_rows
from lagdsl.mechanics.structure_points import geometry
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.library import runtime_library
from lagdsl.runtime.structures import RunOptions, RunReport
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.initialize import initial_state


class Motion:
    """`status` is a lag_status, `rows` the states (q, qd, z) at `times` up to where it ended."""

    def __init__(
        self, text: str, stop: float, tolerance: float, rows: int = 400, parameters: Mapping[str, float] | None = None
    ) -> None:
        compilation = lagdsl.compile(text)._compilation
        self.flat: FlatModel = compilation.flat
        engine = CEngine(compilation.program)
        layout = engine.layout
        given = parameters or {}
        p = np.array(
            [given.get(slot.name, value) for slot, value in zip(layout.parameters, layout.defaults, strict=True)]
        )
        initial = initial_state(self.flat, engine, p)
        space = geometry(self.flat, engine, p)
        accuracy = Accuracy(self.flat, space.sizes, 1.0)
        lasting = np.ones(len(space.row_sizes))
        loose = sorted(contact_rows(self.flat))
        lasting[loose] = 0.0
        x = np.concatenate([initial.q, initial.qd, initial.z])
        self.times = initial.t + np.linspace(0.0, stop, rows + 1)
        found = np.full((len(self.times), len(x)), np.nan)
        arrays = {
            "p": p,
            "group": accuracy.groups.astype(np.float64),
            "natural": accuracy.sizes,
            "cap": accuracy.caps,
            "row_sizes": space.row_sizes,
            "lasting": lasting,
            "times": self.times,
            "rows": found,
        }
        kept = {name: np.ascontiguousarray(values) for name, values in arrays.items()}
        general = sum(not flag and row not in loose for row, flag in enumerate(initial.redundant))
        options = RunOptions(tolerance=tolerance, careful=2, general=general, length=stop, count=len(self.times))
        for name, values in kept.items():
            setattr(options, name, values.ctypes.data)
        library, model, report = runtime_library(), engine._model.model, RunReport()
        size = int(library.run_size(model, byref(options)))
        block = np.full(size // 8 + 4, 7.5)
        start = -(-block.ctypes.data // 16) * 16
        run = library.run_place(start, model, byref(options))
        library.run_skip(run, 1)
        found[0] = x
        status = library.run_move(run, initial.t, x.ctypes.data, 0.0)
        self.status = int(status or library.run_to(run, float(self.times[-1]), 1_000_000))
        assert np.all(block[-1:] == 7.5)
        library.run_tell(run, byref(report))
        self.t, self.steps = float(report.t), int(report.steps)
        self.rows: Floats = kept["rows"][: int(report.row)]
        self.state = np.array(report.x[: len(x)])
        self._energies = [
            engine.evaluate(
                "energies", t, *np.split(row, [len(initial.q), 2 * len(initial.q)]), np.zeros(0), np.zeros(0), p
            )[0]
            for t, row in zip(self.times.tolist(), self.rows, strict=False)
        ]

    def __getitem__(self, name: str) -> Floats:
        """Rows of a coordinate, or of its rate `der(name)`."""
        names = [c.name for c in self.flat.coordinates]
        rate = name.startswith("der(")
        return self.rows[:, names.index(name[4:-1] if rate else name) + rate * len(names)]

    @property
    def drift(self) -> float:
        """Of energy, as a part of its largest value."""
        energy = np.array(self._energies)
        return float(np.max(np.abs(energy - energy[0])) / np.max(np.abs(energy)))
