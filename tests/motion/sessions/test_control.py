"""Controllers in Python: the exact discrete motion of a sampled loop, several rates, the loop by hand."""

from __future__ import annotations

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

# x'' = F/m
AXIS = """
model Axis
  parameter Mass m = 2 kg;
  coordinate Length x(start = 1 m);
  input Force F(max = 9 N), G;
  mass m at {x, 0};
  force (F + G)*world.x at {x, 0};
end Axis;
"""
KP, KD, H = 20.0, 6.0, 0.01


def pd(now: lagdsl.Present) -> dict[str, float]:
    return {"F": -KP * float(now["x"]) - KD * float(now["der(x)"])}


def exact(count: int, m: float = 2.0) -> np.ndarray:
    """(x, v) at every tick: x+ = x + h v + h^2/(2 m) F, v+ = v + h/m F with F = -KP x - KD v."""
    step = np.array([[1.0, H], [0.0, 1.0]]) - np.outer([H * H / (2.0 * m), H / m], [KP, KD])
    return np.array([np.linalg.matrix_power(step, k) @ [1.0, 0.0] for k in range(count + 1)])


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy", "auto"]))
def test_a_sampled_loop_is_its_discrete_solution(engine: EngineName) -> None:
    model = lagdsl.compile(AXIS, engine=engine)
    motion = model.simulate(stop=1.0, interval=H, control=lagdsl.control(every="10 ms", function=pd))
    np.testing.assert_allclose(motion["x"], exact(100)[:, 0], atol=1e-12)
    np.testing.assert_allclose(motion["der(x)"], exact(100)[:, 1], atol=1e-12)


def test_the_loop_by_hand_is_the_same() -> None:
    run = lagdsl.compile(AXIS, engine="tape").session()
    for k in range(100):
        np.testing.assert_allclose([run["x"], run["der(x)"]], exact(100)[k], atol=1e-12)
        run.step(H, u=pd(run))


def test_controllers_at_several_rates() -> None:
    """F counts its calls, G every third tick of F: the force jumps where they say so."""
    said: list[tuple[str, float]] = []

    def fast(now: lagdsl.Present) -> dict[str, float]:
        said.append(("F", now.t))
        return {"F": 1.0}

    def slow(now: lagdsl.Present) -> dict[str, str] | None:
        said.append(("G", now.t))
        return {"G": "3 N"} if now.t > 0.2 else None

    model = lagdsl.compile(AXIS, engine="tape")
    motion = model.simulate(stop=0.5, interval=0.5, control=[lagdsl.control(0.1, fast), lagdsl.control(0.3, slow)])
    assert said == [("F", 0.0), ("G", 0.0), ("F", 0.1), ("F", 0.2), ("F", 0.3), ("G", 0.3), ("F", 0.4)]
    assert motion["der(x)"][-1] == pytest.approx(0.5 * 0.5 + 1.5 * 0.2, rel=1e-12)
    calls = len(said)
    assert len(motion.drawn(smooth=True)) > 2  # the same motion with more rows
    assert len(said) == calls


def test_a_controller_with_a_memory_is_asked_once() -> None:
    """It says k at its call number k: v = h/m (0 + 1 + ... ). A spring beside it turns so often that simulate makes the
    motion a second time, with more rows."""
    calls = [0]

    def counting(now: lagdsl.Present) -> dict[str, float]:
        calls[0] += 1
        return {"F": calls[0] - 1.0}

    text = AXIS.replace(
        "end Axis", "coordinate Length y(start = 1 m); kinetic 1 kg*der(y)^2; potential 5 kN/m*y^2; end Axis"
    )
    motion = lagdsl.compile(text, engine="tape").simulate(stop=10.0, control=lagdsl.control("0.1 s", counting))
    assert len(motion) > 502
    assert calls[0] == 100
    assert motion["der(x)"][-1] == pytest.approx(0.05 * 99 * 100 / 2, rel=1e-12)


def test_the_inputs_of_a_failure_are_those_of_the_controller() -> None:
    def raising(now: lagdsl.Present) -> float:
        raise RuntimeError("no idea")

    model = lagdsl.compile(AXIS, engine="tape")
    with pytest.raises(RuntimeError, match="no idea"):
        model.simulate(stop=1.0, control=lagdsl.control(0.1, raising))
    with pytest.raises(lagdsl.CallRefused, match=r"E0893.*2 inputs"):
        model.simulate(stop=1.0, control=lagdsl.control(0.1, lambda now: 1.0))
    with pytest.raises(lagdsl.UnknownName, match="E0874"):
        model.simulate(stop=1.0, control=lagdsl.control(0.1, lambda now: {"H": 1.0}))
    for every in (0.0, "2 kg", "-1 s", float("nan")):
        with pytest.raises(lagdsl.CallRefused, match="E0896"):
            lagdsl.control(every, pd)
    with pytest.raises(lagdsl.CallRefused, match=r"E0893.*no function"):
        lagdsl.control(0.1, 3.0)  # type: ignore[arg-type]


def test_a_controlled_motion_has_no_page() -> None:
    motion = lagdsl.compile(AXIS, engine="tape").simulate(stop=0.1, control=lagdsl.control(0.05, pd))
    with pytest.raises(lagdsl.CallRefused, match="E0897"):
        motion.show()
