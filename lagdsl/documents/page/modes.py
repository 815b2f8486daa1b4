"""Modes as moving shapes: each of them about its equilibrium, with its frequency and damping."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from lagdsl.documents.page.head import Json, fields, finite, head_of
from lagdsl.documents.page.runs import Run, page_of_runs
from lagdsl.documents.plot.picture.recording import Prepared, Recording, parameters_of, prepare, recording_of
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.analysis.modes import Modes, phase_of
from lagdsl.motion.analysis.point import Point
from lagdsl.motion.analysis.variation import Variation

_MOST_MODES = 12
_FRAMES = 97
# Of a mode that oscillates, and the time constants of one that does not.
_PERIODS, _CONSTANTS = 3.0, 4.0
_SECONDS = 2.0  # that a period takes to watch
# Displacement of the point that moves most, in lengths of the machine, and the largest change of a coordinate.
_REACH, _LARGEST = 0.12, 0.5
LEVELS = (("small", 0.4), ("medium", 1.0), ("large", 2.0))


def modes_page(
    flat: FlatModel, modes: Modes, *, names: Sequence[str], variation: Variation | None = None,
    source: SourceFile | None = None,
) -> str:  # fmt: skip
    """The page of `modes`, whose point has its parameters in the order of `names`; zeros have no shape to show.

    Of a pair of conjugate eigenvalues one is shown, x(t) = x0 + Re(a shape exp(s t)), dependent coordinates moved onto
    the constraints. With `variation` eigenvalues over a parameter and their thresholds stand beside. Raises ValueError
    where no mode moves.
    """
    prepared = prepare(flat)
    chosen = Wishes(parameters=dict(zip(names, modes.point.p.tolist(), strict=True)))
    p = parameters_of(prepared.engine.layout, chosen)
    shown = [i for i, s in enumerate(modes.eigenvalues.tolist()) if not s.imag < 0.0 and s != 0.0][:_MOST_MODES]
    if not shown:
        why = "all eigenvalues are zero" if len(modes.eigenvalues) else "nothing in it is free to move"
        raise ValueError(f"{modes.model} has no mode that moves: {why}")
    still = recording_of(prepared, [replace(modes.point, p=p)], "modes")
    runs = [run for i in shown for run in _runs(prepared, modes, i, p, still)]
    head = head_of(still, Wishes(), source, [run.motion for run in runs])
    told: dict[str, Json] = {
        "modes": [_told(modes, i) for i in shown],
        "levels": [name for name, _ in LEVELS],
        "stability": modes.stability,
        "locus": None if variation is None else _locus(variation),
    }
    return page_of_runs(flat, {**head, **told}, runs)


def _told(modes: Modes, i: int) -> Json:
    s = complex(modes.eigenvalues[i])
    return {
        "eigenvalue": [s.real, s.imag],
        "frequency": float(modes.frequencies[i]),
        "damping": finite(float(modes.damping[i])),
        "constant": finite(float(modes.time_constants[i])),
        "shape": [
            {"name": place.name, "size": abs(entry), "phase": phase_of(entry)}
            for place, entry in zip(modes.places, modes.shapes[i].tolist(), strict=True)
        ],
    }


def _locus(variation: Variation) -> Json:
    rows = variation.eigenvalues.tolist()
    eigenvalues = [[[s.real, s.imag] if math.isfinite(abs(s)) else None for s in row] for row in rows]
    thresholds = [fields(each, "value kind frequency unstable_above") for each in variation.thresholds]
    values = variation.values.tolist()
    return fields(variation.varied, "name unit", values=values, eigenvalues=eigenvalues, thresholds=thresholds)


def _runs(prepared: Prepared, modes: Modes, i: int, p: Floats, still: Recording) -> list[Run]:
    """One for each level of amplitude."""
    s = complex(modes.eigenvalues[i])
    length, pace = _duration(s)
    times = np.linspace(0.0, length, _FRAMES)
    # Of a mode that grows the end is as large as the start of one that decays.
    change = np.exp(s * times) * (math.exp(-s.real * length) if s.real > 0.0 else 1.0)
    size = _amplitude(prepared, modes, i, p, still)
    found = []
    for level, factor in LEVELS:
        moments = zip((factor * size * change).tolist(), times.tolist(), strict=True)
        points = [_moved(prepared, modes, i, c, t, p) for c, t in moments]
        motion = recording_of(prepared, points, "modes").motion
        found.append(Run(label=f"mode {i + 1}, {level}", motion=motion, span=(0.0, length), pace=pace))
    return found


def _duration(s: complex) -> tuple[float, float]:
    """Length of what is shown of a mode [s], and the seconds of it that pass in one."""
    if abs(s.imag) > 1e-7 * abs(s):
        period = 2.0 * math.pi / abs(s.imag)
        decayed = math.inf if s.real == 0.0 else 5.0 / abs(s.real)
        return max(min(_PERIODS * period, decayed), period), period / _SECONDS
    constant = 1.0 / abs(s.real)
    return _CONSTANTS * constant, constant / (0.5 * _SECONDS)


def _moved(prepared: Prepared, modes: Modes, i: int, factor: complex, t: float, p: Floats) -> Point:
    """The state at `t`, on the constraints of position level."""
    at, s = modes.point, complex(modes.eigenvalues[i])
    shape = modes.shapes[i]
    count = len(at.q)
    change, rate = (factor * shape).real, (factor * s * shape).real
    state = Point(t=t, q=at.q + change[:count], qd=at.qd + rate[:count], z=at.z + change[count:], u=at.u, w=at.w, p=p)
    return replace(state, q=_closed(prepared, state))


def _closed(prepared: Prepared, at: Point) -> Floats:
    """Coordinates by Newton's method in the least norm: loops stay closed at finite amplitudes."""
    q = at.q.copy()
    for _ in range(6):
        phi, jacobian = prepared.engine.evaluate("position_constraint", *replace(at, q=q).arguments)
        if not phi.size or float(np.max(np.abs(phi))) < 1e-10:
            break
        step = np.linalg.lstsq(jacobian, phi, rcond=None)[0]
        if not np.all(np.isfinite(step)):
            break
        q -= step
    return q


def _amplitude(prepared: Prepared, modes: Modes, i: int, p: Floats, still: Recording) -> float:
    """So large that the point that moves most is seen to move; a mode that moves none is seen on its gauges."""
    probe = 1e-5
    moved = recording_of(prepared, [_moved(prepared, modes, i, probe, modes.point.t, p)], "modes")
    ahead, before = (_places(each) for each in (moved, still))
    length = float(np.linalg.norm(np.ptp(before, axis=0))) if len(before) else 0.0
    fastest = float(np.max(np.linalg.norm(ahead - before, axis=1), initial=0.0)) / probe
    largest = _LARGEST / max(float(np.max(np.abs(modes.shapes[i][: len(modes.point.q)]), initial=0.0)), 1e-12)
    return min(_REACH * length / fastest, largest) if fastest * largest > 1e-6 * length > 0.0 else largest


def _places(made: Recording) -> Floats:
    """The places (n, 3) of the scene at the first row, but for frames."""
    numbers = np.array([column.values[0] for column in made.motion.columns[-len(made.scene.columns) :]])
    shapes = (shape for shape in made.scene.shapes if shape.kind != "frame")
    places = [value for shape in shapes for role, value in shape.numbers.items() if role in ("at", "to")]
    return np.array([made.scene.values(numbers, place) for place in places]).reshape(-1, 3)
