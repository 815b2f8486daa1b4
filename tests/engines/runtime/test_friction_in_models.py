"""Every filling of lag_model tells friction, contacts of rates and loads with feedback alike, and computes the same."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import pytest
from choice import chosen
from compiled_programs import program_of
from friction_texts import ALL

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.engines.runtime.structures import WHAT, Model
from lagdsl.exchange.verify.states import values

ENGINES: tuple[EngineName, ...] = ("tape", "c", "numpy")
KINDS = (
    *("variable", "contact", "impacts", "sticks", "direction", "relation", "timed"),
    *("delay", "delay_rate", "condition", "clock", "initial", "terminal", "load"),
)


def rows(address: int | None, count: int, kind: Any) -> list[int]:
    return list((kind * count).from_address(address)) if address else []


def told(program: Program, engine: EngineName) -> dict[str, Any]:
    """Data of friction in the model."""
    held = engine_of(program, engine)
    model = Model.from_address(held.native.address)
    counts = {name: getattr(model, name) for name in ("nslip", "nfriction", "nload", "ncontact", "nw")}
    size = ctypes.c_size_t
    return counts | {
        "kinds": [KINDS[kind] for kind in rows(model.kinds, model.nw, ctypes.c_ubyte)],
        "friction_rows": rows(model.friction_rows, model.nslip, size),
        "friction_slips": rows(model.friction_slips, model.nfriction, size),
        "friction_contacts": rows(model.friction_contacts, model.nfriction, size),
        "one_way": rows(model.one_way, model.ncontact, ctypes.c_ubyte),
        "there": {name for name in ("friction", "load") if getattr(model, name)},
    }


@pytest.mark.parametrize("engine", ENGINES)
def test_a_model_tells_its_friction(engine: EngineName) -> None:
    expected = {
        "puck": (("contact impacts sticks direction direction load", [1, 2], [2], [1], []), {"friction", "load"}),
        "slope": (("contact impacts sticks direction load", [1], [1], [0], []), {"friction", "load"}),
        "freewheel": (("contact impacts", [], [], [], [1]), set()),
    }
    for name, (data, there) in expected.items():
        found = told(program_of(ALL[name]), engine)
        kinds = " ".join(found["kinds"])
        rows = [found[key] for key in ("friction_rows", "friction_slips", "friction_contacts", "one_way")]
        assert (kinds, *rows) == data, name
        assert found["there"] == there, name
        assert (found["nslip"], found["nfriction"]) == (len(data[1]), len(data[2])), name


@pytest.mark.parametrize(
    ("engine", "name"),
    chosen([(e, n) for e in ENGINES for n in ALL], [("c", "puck"), *(("tape", n) for n in ALL), ("numpy", "slope")]),
)
def test_all_functions_are_those_of_the_interpreter(engine: EngineName, name: str) -> None:
    program = program_of(ALL[name])
    layout, random = program.layout, np.random.default_rng(5)
    held = engine_of(program, engine)
    state = {group: random.normal(size=layout.size(group)) for group in Group if not group.name.startswith("RELEASE")}
    state[Group.TIME] = np.array(0.3)
    whole = [kind not in ("direction", "load") for kind in layout.kinds]
    for _ in range(3):
        state[Group.W] = np.where(whole, random.integers(0, 2, len(whole)), random.normal(size=len(whole)))
        for function in program.functions:
            if function.name not in ("acceleration_tangent",):
                arguments = [float(state[Group.TIME]), *(state[each] for each in function.arguments[1:])]
                found = held.evaluate(function.name, *arguments)
                for one, other in zip(found, values(program, function.name, state), strict=True):
                    np.testing.assert_allclose(one, np.real(other), rtol=1e-12, atol=1e-12, err_msg=function.name)


def test_events_of_friction_have_names() -> None:
    assert WHAT[-4:] == ("slips", "sticks", "reverses", "warning")
