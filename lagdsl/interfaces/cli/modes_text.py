"""Modes and thresholds as tables for people."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from lagdsl.interfaces.cli.state_text import point_text, steadiness_text
from lagdsl.interfaces.cli.text_table import number, text_table
from lagdsl.language.flat.display import Display
from lagdsl.motion.analysis.modes import AXIS, Modes, held_text
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sampled.schedule import time_text
from lagdsl.motion.analysis.sampled.verdict import SampledModes
from lagdsl.motion.analysis.variation import Variation

_MOST_ENTRIES = 8
_MOST_NAMES = 4
_NEGLIGIBLE = 1e-9


def modes_text(system: System, found: Modes) -> str:
    """State, eigenvalues, shapes and stability. The text shows one of each pair of conjugate eigenvalues."""
    loop = found.loop
    head = f"{found.model}: {len(found.eigenvalues)} eigenvalues about"
    if loop is not None:
        period = time_text(loop.period)
        head = f"{found.model}: sampled loop with {len(loop.multipliers)} multipliers in {period}, about"
    shown = [i for i, s in enumerate(found.eigenvalues.tolist()) if not s.imag < 0.0 and s != 0.0]
    zeros = int(np.count_nonzero(found.eigenvalues == 0.0))
    header = ["mode", "eigenvalue [1/s]", "frequency [Hz]", "damping", "time constant [s]"]
    rows = [[str(k + 1), *_figures(found, i)] for k, i in enumerate(shown)]
    if zeros:
        rows.append(["", "0" if zeros == 1 else f"0 ({zeros} times)", "-", "-", "-"])
    shapes = [_shape(found, k, i) for k, i in enumerate(shown)]
    parts = [
        head,
        f"{point_text(system, found.point)}\n{steadiness_text(found.steadiness) if loop is None else _kind(loop)}",
        "" if loop is None else _multipliers(loop),
        "" if loop is None else f"the plant between ticks, with {_names(found.held)} held",
        text_table(header, rows) if rows else "",
        "\n".join(["shapes, largest entry 1 (SI units)", *shapes]) if shapes else "",
    ]
    if found.dropped:
        names = ", ".join(found.integrable)
        parts.append(f"{found.dropped} zero eigenvalue(s) left out: velocity constraint {names} is integrable")
    parts.append(f"{found.stability[0].upper()}{found.stability[1:]}.")
    return "\n\n".join(part for part in parts if part)


def _kind(loop: SampledModes) -> str:
    """Kind of the point of a sampled loop."""
    if loop.unbalanced:
        return f"This is no fixed point of the loop: {_names(loop.unbalanced)} would change in a period."
    if loop.running:
        return f"This is a steady motion of the loop; these run and influence nothing else: {_names(loop.running)}."
    return "This is a fixed point of the loop."


def _names(names: Sequence[str]) -> str:
    more = f" and {len(names) - _MOST_NAMES} more" if len(names) > _MOST_NAMES else ""
    return ", ".join(f"`{name}`" for name in names[:_MOST_NAMES]) + more


def _multipliers(loop: SampledModes) -> str:
    """One of each pair."""
    columns = zip(loop.multipliers.tolist(), loop.frequencies.tolist(), loop.time_constants.tolist(), strict=True)
    rows: list[list[str]] = []
    for z, frequency, tau in columns:
        if z.imag < 0.0:
            continue
        value = f"{number(z.real)} ± {number(z.imag)}i" if z.imag else number(z.real)
        decay = "-" if math.isinf(tau) or z == 0.0 else number(tau)
        rows.append([str(len(rows) + 1), value, number(abs(z)), number(frequency) if frequency else "-", decay])
    return text_table(["mode", "multiplier", "magnitude", "frequency [Hz]", "time constant [s]"], rows)


def _figures(found: Modes, i: int) -> list[str]:
    s, f = complex(found.eigenvalues[i]), float(found.frequencies[i])
    real = s.real if abs(s.real) > AXIS * abs(s) else 0.0
    value = f"{number(real)} ± {number(s.imag)}i" if f > 0.0 else number(real)
    damping, tau = float(found.damping[i]), float(found.time_constants[i])
    return [
        value,
        number(f) if f > 0.0 else "-",
        "-" if math.isnan(damping) or f == 0.0 else number(damping if abs(damping) > AXIS else 0.0),
        "-" if math.isinf(tau) else number(tau),
    ]


def _shape(found: Modes, k: int, i: int) -> str:
    """`1  x = 1, y = 0.5 at -90 deg`, largest entries first come as declared."""
    shape = found.shapes[i]
    entries = [j for j in range(len(shape)) if abs(shape[j]) > _NEGLIGIBLE]
    largest = sorted(sorted(entries, key=lambda j: -abs(shape[j]))[:_MOST_ENTRIES])
    texts = [f"{found.places[j].name} = {_phasor(complex(shape[j]))}" for j in largest]
    more = [f"and {len(entries) - len(largest)} more"] if len(entries) > len(largest) else []
    return f"  {k + 1}  " + (", ".join([*texts, *more]) or "rates only")


def _phasor(value: complex) -> str:
    """Real entries with their sign, others by magnitude and phase."""
    if abs(value.imag) <= 1e-6 * abs(value):
        return number(value.real)
    return f"{number(abs(value))} at {math.degrees(math.atan2(value.imag, value.real)):.4g} deg"


def variation_text(found: Variation, shown: Display) -> str:
    """Thresholds, then the intervals between them; varied values in the unit `shown`."""
    unit = f" {shown.unit}" if shown.unit else ""
    name = found.varied.name
    first, last = (shown(float(found.values[end])) for end in (0, -1))
    what = "sampled loop" if found.of_loop else "eigenvalues"
    lines = [f"{found.model}: {what} for {len(found.values)} values of {name} from {first:g} to {last:g}{unit}"]
    for each in found.thresholds:
        how = f"flutter at {number(each.frequency)} Hz" if each.kind == "flutter" else "divergence"
        side = "above" if each.unstable_above else "below"
        lines.append(f"  threshold {name} = {shown(each.value):.12g}{unit}: {how}, growing {side}")
    if not found.thresholds:
        crossing = "multiplier crosses the unit circle" if found.of_loop else "eigenvalue crosses the imaginary axis"
        lines.append(f"  no {crossing}")
    if found.held:
        lines.append(f"  no statement on stability: {held_text(found.held)}")
    missing = sum(count < 0 for count in found.unstable)
    if missing:
        lines.append(f"  {missing} value(s) have no linearization")
    rows = [_interval(found, shown, *part) for part in _parts(found.unstable)]
    head = [f"{name} [{shown.unit}]" if unit else name, "growing modes", "fastest growth [1/s]"]
    return "\n".join([*lines, "", text_table(head, rows)])


def _parts(counts: tuple[int, ...]) -> list[tuple[int, int]]:
    """First and last index of each run of equal counts."""
    edges = [0, *(i for i in range(1, len(counts)) if counts[i] != counts[i - 1]), len(counts)]
    return [(a, b - 1) for a, b in pairwise(edges)]


def _interval(found: Variation, shown: Display, first: int, last: int) -> list[str]:
    values = found.eigenvalues[first : last + 1].real
    growth = float(np.nanmax(values, initial=0.0)) if found.unstable[first] > 0 else 0.0
    count = "no linearization" if found.unstable[first] < 0 else str(found.unstable[first])
    limits = f"{shown(float(found.values[first])):g} to {shown(float(found.values[last])):g}"
    return [limits, count, number(growth) if growth > 0.0 else "-"]
