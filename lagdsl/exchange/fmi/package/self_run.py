"""An FMU tried out by itself, in a process of its own: `python -P self_run.py F.fmu me cs`.

Writes one line of JSON: {"problems": what the validator found} if it did, else {"ran": kind} for each kind that came
through its first steps. A failure shows as an exception on standard error, or as the death of the process.

The validator does not read the names of variables here, for which it takes 3 ms each:
`lagdsl.exchange.fmi.variables.names` writes them by the grammar, and tests have the validator read them.
"""

from __future__ import annotations

import ctypes
import json
import math
import sys
import tempfile
from typing import Any

from fmpy import extract
from fmpy.fmi2 import FMU2Slave, fmi2Terminated
from fmpy.model_description import ValidationError, read_model_description
from fmpy.simulation import instantiate_fmu

_TYPES = {"me": "ModelExchange", "cs": "CoSimulation"}
# So many steps, each this part of the experiment, or of one second where it has no end.
_STEPS = 10
_PART = 1e-3


def main(path: str, kinds: list[str]) -> None:
    try:
        description: Any = read_model_description(path, validate_model_structure=True)
    except ValidationError as error:
        _say(problems=error.problems)
        return
    if not kinds:
        return
    experiment = description.defaultExperiment
    start = float(getattr(experiment, "startTime", None) or 0.0)
    stop = float(getattr(experiment, "stopTime", None) or start + 1.0)
    with tempfile.TemporaryDirectory() as folder:
        extract(path, folder)
        for kind in kinds:
            instance: Any = instantiate_fmu(folder, description, _TYPES[kind])
            _initialize(instance, start)
            run = _exchange if kind == "me" else _cosimulate
            if run(instance, start, _PART * (stop - start), description):
                instance.terminate()
            instance.freeInstance()
            _say(ran=kind)


def _say(**what: object) -> None:
    print(json.dumps(what), flush=True)


def _initialize(instance: Any, start: float) -> None:
    if hasattr(instance, "setupExperiment"):
        instance.setupExperiment(startTime=start)
        instance.enterInitializationMode()
    else:
        instance.enterInitializationMode(startTime=start)
    instance.exitInitializationMode()


def _cosimulate(instance: Any, t: float, h: float, _: object) -> bool:
    """True if the model has not ended the simulation by itself."""
    for step in range(_STEPS):
        try:
            done = instance.doStep(t + step * h, h)
        except Exception:
            if isinstance(instance, FMU2Slave) and instance.getBooleanStatus(fmi2Terminated):
                return False
            raise
        if done is not None and isinstance(done, tuple) and done[1]:
            return False
    return True


def _exchange(instance: Any, t: float, h: float, description: Any) -> bool:
    """Its start, and states a small step further along their derivatives."""
    older = hasattr(instance, "newDiscreteStates")
    told = (True, False)
    while told[0]:
        told = instance.newDiscreteStates() if older else instance.updateDiscreteStates()
    if told[1]:
        return False
    instance.enterContinuousTimeMode()
    size = description.numberOfContinuousStates if older else instance.getNumberOfContinuousStates()
    signs = description.numberOfEventIndicators if older else instance.getNumberOfEventIndicators()
    x, rates, indicators = ((ctypes.c_double * number)() for number in (size, size, signs))
    derivatives = instance.getDerivatives if older else instance.getContinuousStateDerivatives
    for part in (0.0, _PART * h):
        instance.setTime(t + part)
        if size:
            instance.getContinuousStates(x, size)
            derivatives(rates, size)
            if not all(map(math.isfinite, [*x, *rates])):
                raise ArithmeticError("states or their derivatives are not numbers")
            x[:] = [value + _PART * h * rate for value, rate in zip(x, rates, strict=True)]
            instance.setContinuousStates(x, size)
        if signs:
            instance.getEventIndicators(indicators, signs)
        instance.completedIntegratorStep()
    return True


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
