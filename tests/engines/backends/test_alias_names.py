"""Modules in Python take every name of a merged coordinate."""

from __future__ import annotations

import numpy as np
import pytest
from fmi.described import of_text

from lagdsl.engines.backends.python.emit import module

SHAFT = """
model Shaft
  import Lag.Rotational.*;
  Rotor motor(J = 2 kg.m2), load(J = 1 kg.m2);
  Spring shaft(k = 6 N.m/rad);
  connect(motor.phi, shaft.phi_a);
  connect(shaft.phi_b, load.phi);
end Shaft;
"""


def test_a_module_takes_other_names_of_coordinates():
    names: dict = {}
    exec(compile(module(of_text(SHAFT).program), "shaft.py", "exec"), names)
    assert names["ALIASES"] == {"shaft.phi_a": "motor.phi", "shaft.phi_b": "load.phi"}
    at_rest = {"shaft.phi_a": 0.0, "load.phi": 0.0}
    found = names["forward_dynamics"](0.0, {"shaft.phi_a": 0.3, "shaft.phi_b": 0.0}, at_rest)
    assert np.allclose(found, [-0.9, 1.8])
    with pytest.raises(ValueError, match=r"`motor\.phi` is given twice"):
        names["forward_dynamics"](0.0, {"shaft.phi_a": 0.3, "motor.phi": 0.0}, at_rest)
