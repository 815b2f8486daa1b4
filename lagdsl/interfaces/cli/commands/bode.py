"""`lag bode FILE --from u --to y`: a frequency response, with poles, zeros and margins."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.interfaces.cli.bode_text import bode_text
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.output import draft_of, require_figure, require_writable
from lagdsl.interfaces.cli.small_motions import (
    Options,
    finish,
    period_or_leave,
    request,
    takes_every,
    takes_state_and_form,
)
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.literal import literal
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse
from lagdsl.motion.analysis.where import bode

_POINTS = 401
_FACTORS = {"Hz": 2.0 * np.pi, "kHz": 2e3 * np.pi, "MHz": 2e6 * np.pi, "rad/s": 1.0}


@click.command("bode", cls=Command)
@takes_state_and_form("--form")
@click.option("--from", "source", metavar="INPUT", help="The input; default: the only one.")
@click.option("--to", "target", metavar="NAME", help="An output, or a state as `lag linearize` names it.")
@takes_every
@click.option("--band", metavar="F:F", help="Frequencies: '0.1:100 Hz' or '1:500 rad/s'; default: all that happens.")
@click.option("--plot", "picture", type=PATH, help="Write a Bode plot: .png, .svg, .pdf.")
def command(
    options: Options,
    source: str | None,
    target: str | None,
    every: str | None,
    band: str | None,
    picture: Path | None,
) -> None:
    """Show how an output of FILE follows sinusoids in an input, about its initial state: gain, zeros, poles, magnitude,
    phase, and the margins of the loop u = -y."""
    require_writable(picture)
    if picture is not None:
        require_figure(picture)
    omega, period = None if band is None else _band(band), period_or_leave(every)
    asked = request(options)
    channel = (source, target)
    found = asked.ask(lambda system, at, sink: bode(system, at, sink, channel=channel, omega=omega, every=period))
    finish(asked, bode_text(asked.system, found), _data(found), _table(found))
    if picture is not None:
        from lagdsl.documents.plot.bode import plot_bode

        with draft_of(picture) as draft:
            plot_bode(found, draft)


def _band(text: str) -> Floats:
    """Angular frequencies from the first to the last, evenly on a logarithmic axis. Raises SettingError."""
    example = "expected first:last with a unit, as in 0.1:100 Hz or 1:500 rad/s"
    if text.count(":") != 1:
        raise SettingError(f"--band={text}: {example}")
    first, last = (literal("--band", part.strip(), "0.1:100 Hz") for part in text.split(":"))
    units = [first.unit or last.unit, last.unit]
    if any(unit not in _FACTORS for unit in units):
        raise SettingError(f"--band={text}: {example}")
    low, high = (
        float(each.text.removesuffix(each.unit)) * _FACTORS[unit]
        for each, unit in zip((first, last), units, strict=True)
    )
    if not 0.0 < low < high:
        raise SettingError(f"--band={text}: the frequencies have to rise from above zero")
    return np.asarray(np.geomspace(low, high, _POINTS))


def _data(found: FrequencyResponse) -> dict[str, Any]:
    transfer, margins = found.transfer, found.margins
    quotient = {} if transfer is None else {"gain": transfer.gain, "zeros": transfer.zeros, "poles": transfer.poles}
    told = {} if margins is None else {
        "gain_margin": margins.gain,
        "phase_margin": margins.phase,
        "delay_margin": margins.delay,
        "closed_loop_poles": margins.closed,
        "closed_loop_stable": margins.stable,
    }  # fmt: skip
    return {
        "model": found.model,
        "input": found.input.name,
        "output": found.output.name,
        "input_unit": found.input.unit,
        "output_unit": found.output.unit,
        "kind": found.steadiness.kind,
        "every": found.every,
        "frequencies": found.frequencies,
        "response": found.response,
        "magnitude": found.magnitude,
        "phase": found.phase,
        **quotient,
        **told,
    }


def _table(found: FrequencyResponse) -> list[list[Any]]:
    rows: list[list[Any]] = [["frequency [Hz]", "re", "im", "magnitude", "phase [rad]"]]
    columns = zip(
        found.frequencies.tolist(), found.response.tolist(), found.magnitude.tolist(), found.phase.tolist(), strict=True
    )
    return [*rows, *([f, g.real, g.imag, size, angle] for f, g, size, angle in columns)]
