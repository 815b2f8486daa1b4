"""The law of impact: its conditions hold for any mechanism, and no energy is gained."""

from __future__ import annotations

import numpy as np
import pytest
from choice import spread

import lagdsl


@pytest.mark.parametrize("seed", spread(range(40), 5))
def test_impulses_push_and_obey_the_law_of_restitution(seed: int) -> None:
    """A body of random inertia, bound by random rows, that runs into random walls at once."""
    random = np.random.default_rng(seed)
    n, contacts, rows = 6, int(random.integers(1, 6)), int(random.integers(0, 3))
    root = random.normal(size=(n, n))
    mass = root @ root.T + 0.1 * np.eye(n)
    jacobian, normal = random.normal(size=(rows, n)), random.normal(size=(contacts, n))
    rates = random.normal(size=n)
    rates -= np.linalg.lstsq(jacobian, jacobian @ rates, rcond=None)[0]
    normal *= -np.sign(normal @ rates)[:, None]
    if contacts > 2:
        normal[-1] = 0.5 * normal[0] + 0.5 * normal[1]  # a leg too many
    restitution = float(random.uniform(0.1, 1.0))
    motion = lagdsl.compile(_walls(mass, jacobian, normal, rates, restitution)).simulate(stop=1e-6)
    after = np.array([motion[f"der(q{i})"][0] for i in range(n)])

    assert {event.kind for event in motion.events if event.time == 0.0} == {"impact"}
    assert np.allclose(jacobian @ after, 0.0, atol=1e-10)
    left = normal @ after + restitution * (normal @ rates)
    assert np.min(left) > -1e-9
    # what pushes is met: the impulse is that of contacts with left = 0 alone
    active = np.flatnonzero(left < 1e-9)
    forces = np.concatenate([normal[active], jacobian]).T
    impulse = mass @ (after - rates)
    parts = np.linalg.lstsq(forces, impulse, rcond=None)[0]
    assert np.allclose(forces @ parts, impulse, atol=1e-8)
    if len(active) and contacts < 3:
        assert np.min(parts[: len(active)]) > -1e-8
    assert after @ mass @ after <= rates @ mass @ rates * (1.0 + 1e-12)


def _walls(mass: np.ndarray, jacobian: np.ndarray, normal: np.ndarray, rates: np.ndarray, restitution: float) -> str:
    """A model in numbers without units: at q = 0, where the walls `normal` q >= 0 meet."""
    names = [f"q{i}" for i in range(len(rates))]

    def line(row: np.ndarray, pattern: str = "{}") -> str:
        return " + ".join(
            f"({value!r})*{pattern.format(name)}" for value, name in zip(row.tolist(), names, strict=True)
        )

    starts = zip(names, rates.tolist(), strict=True)
    coordinates = ", ".join(f"{name}(der(start = {rate!r}, fixed = true))" for name, rate in starts)
    energy = " + ".join(f"der({name})*({line(row, 'der({})')})" for name, row in zip(names, mass, strict=True))
    constraints = "".join(f"  constraint c{k}: {line(row)} = 0;\n" for k, row in enumerate(jacobian))
    contacts = "".join(
        f"  contact w{k}: {line(row)} >= 0 with restitution = {restitution!r};\n" for k, row in enumerate(normal)
    )
    return (
        f"model Walls\n  coordinate Real {coordinates};\n  gravity = 0;\n  kinetic 1/2*({energy});\n"
        f'{constraints}{contacts}  annotation(units = "none");\nend Walls;\n'
    )


@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_a_compliant_contact_loses_two_thirds_of_c_v(exponent: float) -> None:
    """Hunt, Crossley (1975): e = 1 - 2/3 c v for small c v, whatever the stiffness and the exponent."""
    text = f"""
    model Bumper
      coordinate Length x(start = 1 cm, der(start = -0.5 m/s));
      kinetic 1/2*(2 kg)*der(x)^2;
      contact wall: x >= 0 with compliance = 3e4, damping = 0.02 s/m, exponent = {exponent};
    end Bumper;
    """
    motion = lagdsl.compile(text).simulate(stop=0.5, tolerance=1e-11)
    assert motion["der(x)"][-1] / 0.5 == pytest.approx(1.0 - 2.0 / 3.0 * 0.01, abs=0.01**2)


def test_what_friction_would_hold_creeps_by_the_speed_of_regularization() -> None:
    text = """
    model Block
      parameter Real mu = 0.5;
      parameter Angle slope = 20 deg;
      parameter Velocity v_0 = 1 mm/s;
      coordinate Length s;
      gravity = -g_n*world.y;
      mass 1 kg at {s*cos(slope), -s*sin(slope)};
      force -mu*(1 kg)*g_n*cos(slope)*tanh(der(s)/v_0) on s;
    end Block;
    """
    motion = lagdsl.compile(text).simulate(stop=1.0)
    assert motion["der(s)"][-1] == pytest.approx(1e-3 * np.arctanh(np.tan(np.radians(20.0)) / 0.5), rel=1e-6)
