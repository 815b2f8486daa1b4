"""From the names of quantities to the directions that a run is differentiated along, and back to words."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NoReturn

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_sensitivities import Directions
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Sink, refused
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import place as where
from lagdsl.motion.simulate.initialize import InitialState, places_of
from lagdsl.motion.simulate.state_words import time_text

_START = ".start"


def directions_of(flat: FlatModel, engine: Engine, names: Sequence[str]) -> Directions:
    """Unit directions of the quantities `names`: parameters, starts as `theta.start`, inputs. Raises as
    `check_differentiable`."""
    p, u, start = _units(flat, engine.layout, names)
    motion = engine.differentiated()
    alone = motion is not None and not engine.layout.outputs  # nothing else has to be differentiated
    by_state = None if alone else engine.along()
    by_parameter = engine.along_parameters() if p.any() and not alone else None
    return Directions(p=p, u=u, start=start, by_state=by_state, by_parameter=by_parameter, motion=motion)


def _units(flat: FlatModel, layout: Layout, names: Sequence[str]) -> tuple[Floats, Floats, Floats]:
    """Of the parameters (names, np), the inputs (names, nu) and the starts (names, 2 nq + nz)."""
    parameters, inputs = ([slot.name for slot in slots] for slots in (layout.parameters, layout.inputs))
    starts = [f"{name}{_START}" for name in places_of(flat)]
    p, u, start = (np.zeros((len(names), len(each))) for each in (parameters, inputs, starts))
    for k, name in enumerate(names):
        for known, to in ((parameters, p), (inputs, u), (starts, start)):
            if name in known:
                to[k, known.index(name)] = 1.0
                break
        else:
            _refuse(flat, name, [*parameters, *starts, *inputs])
    return p, u, start


def check_differentiable(flat: FlatModel, layout: Layout, names: Sequence[str]) -> None:
    """Raises UnknownName and CallRefused (E0880) for what has no derivatives."""
    _units(flat, layout, names)


def check_controlled(speeds: Sequence[bool], following: Sequence[bool]) -> None:
    """Raises CallRefused (E0884) where controllers set a speed, whose jumps are blows."""
    if any(speed and not follows for speed, follows in zip(speeds, following, strict=False)):
        raise refused("E0884", text="signals in `inputs` for the speeds that the model prescribes, not controllers")


def _refuse(flat: FlatModel, name: str, known: list[str]) -> NoReturn:
    if any(each.name == name and each.structural for each in flat.parameters):
        raise refused("E0880", name=name)
    raise unknown_among("quantity of `tangents`", name, known)


def differentiate(
    flat: FlatModel,
    run: Run,
    initial: InitialState,
    given: Collection[str],
    names: Sequence[str],
    directions: Directions,
) -> None:
    """Lets the run, whose start was found with those `given`, be differentiated by the quantities `names` along these
    directions. Raises CallRefused (E0882) where the start has no derivatives."""
    chosen = np.array([name in given for name in places_of(flat)], dtype=np.uint8)
    status = run.differentiate(initial.t, initial.starts, chosen, directions)
    if status is not Status.OK:
        sensitivities = run.results.sensitivities
        at_fault = 0 if sensitivities is None else int(sensitivities.fault.guard)
        raise refused("E0882", name=names[at_fault], time=time_text(initial.t))


def tell_one_sided(run: Run, sink: Sink) -> None:
    """W0883 where several guards left their modes at one instant."""
    sensitivities = run.results.sensitivities
    if sensitivities is not None and sensitivities.fault.one_sided:
        fault = sensitivities.fault
        sink.report("W0883", None, count=fault.one_sided, time=time_text(fault.first))


def report_no_derivative(flat: FlatModel, run: Run, status: Status, names: Sequence[str], sink: Sink) -> str:
    """E0881 or E0882: why the motion has no derivatives from now on. Returns the name at fault."""
    assert run.results.sensitivities is not None, "internal error: nobody asked for derivatives"
    fault = run.results.sensitivities.fault
    if status is Status.GRAZING:
        which, relations = int(fault.guard), flat.events.relations
        contacts, frictions = flat.events.contacts, flat.events.frictions
        if which < len(relations):
            name, span = relations[which].name, where(relations[which])
        elif which < len(relations) + len(contacts):
            name, span = contacts[which - len(relations)].name, where(contacts[which - len(relations)])
        else:
            friction = frictions[which - len(relations) - len(contacts)]
            name, span = friction.name, where(friction)
        sink.report("E0881", span, name=name, time=time_text(fault.t))
        return name
    name = names[int(fault.guard)]
    sink.report("E0882", None, name=name, time=time_text(fault.t))
    return name
