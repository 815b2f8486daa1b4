"""Values of the variables of an FMU are those of the functions of the model, by name."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from choice import chosen
from fmpy.simulation import FMICallException
from models.corpus import MODELS, compiled

from fmi.described import table_of_model
from fmi.exported import VERSIONS, Exported, exported, in_versions
from fmi.importing import exchanged
from fmi.test_descriptions import EVERYTHING
from fmi.texts import exported_text
from lagdsl.derivation.program.program import Layout, Slot
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.fmi.variables.names import belonging, named
from lagdsl.language.flat.quantity import Quantity
from lagdsl.motion.pipeline import Compilation, with_names
from lagdsl.motion.simulate.initialize import initial_state

Floats = np.ndarray
BOTH = pytest.mark.parametrize("version", VERSIONS)
# Without constraints, any state is one; with them derivatives of rates are pulled towards them.
FREE = ("cart_double_pendulum", "chain", "van_der_pol", "double_pendulum")
TIED = ("andrews_squeezer", "four_bar", "rolling_coin")
INDEPENDENT = ("four_bar_angles", "knife_edge")  # no row depends on others, and not all of them are solved for
if os.environ.get("LAGDSL_EXPLORE"):
    SMOOTH = [name for name in MODELS if not compiled(name).graph.layout.discretes]
    FREE = tuple(name for name in SMOOTH if not compiled(name).graph.layout.constraints)
    TIED = tuple(name for name in SMOOTH if name not in FREE)
    INDEPENDENT = tuple(
        name
        for name in TIED
        if not any(compiled(name).graph.layout.redundant)
        and len(table_of_model(name, 2).dependent) < len(compiled(name).graph.layout.constraints)
    )


@dataclass
class Meaning:
    """The functions of a model, by the interpreter of its graph."""

    compilation: Compilation

    def __post_init__(self) -> None:
        self.functions = ProgramFunctions(with_names(self.compilation))
        self.layout = self.functions.layout

    def values(self, t: float, x: Floats, u: Floats, p: Floats) -> dict[str, float]:
        n, nc = len(self.layout.coordinates), len(self.layout.constraints)
        q, qd, z = x[:n], x[n : 2 * n], x[2 * n :]
        state = (t, q, qd, z, u, np.zeros(0), p)
        mass, force, jacobian, gamma = self.functions.evaluate("dynamics", *state)
        matrix = np.block([[mass, -jacobian.T], [jacobian, np.zeros((nc, nc))]])
        # The smallest multipliers where rows depend on each other; twice, for the digits of the small ones.
        right = np.concatenate([force, gamma])
        solution = np.linalg.lstsq(matrix, right, rcond=1e-12)[0]
        solution += np.linalg.lstsq(matrix, right - matrix @ solution, rcond=1e-12)[0]
        solved = (*state, solution[:n], solution[n:])
        evaluate = self.functions.evaluate
        found: dict[str, float] = {"time": t}
        self._tell(found, self.layout.coordinates, q)
        self._tell(found, self.layout.coordinates, qd, 1)
        self._tell(found, self.layout.coordinates, solution[:n], 2)
        self._tell(found, self.layout.states, z)
        self._tell(found, self.layout.states, evaluate("state_derivative", *solved)[0], 1)
        self._tell(found, self.layout.inputs, u)
        self._tell(found, self.layout.parameters, p)
        self._tell(found, self.layout.definitions, evaluate("definition", *solved)[0])
        self._tell(found, self.layout.outputs, evaluate("output", *solved)[0])
        for slot, value in zip(self.layout.constraints, solution[n:].tolist(), strict=True):
            found[belonging(slot.name, "multiplier").text] = value
        energies = evaluate("energies", *state)
        found |= {f"energy.{word}": float(e) for word, e in zip(("total", "kinetic", "potential"), energies)}  # noqa: B905
        flat = self.compilation.flat
        hidden = {
            item.name for item in (*flat.parameters, *flat.named) if isinstance(item, Quantity) and item.protected
        }
        return {name: value for name, value in found.items() if name not in hidden}

    @staticmethod
    def _tell(found: dict[str, float], slots: tuple[Slot, ...], values: Floats, order: int = 0) -> None:
        for slot, value in zip(slots, np.asarray(values).tolist(), strict=True):
            found[named(slot.name, order).text] = value


@cache
def meaning(name: str) -> Meaning:
    return Meaning(compiled(name).compilation)


def names_of_x(layout: Layout) -> list[str]:
    """Coordinates, their rates, states."""
    orders = [(slot, order) for order in (0, 1) for slot in layout.coordinates]
    return [named(slot.name, order).text for slot, order in [*orders, *((slot, 0) for slot in layout.states)]]


def close(fmu: Exported, given: dict[str, float], expected: dict[str, float], tolerance: float) -> list[str]:
    """Names of the variables that say something else; sizes are those of values of the same unit, or of multipliers,
    which come from one system of equations."""
    largest: dict[str | None, float] = {}
    units = {name: "multiplier" if ".multiplier" in name else fmu.entry(name)[0].unit for name in expected}
    for name, value in expected.items():
        largest[units[name]] = max(abs(value), largest.get(units[name], 0.0))
    return [
        f"{name}: {given[name]} instead of {value}"
        for name, value in expected.items()
        if not abs(given[name] - value) <= tolerance * (1e-3 + largest[units[name]])
    ]


@in_versions(chosen(TIED + FREE, ("four_bar", "rolling_coin", "chain", "van_der_pol")))
def test_at_the_start(name: str, version: int) -> None:
    told = meaning(name)
    compilation = compiled(name).compilation
    engine = engine_of(compilation.program)
    initial = initial_state(compilation.flat, engine)
    p = np.array(told.layout.defaults)
    u = engine.evaluate("start", initial.t, p)[3]
    expected = told.values(initial.t, np.concatenate([initial.q, initial.qd, initial.z]), u, p)
    fmu = exported(name, version)
    with exchanged(fmu) as instance:
        instance.initialize(start=initial.t)
        given = dict(zip(expected, instance.get(*expected).tolist(), strict=True))
        assert close(fmu, given, expected, 1e-9) == []
        for word in ("position", "velocity") if told.layout.constraints else ():
            assert 0.0 <= instance.get(f"residual.{word}")[0] <= 1e-9
    constants = [each for each in compilation.flat.parameters if each.structural and not each.protected]
    assert all(fmu.entry(named(constant.name).text)[0].variability == "constant" for constant in constants)


@in_versions(chosen(FREE, FREE[:2]))
def test_at_random_states_inputs_and_parameters(name: str, version: int) -> None:
    told, random = meaning(name), np.random.default_rng(7)
    fmu = exported(name, version)
    p = np.array(told.layout.defaults)
    real = [fmu.entry(named(slot.name).text)[0].type in ("Real", "Float64") for slot in told.layout.parameters]
    p *= np.where(real, random.uniform(0.9, 1.1, len(p)), 1.0)
    parameters = {named(slot.name).text: value for slot, value in zip(told.layout.parameters, p.tolist(), strict=True)}
    with exchanged(fmu) as instance:
        instance.initialize(together_by_variable(fmu, parameters))
        instance.update()
        start = instance.states
        for t, far in ((0.3, 1.0), (1.7, 1e-3)):
            x = start + far * random.uniform(-1.0, 1.0, instance.nx)
            u = random.uniform(-1.0, 1.0, len(told.layout.inputs))
            instance.move(t, x)
            inputs = {named(s.name).text: value for s, value in zip(told.layout.inputs, u.tolist(), strict=True)}
            instance.set(together_by_variable(fmu, inputs))
            expected = told.values(t, x, u, p)
            if not np.all(np.isfinite(list(expected.values()))):
                with pytest.raises(FMICallException):
                    instance.get(*expected)
                continue
            given = dict(zip(expected, instance.get(*expected).tolist(), strict=True))
            assert close(fmu, given, expected, 1e-10) == []
            assert instance.derivatives.tolist() == [
                *(given[named(c.name, order).text] for order in (1, 2) for c in told.layout.coordinates),
                *(given[named(state.name, 1).text] for state in told.layout.states),
            ]


@in_versions(chosen(INDEPENDENT, INDEPENDENT[:1]))
def test_off_the_constraints_derivatives_of_rates_alone_are_pulled(name: str, version: int) -> None:
    """All else, reactions too, follows from the accelerations of the model. The pull lets residuals die out."""
    told, random = meaning(name), np.random.default_rng(3)
    compilation = compiled(name).compilation
    engine = engine_of(compilation.program)
    initial = initial_state(compilation.flat, engine)
    p = np.array(told.layout.defaults)
    u = engine.evaluate("start", initial.t, p)[3]
    at = np.concatenate([initial.q, initial.qd, initial.z])
    pulled = [named(coordinate.name, 2).text for coordinate in told.layout.coordinates]
    with exchanged(exported(name, version)) as instance:
        instance.initialize(start=initial.t)
        instance.update()
        x = instance.states
        instance.move(initial.t, x + 1e-3 * (1e-3 + np.max(np.abs(at))) * random.uniform(-1.0, 1.0, len(x)))
        x = instance.get(*names_of_x(told.layout))
        expected = told.values(initial.t, x, u, p)
        own = np.array([expected.pop(each) for each in pulled])
        given = dict(zip(expected, instance.get(*expected).tolist(), strict=True))
        assert close(instance.fmu, given, expected, 1e-9) == []
        difference = instance.get(*pulled) - own
    n = len(pulled)
    state = (initial.t, x[:n], x[n : 2 * n], x[2 * n :], u, np.zeros(0), p)
    phi, _ = told.functions.evaluate("position_constraint", *state)
    residual, rows = told.functions.evaluate("velocity_constraint", *state)
    experiment = compilation.flat.experiment
    rate = 50.0 / (experiment.stop_time - experiment.start_time)
    pull = -np.where(told.layout.position_level, 2.0 * rate * residual + rate**2 * phi, rate * residual)
    assert np.max(np.abs(pull)) > 1e-6
    np.testing.assert_allclose(rows @ difference, pull, rtol=1e-7, atol=1e-9 * np.max(np.abs(pull)))


@BOTH
def test_values_of_every_type(version: int) -> None:
    """Enumerations, whole numbers, truths and constants; what depends on parameters follows them."""
    fmu = exported_text(EVERYTHING, version)
    with exchanged(fmu) as instance:
        instance.initialize({"gear": 1, "teeth": 20, "on": 0, "l": 3.0, "start": 2.0})
        instance.update()
        names = ("gear", "gears[1]", "gears[2]", "built", "n", "pair[2]", "teeth", "on", "twice", "most")
        assert instance.get(*names).tolist() == [1, 1, 2, 1, 2, 2.0, 20, 0, 6.0, np.inf]
        # x starts beyond a meter, which is no crossing
        names = ("x", "up", "hits", "many", "now", "shown", "xi", "energy", "solver")
        assert instance.get(*names).tolist() == [2.0, 1, 0, 1, 1, 1, 3.0, 3.0, 1.0]
        x = instance.states
        x[[0, 4]] = 0.5, 0.2
        instance.move(0.1, x)
        instance.raw.enterEventMode()
        instance.update()
        x[0] = 1.5
        instance.move(0.2, x)
        instance.raw.enterEventMode()
        instance.update()
        assert instance.get("hits", "many", "now", "shown", "xi").tolist() == [1, 2, 2, 2, 0.0]
        assert instance.get("speed", "road", "der(road,2)")[0] == instance.states[4]
    with pytest.raises(Exception), exchanged(fmu) as instance:  # noqa: B017 what fmpy raises
        instance.set({"gear": 3})
    with pytest.raises(Exception), exchanged(fmu) as instance:  # noqa: B017
        instance.set({"teeth": 100})


SMALL = """model Small
  coordinate Real x, y, z; parameter Real e = 1e-12;
  input Real push(start = 1);
  kinetic 1/2*(der(x)^2 + der(y)^2 + der(z)^2);
  force push on x;
  constraint big: x = y;
  constraint small: e*y = e*z;
  annotation(units = "none");
end Small;
"""


@BOTH
def test_multipliers_are_those_of_rows_as_they_are_written(version: int) -> None:
    """The equations multiply the small row; three masses of 1 are pushed by 1."""
    fmu = exported_text(SMALL, version)
    multipliers = ["big.multiplier", "small.multiplier"]
    with exchanged(fmu) as instance:
        instance.initialize()
        instance.update()
        np.testing.assert_allclose(instance.get(*multipliers), [-2 / 3, -1e12 / 3], rtol=1e-12)
        along = instance.directional(multipliers, ["push"], np.ones(1))
        np.testing.assert_allclose(along, [-2 / 3, -1e12 / 3], rtol=1e-12)


@BOTH
def test_parameters_that_make_a_row_look_like_round_off_are_refused(version: int) -> None:
    with pytest.raises(FMICallException), exchanged(exported_text(SMALL, version)) as instance:
        instance.initialize({"e": 1e-30})


def together_by_variable(fmu: Exported, scalars: dict[str, float]) -> dict[str, list[float]]:
    """Values by variable, in the order of their entries."""
    found: dict[str, list[float]] = {}
    for name, value in scalars.items():
        variable, _ = fmu.entry(name)
        found.setdefault(variable.name, []).append(value)
    return found
