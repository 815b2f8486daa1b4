"""Derivatives along implicit steps: equations of stages are solved by corrections for few columns, else decomposed."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl

MASSES = 20


def _row_of_masses() -> lagdsl.Model:
    """Masses between springs that stiffen; the first is out of place."""
    parts = ["model Row", "parameter Stiffness k = 1e6 N/m;", "parameter Damping c = 50 N.s/m;"]
    parts += ['parameter Real e(unit = "N/m3") = 1e9;', "gravity = 0;"]
    for i in range(MASSES):
        before = f"x{i - 1}" if i > 0 else "0 m"
        parts += [f"parameter Mass m{i} = 0.1 kg;", f"coordinate Length x{i}(start = {0.001 * (i == 0)} m);"]
        parts += [f"kinetic m{i}/2*der(x{i})^2;", f"dissipation c/2*der(x{i})^2;"]
        parts += [f"potential k/2*(x{i} - ({before}))^2 + e/4*(x{i} - ({before}))^4;"]
    return lagdsl.compile("\n".join([*parts, "end Row;"]))


def test_both_ways_to_solve_the_equations_of_stages_agree() -> None:
    model = _row_of_masses()
    names = list(model.parameters)[:11]
    options = {"stop": 0.01, "interval": 0.0007, "solver": "radau", "tolerance": 1e-8}
    together = model.simulate(tangents=names, **options)
    for name in names[:4]:
        alone = model.simulate(tangents=[name], **options)
        for of in ("x0", "x1", "der(x5)"):
            expected = alone.derivative(of, name)
            size = np.abs(expected).max()
            np.testing.assert_allclose(together.derivative(of, name), expected, rtol=0, atol=1e-11 * size)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
def test_neighbours_of_a_motion_at_rest_oscillate(tolerance: float) -> None:
    """Closed form: dx/dx0 = cos(w t). The state is at rest, so its steps could be as long as the run."""
    model = lagdsl.compile("""
        model Rest
          coordinate Length x, fast;
          mass 1 kg at {x, 0};
          mass 1 kg at {0, fast};
          force -(4 N/m)*x on x;
          force -(1e8 N/m)*fast - (1e6 N.s/m)*der(fast) on fast;
        end Rest;
    """)
    motion = model.simulate(stop=10, solver="radau", tolerance=tolerance, tangents=["x.start"])
    found = motion.derivative("x", "x.start")
    assert np.abs(found - np.cos(2.0 * motion.time)).max() < 60.0 * tolerance


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
def test_columns_are_known_between_the_nodes_of_a_step(tolerance: float) -> None:
    """Closed form: z follows a sin(t), so dz/da is sin(t); a is zero, and z stays at rest."""
    model = lagdsl.compile("""
        model Follower
          parameter Real a = 0;
          state Real z;
          coordinate Length x;
          mass 1 kg at {x, 0};
        equation
          der(z) = 1e6*(a*sin(time/(1 s)) - z)/(1 s);
        end Follower;
    """)
    motion = model.simulate(stop=10, solver="radau", tolerance=tolerance, tangents=["a"])
    found = motion.derivative("z", "a")
    assert np.abs(found - np.sin(motion.time))[1:].max() < 1e-6 + 60.0 * tolerance
