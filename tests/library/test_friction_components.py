"""Components with dry friction stick, or have the smooth law where they get a velocity scale. One-way parts, worms."""

from __future__ import annotations

import numpy as np
import pytest
from choice import chosen
from models.corpus import path_of
from models.references import REFERENCES
from models.references.integrate import G_N

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

SHAFTS = """model Shafts
  import Lag.{package}.*;
  {body} a({m} = 2, {x}(der(start = 10))), b({m} = 3, {x}(der(start = 4))), c({m} = 1, {x}(der(start = 5)));
  Clutch clutch({f}_max = 6{scale});
  Brake brake({f}_max = 3{scale});
  CoulombFriction bearing({f}_c = 0.5{scale});
  connect(a.{x}, clutch.{x}_a);
  connect(b.{x}, clutch.{x}_b);
  connect(c.{x}, brake.{x}, bearing.{x});
  output Real rates[3](unit = "{unit}") = {{der(a.{x}), der(b.{x}), der(c.{x})}};
end Shafts;
"""
NAMES = {
    "Rotational": {"body": "Rotor", "m": "J", "x": "phi", "f": "tau", "unit": "rad/s", "v_0": "w_0"},
    "Translational": {"body": "SlidingMass", "m": "m", "x": "s", "f": "f", "unit": "m/s", "v_0": "v_0"},
}


@pytest.mark.parametrize("engine", chosen(["tape", "c", "numpy"], ["tape"]))
@pytest.mark.parametrize("name", ["brakes_and_clutches", "freewheels", "journals", "worm_hoist", "stick_slip"])
def test_parts_stick_slide_and_lock_as_derived(name: str, engine: EngineName) -> None:
    model = lagdsl.compile(path_of(f"library/{name}"), engine=engine)
    motion = model.simulate(tolerance=1e-10)
    for column, expected in REFERENCES[name](
        dict(zip(model.parameters, model.defaults, strict=True)), motion.time
    ).items():
        np.testing.assert_allclose(
            motion[column], expected, rtol=0, atol=1e-9 * np.max(np.abs(expected)), err_msg=column
        )


def _shafts(package: str, scale: float) -> lagdsl.Trajectory:
    names = NAMES[package]
    text = SHAFTS.format(package=package, scale=f", {names['v_0']} = {scale}" if scale else "", **names)
    return lagdsl.compile(text, engine="tape").simulate(stop=4.0, tolerance=1e-11)


@pytest.mark.parametrize("package", NAMES)
def test_without_a_scale_the_slip_ends(package: str) -> None:
    """The slip of a and b falls by 6 (1/2 + 1/3) a second, c by 3.5."""
    motion = _shafts(package, 0.0)
    slip = np.maximum(6 - 5 * motion.time, 0.0)
    np.testing.assert_allclose(motion["rates[1]"] - motion["rates[2]"], slip, atol=1e-12)
    np.testing.assert_allclose(motion["rates[3]"], np.maximum(5 - 3.5 * motion.time, 0.0), atol=1e-12)
    assert sum(event.kind == "sticks" for event in motion.events) == 3  # brake and bearing at one instant


@pytest.mark.parametrize("package", NAMES)
def test_with_a_scale_it_fades(package: str) -> None:
    """v' = -r tanh(v/v_0): sinh(v/v_0) is an exponential; nothing is located."""
    scale = 0.8
    motion = _shafts(package, scale)
    for value, start, rate in (
        (motion["rates[1]"] - motion["rates[2]"], 6.0, 5.0),
        (motion["rates[3]"], 5.0, 3.5),
    ):
        expected = scale * np.arcsinh(np.sinh(start / scale) * np.exp(-rate / scale * motion.time))
        np.testing.assert_allclose(value, expected, atol=1e-8)
    assert not motion.events


def test_a_limit_at_rest_is_refused_where_nothing_rests() -> None:
    with pytest.raises(lagdsl.CompilationFailed, match="E0223"):
        lagdsl.compile(SHAFTS.format(package="Rotational", scale=", w_0 = 1, tau_stick = 7", **NAMES["Rotational"]))


