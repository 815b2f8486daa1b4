"""The Gymnasium environment of the how-to page keeps the rules of vector environments."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lagdsl

PAGE = Path(__file__).parents[3] / "docs" / "howto" / "step_from_python.md"
LIMIT = np.deg2rad(12.0)


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> type[Any]:
    """The class of the page, with the model beside it."""
    text = PAGE.read_text(encoding="utf-8")
    (model,) = re.findall(r"^```modelica file=cart_pole.lag\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    (code,) = re.findall(r"^```python\n(from gymnasium.*?)^```$", text, re.DOTALL | re.MULTILINE)
    path = tmp_path_factory.mktemp("poles") / "cart_pole.lag"
    path.write_text(model, encoding="utf-8")
    names: dict[str, Any] = {"lagdsl": lagdsl, "np": np}
    exec(compile(code.replace("cart_pole.lag", str(path)), "page", "exec"), names)
    made: type[Any] = names["CartPoles"]
    return made


def test_it_has_thirty_lines() -> None:
    (code,) = re.findall(
        r"^```python\n(from gymnasium.*?)^```$", PAGE.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )
    assert len([line for line in code.split("\n") if line.strip()]) <= 30


def test_episodes_end_and_begin_again(environment: type[Any]) -> None:
    """A pole that has fallen begins again in the next step, which has no reward and takes no notice of the action."""
    poles = environment(num_envs=40)
    state, _ = poles.reset(seed=3)
    assert poles.observation_space.contains(state)
    assert np.abs(state).max() <= 0.05
    over, ended = np.zeros(40, dtype=bool), 0
    for _ in range(60):
        state, reward, fallen, late, _ = poles.step(np.full((40, 1), 10.0))
        assert poles.observation_space.contains(state)
        assert reward.tolist() == (1.0 - over).tolist()
        assert (np.abs(state[over]) <= 0.05).all()
        np.testing.assert_allclose(np.abs(state[fallen, 1]), LIMIT, rtol=1e-6)
        assert (np.abs(state[~fallen, 1]) <= LIMIT).all()
        assert not late.any()
        over, ended = fallen, ended + int(fallen.sum())
    assert ended > 40


def test_a_seed_decides_everything(environment: type[Any]) -> None:
    motions = []
    for _ in range(2):
        poles = environment(num_envs=5)
        poles.reset(seed=7)
        motions.append([poles.step(np.full((5, 1), -3.0))[0].tobytes() for _ in range(30)])
    assert motions[0] == motions[1]
