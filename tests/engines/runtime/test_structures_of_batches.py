"""A batch has every pointer that the runtime reads: ctypes keeps an attribute that is no field without a word."""

from __future__ import annotations

import numpy as np

import lagdsl
from lagdsl.engines.runtime.structures import Batch

PENDULUM = "model P coordinate Angle q; kinetic (1 kg.m2)*der(q)^2; potential (1 J)*(1 - cos(q)); end P;"


def test_every_buffer_of_an_engine_is_a_field_of_a_batch() -> None:
    model = lagdsl.compile(PENDULUM, engine="tape")
    own = vars(model._engine._one.buffers)  # type: ignore[attr-defined]
    assert set(own) <= {name for name, _ in Batch._fields_}


def test_jacobians_of_many_states_are_those_of_one() -> None:
    model = lagdsl.compile(PENDULUM, engine="tape")
    q = np.linspace(-1.0, 1.0, 300)[:, None]
    many = model.state_jacobian(0.0, q, np.zeros(1))
    assert np.allclose(many[:, 1, 0], -np.cos(q[:, 0]) / 2)
