"""Text to callable NumPy functions, for the comparison with SymPy. A module of its own: the objects of SymPy would be
searched for garbage in the process that is measured."""

from pathlib import Path

import numpy as np

from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.syntax.parser import parse

MODEL = Path(__file__).parents[1] / "models" / "cart_double_pendulum.lag"


def cart_double_pendulum() -> NumpyEngine:
    """From the text to callable NumPy functions, each called once: they are compiled when first called."""
    sink = Sink()
    source = read_source(MODEL, sink)
    assert source is not None
    unit = parse(source, sink)
    assert unit is not None
    flat = flatten(unit, sink)
    sink.raise_if_errors()
    assert flat is not None
    program = arrange(form_equations(flat))
    engine = NumpyEngine(program)
    for function in program.functions:
        arguments = [np.zeros(program.layout.size(group)) for group in function.arguments[1:]]
        engine.evaluate(function.name, 0.0, *arguments)
    return engine
