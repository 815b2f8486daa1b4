"""Parameters that are dampings, and negative (W0522)."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.flat.spans import around, place

_TYPES = frozenset({"Damping", "RotationalDamping", "TranslationalDampingConstant", "RotationalDampingConstant"})


def check_damping(flat: fm.FlatModel, sink: Sink) -> bool:
    """True if any is negative with the defaults of the parameters.

    Their types have no lower bound: a negative damping is a model of self-excited oscillations.
    """
    found = False
    dampings = [item for item in flat.parameters if item.type_name in _TYPES]
    for parameter in dampings:
        found |= _check(parameter, parameter.value, sink)
    dependent = [
        item
        for item in flat.named
        if isinstance(item, fm.Definition) and item.type_name in _TYPES and item.variability == Variability.PARAMETER
    ]
    if dependent:
        evaluator = Evaluator(flat, Values())
        for item in dependent:
            try:
                found |= _check(item, evaluator.scalar(item.value), sink)
            except NotEvaluable:
                continue
    return found


def _check(item: fm.Parameter | fm.Definition, value: float, sink: Sink) -> bool:
    if value >= 0.0:
        return False
    subject = f"damping `{item.name}`"
    sink.report("W0522", place(item), *around(item), subject=subject, value=f"{value:g} {item.unit}")
    return True
