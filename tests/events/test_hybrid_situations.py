"""A reader of docs/explanation/hybrid_model.md alone tells what happens in these situations and which file decides."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest
from choice import paired
from events.situations import SITUATIONS, WEDGING, Situation

import lagdsl

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "explanation" / "hybrid_model.md").read_text(encoding="utf-8")
RUNS: dict[str, dict[str, Any]] = {
    "coarse": {"tolerance": 1e-3},
    "1e-6": {"tolerance": 1e-6},
    "default": {},
    "fine": {"tolerance": 1e-10},
    "radau": {"solver": "radau"},
    "rk4": {"solver": "rk4", "step": 0.01},
    "rk4_odd": {"solver": "rk4", "step": 0.0137},
}
EVEN = WEDGING.text.replace("1000", "3").replace("force -1 on h;", "force -1 on h; force time on x;")  # steps grow
BY_NAME = {situation.name: situation for situation in SITUATIONS}


@cache
def compiled(name: str) -> lagdsl.Model:
    return lagdsl.compile(BY_NAME[name].text, engine="tape")


def happened(motion: lagdsl.Trajectory, situation: Situation) -> list[tuple[str, str, float]]:
    return sorted((e.name, e.kind, e.time) for e in motion.events if e.kind not in situation.besides)


@pytest.mark.parametrize(("name", "run"), paired(list(BY_NAME), list(RUNS)))
def test_what_happens(name: str, run: str) -> None:
    situation = BY_NAME[name]
    if situation.adaptive_only and run.startswith("rk4"):
        run = "default"
    near = {"rk4": situation.fixed, "coarse": situation.coarse}.get(run.removesuffix("_odd")) or situation.near
    motion = compiled(name).simulate(stop=situation.stop, **RUNS[run])
    found = happened(motion, situation)
    expected = sorted((what, kind, time) for time, what, kind in situation.events)
    assert [each[:2] for each in found] == [each[:2] for each in expected]
    assert [each[2] for each in found] == pytest.approx([each[2] for each in expected], rel=0.0, abs=near)
    assert {column: motion[column][-1] for column in situation.ends} == pytest.approx(situation.ends, rel=0.0, abs=near)


@pytest.mark.parametrize("text", [WEDGING.text, EVEN], ids=["fast", "even"])
@pytest.mark.parametrize("run", ["coarse", "1e-6", "default", "fine", "radau"])
def test_wedging_ends_the_motion_at_its_instant(run: str, text: str) -> None:
    with pytest.raises(lagdsl.SimulationFailed) as failure:
        lagdsl.compile(text, engine="tape").simulate(stop=WEDGING.stop, **RUNS[run])
    assert failure.value.diagnostic.code == "E0843"
    assert "at t = 2 s," in failure.value.diagnostic.message


@pytest.mark.parametrize("situation", [*SITUATIONS, WEDGING], ids=lambda each: each.name)
def test_the_page_names_the_file_that_decides(situation: Situation) -> None:
    assert (ROOT / "lagdsl" / "engines" / "runtime" / "c" / "lag" / situation.decides).is_file()
    assert f"`{situation.decides}`" in PAGE
