"""Equations of motion from SymPy's LagrangesMethod and lambdify."""

from collections.abc import Callable

import sympy as sm
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols


def cart_double_pendulum() -> Callable[..., object]:
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
