"""The frequency response of a model about a state, through the descriptor form."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.control.descriptor import descriptor
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse, frequencies_of
from lagdsl.motion.analysis.control.margins import Margins
from lagdsl.motion.analysis.control.transfer import TransferFunction
from lagdsl.motion.analysis.eigen import Complexes
from lagdsl.motion.analysis.linearization import Linearization, linear_of
from lagdsl.motion.analysis.linearize import holonomic_rows, reduce, state_names
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.steady import imbalance


def bode_at(
    system: System, point: Point, channel: tuple[str | None, str | None], omega: Floats | None, sink: Sink
) -> FrequencyResponse | None:
    """From the input to the output that `channel` names; None after errors. W0854 where the point is not steady."""
    at = reduce(system, point, holonomic_rows(system), sink)
    at = None if at is None else on_both_sides(system, at, sink)
    if at is None:
        return None
    linear = linear_of(system, at)
    transfer = linear.transfer_function(*channel)
    if linear.steadiness.kind == "neither":
        sink.report("W0854", None, reason=imbalance(linear.steadiness))
    margins = margins_or_none(transfer)
    asked = frequencies_of(transfer, margins) if omega is None else omega
    form = descriptor(system, at)
    source = [each.name for each in linear.inputs].index(transfer.input.name)
    outputs = [each.name for each in linear.outputs]
    if transfer.output.name in outputs:
        row = outputs.index(transfer.output.name)
        response = form.response(asked, source, form.c[row], float(form.d[row, source]))
    else:
        names = [each.name for each in state_names(system, at.partition)]
        response = form.response(asked, source, form.row_of_state(names.index(transfer.output.name)), 0.0)
    return response_of(linear, transfer, margins, asked, response)


def sampled_bode(
    linear: Linearization, channel: tuple[str | None, str | None], omega: Floats | None
) -> FrequencyResponse:
    """Of a sampled system."""
    transfer = linear.transfer_function(*channel)
    margins = margins_or_none(transfer)
    asked = frequencies_of(transfer, margins) if omega is None else omega
    return response_of(linear, transfer, margins, asked, transfer.response(asked))


def margins_or_none(transfer: TransferFunction) -> Margins | None:
    """None for a sampled system with a pole at z = -1."""
    try:
        return transfer.margins
    except ValueError:
        return None


def response_of(
    linear: Linearization, transfer: TransferFunction, margins: Margins | None, omega: Floats, response: Complexes
) -> FrequencyResponse:
    """`response` at `omega` [rad/s], with what belongs to it."""
    return FrequencyResponse(
        model=linear.model,
        point=linear.point,
        steadiness=linear.steadiness,
        input=transfer.input,
        output=transfer.output,
        frequencies=omega / (2.0 * np.pi),
        response=response,
        transfer=transfer,
        margins=margins,
    )
