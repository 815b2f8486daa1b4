"""The same equations from SymPy's LagrangesMethod and lambdify, in the same run."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import sympy as sm
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.arrange import arrange
from lagdsl.mechanics.equations import form_equations
from lagdsl.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.semantics.classes.library import read_source
from lagdsl.semantics.flatten import flatten
from lagdsl.syntax.parser import parse

MODEL = Path(__file__).parents[1] / "models" / "cart_double_pendulum.lag"


def lagdsl_cart_double_pendulum() -> NumpyEngine:
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


def sympy_cart_double_pendulum() -> Callable[..., object]:
    """As SymPy's documentation does it: T - V, LagrangesMethod, lambdify of mass matrix and forcing."""
    time = dynamicsymbols._t
    x, a, b = q = list(dynamicsymbols("x a b"))
    rates = [coordinate.diff(time) for coordinate in q]
    cart, m1, m2, l1, l2, g, c, u = parameters = sm.symbols("M m1 m2 l1 l2 g c u", positive=True)
    x1, y1 = x + l1 * sm.sin(a), -l1 * sm.cos(a)
    x2, y2 = x1 + l2 * sm.sin(b), y1 - l2 * sm.cos(b)
    kinetic = cart * rates[0] ** 2 / 2
    potential = sm.S.Zero
    for mass, px, py in ((m1, x1, y1), (m2, x2, y2)):
        kinetic += mass * (px.diff(time) ** 2 + py.diff(time) ** 2) / 2
        potential += mass * g * py
    frame = sm.physics.mechanics.ReferenceFrame("N")
    hook = sm.physics.mechanics.Point("C")
    hook.set_vel(frame, rates[0] * frame.x)
    method = LagrangesMethod(kinetic - potential, q, forcelist=[(hook, (u - c * rates[0]) * frame.x)], frame=frame)
    method.form_lagranges_equations()
    return sm.lambdify([q, rates, parameters], [method.mass_matrix, method.forcing], cse=True)


def chain(n: int) -> Callable[..., object]:
    """The same for the planar chain of n bars in angles between neighbors: models/planar_chain.lag."""
    time = dynamicsymbols._t
    q = list(dynamicsymbols(f"q0:{n}"))
    m, length, g = parameters = sm.symbols("m l g", positive=True)
    kinetic = potential = angle = x = y = sm.S.Zero
    for coordinate in q:
        angle += coordinate
        cx, cy = x + length * sm.cos(angle) / 2, y + length * sm.sin(angle) / 2
        kinetic += m * (cx.diff(time) ** 2 + cy.diff(time) ** 2) / 2 + m * length**2 / 24 * angle.diff(time) ** 2
        potential -= m * g * cx
        x, y = x + length * sm.cos(angle), y + length * sm.sin(angle)
    method = LagrangesMethod(kinetic - potential, q)
    method.form_lagranges_equations()
    rates = [coordinate.diff(time) for coordinate in q]
    return sm.lambdify([q, rates, parameters], [method.mass_matrix, method.forcing], cse=True)
