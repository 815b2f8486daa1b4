"""Turned frames must have axes that exist and are orthonormal (E0516)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.probe import probes
from lagdsl.language.flat.spans import around, place

_TOLERANCE = 1e-9
_MOMENTS = 3


def check_frames(flat: fm.FlatModel, sink: Sink) -> None:
    """E0516 for `.axes` of vectors that are no right-handed orthonormal set and for `.rotate` about the zero vector.

    Both are tried with the parameters as given, at the start and at random moments.
    """
    frames = [item for item in flat.named if isinstance(item, fm.Frame) and _delicate(item)]
    if not frames:
        return
    moments = probes(flat, _MOMENTS)
    evaluators = [Evaluator(flat, Values(variables=moment.variables, rates=moment.rates)) for moment in moments]
    for frame in frames:
        reason = next((found for each in evaluators if (found := _fault(frame, each)) is not None), None)
        if reason is not None:
            sink.report("E0516", place(frame), *around(frame), reason=reason)


def _delicate(frame: fm.Frame) -> bool:
    return any(isinstance(step, fm.SetAxes | fm.RotateAbout) for step in frame.steps)


def _fault(frame: fm.Frame, evaluator: Evaluator) -> str | None:
    try:
        for step in frame.steps:
            if isinstance(step, fm.SetAxes):
                found = _fault_of_axes(np.array([evaluator.vector(axis) for axis in (step.x, step.y, step.z)]))
                if found is not None:
                    return found
            if isinstance(step, fm.RotateAbout) and not np.any(evaluator.vector(fx.Vector(*step.axis))):
                return "the axis of `rotate` is the zero vector"
    except NotEvaluable:
        pass
    return None


def _fault_of_axes(axes: NDArray[np.float64]) -> str | None:
    """Fault of three vectors in the rows of `axes`; None if they are valid or not a number here."""
    if not np.all(np.isfinite(axes)):
        return None
    products = axes @ axes.T
    for i in range(3):
        if abs(products[i, i] - 1.0) > _TOLERANCE:
            return f"the {_ORDER[i]} vector of `axes` has the length {np.sqrt(products[i, i]):.4g} instead of 1"
    for i, j in ((0, 1), (0, 2), (1, 2)):
        if abs(products[i, j]) > _TOLERANCE:
            return f"the {_ORDER[i]} and the {_ORDER[j]} vector of `axes` are not perpendicular"
    return "the vectors of `axes` are left-handed" if np.linalg.det(axes) < 0 else None


_ORDER = ("first", "second", "third")
