"""The angular velocity at the start is that of the rotation, whatever the length of the quaternion that states it."""

import numpy as np
import pytest

import lagdsl

TEXT = """model Ship
  parameter Real k = 1;
  coordinate Quaternion e(start = %s, omega(start = {1 rad/s, 2, 3}));
  frame F = world.quat(e);
  gravity = 0;
  body hull(m = 1 kg, I = {1, 2, 3}) on F;
  output AngularVelocity w[3] = {omega(F)*F.x, omega(F)*F.y, omega(F)*F.z};
  output Real used = k;
end Ship;
"""


@pytest.mark.parametrize("start", ["{1, 0, 0, 0}", "{2, 0, 0, 0}", "{2*k, 0, 0, 1.5}", "{k, 0.5, 0, 0}"])
def test_omega_is_in_own_axes_for_any_length(start):
    model = lagdsl.compile(TEXT % start)
    state = model.initial_state()
    assert np.linalg.norm(state.q) == pytest.approx(1, abs=1e-12)
    assert model.output(0.0, state.q, state.qd)[:3] == pytest.approx([1, 2, 3], rel=1e-9)
