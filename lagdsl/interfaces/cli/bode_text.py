"""A frequency response as a table for people."""

from __future__ import annotations

import math

import numpy as np

from lagdsl.interfaces.cli.state_text import point_text, steadiness_text
from lagdsl.interfaces.cli.text_table import number, text_table
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse
from lagdsl.motion.analysis.control.margins import Margins, lag
from lagdsl.motion.analysis.control.transfer import TransferFunction
from lagdsl.motion.analysis.eigen import Complexes
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sampled.schedule import time_text

_ROWS = 13
_MOST = 8


def bode_text(system: System, found: FrequencyResponse) -> str:
    """State, poles and zeros, rows of the response, margins."""
    transfer = found.transfer
    units = f"[{found.output.unit or '1'} per {found.input.unit or '1'}]"
    every = "" if found.every is None else f", sampled every {time_text(found.every)}"
    head = f"{found.model}: from {found.input.name} to {found.output.name} {units}{every}, about"
    parts = [
        f"{head}\n\n{point_text(system, found.point)}\n{steadiness_text(found.steadiness)}",
        *([] if transfer is None else [_quotient(transfer)]),
        _table(found),
        _margins(found.margins)
        if transfer is not None
        else "Delays are exact here; with them there is no quotient of polynomials, and no margins.",
    ]
    return "\n\n".join(parts)


def _quotient(transfer: TransferFunction) -> str:
    letter, unit = ("s", " [1/s]") if transfer.every is None else ("z", "")
    return "\n".join(
        [
            f"gain   {number(transfer.gain)}, of G = gain prod({letter} - zeros)/prod({letter} - poles)",
            f"zeros  {_roots(transfer.zeros)}{unit}",
            f"poles  {_roots(transfer.poles)}{unit}",
        ]
    )


def _table(found: FrequencyResponse) -> str:
    """Rows at frequencies that are spread evenly, and those next to a crossing."""
    count = len(found.frequencies)
    evenly = np.geomspace(found.frequencies[0], found.frequencies[-1], min(_ROWS, count))
    places = {int(np.argmin(np.abs(found.frequencies - each))) for each in evenly}
    columns = (found.frequencies, found.magnitude, found.decibels, np.degrees(found.phase))
    rows = [[number(float(each[k])) for each in columns] for k in sorted(places)]
    return text_table(["frequency [Hz]", "magnitude", "[dB]", "phase [deg]"], rows)


def _roots(values: Complexes) -> str:
    """One of each pair, equal ones counted; `none` without any."""
    told: dict[str, int] = {}
    for value in values.tolist():
        if value.imag < -1e-12 * abs(value):
            continue
        oscillates = abs(value.imag) > 1e-9 * abs(value)
        real = value.real if abs(value.real) > 1e-9 * abs(value) else 0.0
        text = f"{number(real)} ± {number(value.imag)}i" if oscillates else number(real)
        told[text] = told.get(text, 0) + 1
    texts = [text if times == 1 else f"{text} ({times} times)" for text, times in told.items()]
    more = [f"and {len(texts) - _MOST} more"] if len(texts) > _MOST else []
    return ", ".join([*texts[:_MOST], *more]) or "none"


def _margins(margins: Margins | None) -> str:
    """The loop u = -y: how far it is from the border of stability."""
    if margins is None:
        return "No margins: a pole lies at z = -1."
    verdict = "stable" if margins.stable else "not stable"
    lines = [f"with u = -y in SI units the loop is {verdict}"]
    if math.isfinite(margins.gain):
        at = min(margins.of_gain, key=lambda each: abs(math.log(abs(each.value)))).omega
        lines.append(
            f"gain margin   {number(margins.gain)}, {number(20.0 * math.log10(margins.gain))} dB, at {_hertz(at)}"
        )
    else:
        lines.append("gain margin   none: the phase is nowhere half a turn")
    if math.isfinite(margins.phase):
        least = min(margins.of_phase, key=lambda each: abs(lag(each.value)))
        lines.append(f"phase margin  {number(math.degrees(margins.phase))} deg at {_hertz(least.omega)}")
        lines.append(f"delay margin  {number(margins.delay)} s")
    else:
        lines.append("phase margin  none: the gain is nowhere one")
    return "\n".join(lines)


def _hertz(omega: float) -> str:
    return f"{number(omega / (2.0 * math.pi))} Hz"