WORM = """model Worm
  import Lag.Rotational.*;
  Rotor a(J = 0.01), b(J = 3);
  TorqueSource drive(tau = 0.2), load(tau = -40);
  WormGear gear(ratio = -8, lead = 15 deg, mu = {mu}, alpha = 20 deg);
  connect(a.phi, gear.phi_a, drive.phi);
  connect(b.phi, gear.phi_b, load.phi);
  output Boolean locked = sticks(gear.flanks);
end Worm;
"""


def test_a_steep_worm_is_driven_back_by_its_wheel() -> None:
    """Power goes from the wheel to the worm with the efficiency tan(lead - rho)/tan(lead)."""
    motion = lagdsl.compile(WORM.format(mu=0.1), engine="tape").simulate(stop=1.0)
    rho = np.arctan(0.1 / np.cos(np.radians(20)))
    lead = np.radians(15)
    efficiency = np.tan(lead - rho) / np.tan(lead)
    # wheel: 3 w' = -40 - T; worm: 0.01 (-8) w' = 0.2 + T efficiency/(-8), with T the torque of the gear on the wheel
    rate, _ = np.linalg.solve([[3.0, -1.0], [-0.08, -efficiency / 8]], [-40.0, 0.2])
    assert rate < 0
    assert motion["der(b.phi)"][-1] == pytest.approx(rate, rel=1e-9)
    assert motion["locked"][-1] == 0.0


def test_a_worm_of_much_friction_locks() -> None:
    motion = lagdsl.compile(WORM.format(mu=0.3), engine="tape").simulate(stop=1.0)
    assert np.max(np.abs(motion["a.phi"])) <= 1e-12
    assert motion["locked"][-1] == 1.0


SLOPE = """model Slope
  parameter Velocity v = {v};
  coordinate Length x(der(start = v)), y(start = -2e-3){third};
  gravity = {{5 m/s2, -8 m/s2{weight}}};
  mass 0.5 kg at {{x, y{place}}};
  Lag.Forces.PlaneContact ground(a = {{x, y{place}}}, b = world.origin, k = 2000, d = 1, mu = 0.8);
  output Boolean held = sticks(ground.dry);
end Slope;
"""


@pytest.mark.parametrize("space", [False, True])
def test_a_particle_on_a_soft_plane_slides_stops_and_stays(space: bool) -> None:
    """N = 4 N at the penetration of 2 mm: it brakes with 0.8*8 - 5 = 1.4 m/s2, or holds 5 of 6.4 m/s2 up to 100 s."""
    third = {"third": ", z" if space else "", "weight": ", 0" if space else "", "place": ", z" if space else ""}
    model = lagdsl.compile(SLOPE.format(v="0.7 m/s", **third), engine="tape")
    motion = model.simulate(stop=2.0, tolerance=1e-11)
    (told,) = motion.events
    assert (told.kind, told.name) == ("sticks", "ground.dry")
    assert told.time == pytest.approx(0.5, rel=1e-7)
    assert motion["x"][-1] == pytest.approx(0.175, rel=1e-9)
    stays = model.simulate(parameters={"v": 0.0}, stop=100.0)
    assert np.max(np.abs(stays["x"])) <= 1e-12
    assert stays["held"][0] == stays["held"][-1] == 1.0


GUIDE = """model Guide
  coordinate Length x(der(start = 3 m/s)), y;
  gravity = -g_n*world.y;
  mass 2 kg at {x, y};
  constraint rail: y = 0;
  Lag.Forces.SlidingFriction shoe(s = x, N = abs(multiplier(rail)), mu = 0.25);
end Guide;
"""


def test_a_shoe_is_pressed_by_its_guide() -> None:
    motion = lagdsl.compile(GUIDE, engine="tape").simulate(stop=2.0)
    assert motion["x"][-1] == pytest.approx(3.0**2 / (2 * 0.25 * G_N), rel=1e-9)
