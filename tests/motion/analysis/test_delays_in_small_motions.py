"""Small motions of a model with delays: frequency responses are those of exp(-sT); all that needs a finite state is
refused with a reason."""

from __future__ import annotations

import numpy as np
import pytest
from choice import together

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

TEXT = """
model Signals
  parameter Time T = 1 s;
  input Real u = 0;
  state Real y(start = 0), z(start = 0);
  Real echo = u - 0.5*delay(echo, 0.4 s);
  output Real through = delay(z, 0.3 s) + delay(delay(u, 0.2 s), 0.5 s);
  output Real bend = der(der(z))*(1 s2);
  output Real back = echo;
equation
  der(y) = (u - delay(y, T))/(1 s);
  der(z) = (delay(y, 0.5*T) - z)/(1 s);
end Signals;
"""
CART = """
model Cart
  input Force F = 0 N;
  coordinate Length x;
  mass 2 kg at {x, 0};
  force (F - delay(x, 0.5 s)*(1 N/m) - delay(der(x), 0.5 s)*(1 N.s/m))*world.x at {x, 0};
  output Length far = delay(x, 0.1 s);
end Cart;
"""


def test_a_delay_is_exact_in_a_frequency_response() -> None:
    hertz = np.array([0.01, 0.1, 0.5, 2.0, 30.0])
    s = 2j * np.pi * hertz
    y = 1.0 / (s + np.exp(-s))
    z = y * np.exp(-0.5 * s) / (s + 1.0)
    exact = {
        "y": y,
        "through": z * np.exp(-0.3 * s) + np.exp(-0.7 * s),
        "bend": s**2 * z,
        "back": 1.0 / (1.0 + 0.5 * np.exp(-0.4 * s)),
    }
    model = lagdsl.compile(TEXT, engine="tape")
    for name, response in exact.items():
        found = model.bode("u", name, frequencies=hertz)
        assert found.response == pytest.approx(response, rel=1e-12)
        assert found.transfer is None and found.margins is None


def test_frequencies_show_what_there_is() -> None:
    found = lagdsl.compile(CART, engine="tape").bode()
    s = 2j * np.pi * found.frequencies
    assert found.response == pytest.approx(np.exp(-0.1 * s) / (2 * s**2 + (s + 1.0) * np.exp(-0.5 * s)), rel=1e-10)
    assert found.frequencies[0] < 0.02 and found.frequencies[-1] > 10.0


@together("asked", ["linearize", "modes", "trim", "bode"])
def test_what_needs_a_finite_state_is_refused(asked: str) -> None:
    with pytest.raises(CompilationFailed, match="E0868"):
        getattr(lagdsl.compile(CART, engine="tape"), asked)(**({"every": "10 ms"} if asked == "bode" else {}))
