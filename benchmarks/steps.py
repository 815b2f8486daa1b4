"""A motion by steps of 1 ms from Python: a session, many sessions, an FMU under FMPy, calls of `simulate`."""

import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave

import lagdsl

PENDULUM = Path(__file__).parents[1] / "models" / "double_pendulum.lag"
STEP, STEPS, MANY, ROUNDS = 1e-3, 2000, 1000, 7
WATCHED = "a"


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """CPU microseconds of a step, the value of one coordinate read: medians of rounds in which all take turns."""
    say("steps: sessions and FMPy")
    model = lagdsl.compile(PENDULUM, engine="c")
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / "DoublePendulum.fmu"
        model.export_fmu(file)
        description = read_model_description(str(file))
        unpacked = extract(str(file), str(Path(name) / "unpacked"))
        contestants: dict[str, Callable[[], float]] = {
            "runtime": lambda: _rows(model),
            "session": lambda: _session(model, record=False),
            "session with its motion": lambda: _session(model, record=True),
            "many": lambda: _many(model),
            "fmpy": lambda: _fmu(description, unpacked),
            "simulate": lambda: _runs(model),
        }
        rounds = [{name: call() for name, call in contestants.items()} for _ in range(ROUNDS)]
    return {name: statistics.median(each[name] for each in rounds) for name in contestants}


def _timed(call: Callable[[int], object], count: int) -> float:
    """Microseconds of one of `count` calls, each with its number."""
    start = time.process_time()
    for k in range(count):
        call(k)
    return (time.process_time() - start) / count * 1e6


def _rows(model: lagdsl.Model) -> float:
    """The integrator, and a row at the end of each step: one call, no step in Python."""
    start = time.process_time()
    model.simulate(stop=STEPS * STEP, interval=STEP)
    return (time.process_time() - start) / STEPS * 1e6


def _session(model: lagdsl.Model, *, record: bool) -> float:
    run = model.session(record=record)

    def step(_: int) -> float:
        run.step(STEP)
        return float(run[WATCHED])

    return _timed(step, STEPS)


def _many(model: lagdsl.Model) -> float:
    """Of one session of many."""
    runs = model.sessions(MANY)

    def step(_: int) -> object:
        runs.step(STEP)
        return runs[WATCHED]

    return _timed(step, STEPS // 10) / MANY


def _fmu(description: Any, unpacked: str) -> float:
    fmu = FMU2Slave(
        guid=description.guid,
        unzipDirectory=unpacked,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="timed",
    )
    (watched,) = (each.valueReference for each in description.modelVariables if each.name == WATCHED)
    fmu.instantiate()
    fmu.setupExperiment(startTime=0.0)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()

    def step(k: int) -> object:
        fmu.doStep(k * STEP, STEP)
        return fmu.getReal([watched])

    found = _timed(step, STEPS)
    fmu.terminate()
    fmu.freeInstance()
    return found


def _runs(model: lagdsl.Model) -> float:
    """A call of `simulate` for each step, each from the end of the one before: what sessions are for."""
    names = [*model.coordinates, *(f"der({name})" for name in model.coordinates)]
    start: dict[str, float] = {}

    def step(_: int) -> None:
        motion = model.simulate(start=start, stop=STEP, interval=STEP)
        start.update((name, float(motion[name][-1])) for name in names)

    return _timed(step, STEPS // 20)


TITLES = {
    "runtime": "the integrator and a row, in one call",
    "session": "`session.step`",
    "session with its motion": "the same, with its motion kept",
    "many": f"`sessions({MANY})`, a step of one of them",
    "fmpy": "FMU, `doStep` and `getReal` of FMPy",
    "simulate": "`simulate` in a loop",
}


def section(found: dict[str, Any]) -> list[str]:
    """Of README.md."""
    lines = ["## Steps from Python", ""]
    lines += ["The double pendulum by steps of 1 ms at the tolerance of its text, one angle read behind each: CPU"]
    lines += [f"microseconds of a step, medians of {ROUNDS} rounds in which all take turns.", ""]
    lines += ["| | a step [us] | above the integrator [us] |", "|---|---|---|"]
    own = found["runtime"]
    return lines + [f"| {title} | {found[name]:.2f} | {found[name] - own:.2f} |" for name, title in TITLES.items()]
