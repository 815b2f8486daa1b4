"""A tape and C that is compiled for `auto` give the same bits: which of them computes a motion is not to be seen.

Eight models in every run: contacts, clauses, closed loops, rows left to run time, states, columns; all of them with
LAGDSL_EXPLORE=1, which takes a quarter of an hour.
"""

from __future__ import annotations

import os

import numpy as np
import pytest

from lagdsl.derivation.program.functions import ALONG_MANY
from lagdsl.engines.backends.c.emit import engine_sources
from lagdsl.engines.runtime.building.build import build
from lagdsl.engines.runtime.building.compiler import ALIKE
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from models.corpus import MODELS, compiled, random_states

SOME = ("double_pendulum", "four_bar", "newtons_cradle", "clutch", "pick_and_place", "chain", "valve_train")
CHOSEN = MODELS if os.environ.get("LAGDSL_EXPLORE") else [*SOME, "library/blocks_pid"]


@pytest.mark.parametrize("name", CHOSEN)
def test_every_function_gives_the_same_bits(name: str) -> None:
    program, states = compiled(name).graph, random_states(name)
    tape, c = TapeEngine(program), CEngine(program, build(engine_sources(program), (ALIKE,)))
    for function in program.functions:
        if function.name not in ALONG_MANY:
            arguments = [states[group] for group in function.arguments]
            on_tape, in_c = (engine.evaluate_many(function.name, *arguments) for engine in (tape, c))
            for ours, theirs in zip(on_tape, in_c, strict=True):
                np.testing.assert_array_equal(ours, theirs, err_msg=f"{name}: {function.name}")
