"""The engine `auto`: a tape at once, C where it pays or lies in the cache, the same numbers from both."""

from __future__ import annotations

import gc
import time
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.engines import auto_engine
from lagdsl.engines.runtime.engines.auto_engine import AutoEngine
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine

PENDULUM = """model Pendulum
  parameter Mass m = 1 kg;
  parameter Length l = 1 m;
  coordinate Angle theta(start = 1 rad);
  lagrangian 0.5*m*l^2*der(theta)^2 + m*9.81 m/s^2*l*cos(theta);
end Pendulum;
"""
NOTHING = (np.zeros(0),) * 3


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("CC", raising=False)


def _auto() -> AutoEngine:
    engine = lagdsl.compile(PENDULUM)._engine
    assert isinstance(engine, AutoEngine)
    return engine


def _accelerations(engine: CEngine) -> bytes:
    q = np.linspace(-3.0, 3.0, 64)[:, None]
    return engine.solve_many(np.zeros(64), q, 2.0 * q, *NOTHING, np.array([1.25, 0.7]))[0].tobytes()


def _finished(engine: AutoEngine) -> bool:
    """True if there is C within half a minute."""
    end = time.monotonic() + 30.0
    while time.monotonic() < end:
        if engine.hasten() is not None:
            return True
        time.sleep(0.01)
    return False


@pytest.mark.parametrize(
    ("name", "kind"), [("auto", AutoEngine), ("tape", TapeEngine), ("c", CEngine), ("numpy", NumpyEngine)]
)
def test_engines_have_the_names_that_choose_them(
    name: lagdsl.engines.runtime.engines.engine.EngineName, kind: type
) -> None:
    engine = lagdsl.compile(PENDULUM, engine=name)._engine
    assert type(engine) is kind
    assert engine.name == name


def test_little_work_is_done_on_the_tape() -> None:
    engine = _auto()
    engine.worked(1e-3, left=1e-2)
    assert engine.hasten() is None
    assert not engine.is_compiled
    assert not cache_folder().exists() or list(cache_folder().iterdir()) == []


@pytest.mark.parametrize("work", [(1e-3, 100.0), (100.0, 0.0)], ids=["foreseen", "seen"])
def test_long_work_goes_on_in_c_with_the_same_numbers(work: tuple[float, float]) -> None:
    engine = _auto()
    on_the_tape = _accelerations(engine)
    engine.worked(*work)
    engine.worked(*work)  # does not start a second compiler
    assert _finished(engine)
    assert engine.is_compiled
    assert engine.hasten() is None
    assert _accelerations(engine) == on_the_tape
    again = _auto()
    assert again.is_compiled  # from the cache
    assert _accelerations(again) == on_the_tape


def test_a_library_that_cannot_be_loaded_is_not_used() -> None:
    engine = _auto()
    assert engine._compiler is not None
    library = cache_folder() / f"{engine._name(engine._compiler, engine._parts_of_native)}.so"
    library.parent.mkdir()
    library.write_bytes(b"not a library")
    assert not _auto().is_compiled


def test_without_a_compiler_it_stays_the_tape(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    engine = _auto()
    engine.worked(100.0, left=100.0)
    assert engine.hasten() is None
    assert np.isfinite(np.frombuffer(_accelerations(engine))).all()


def test_a_compiler_that_fails_is_not_asked_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    failing = tmp_path / "failing"
    failing.write_text("#!/bin/sh\nexit 1\n")
    failing.chmod(0o755)
    monkeypatch.setenv("CC", str(failing))
    engine = _auto()
    engine.worked(100.0)
    while engine._build is not None:
        assert engine.hasten() is None
    engine.worked(100.0)
    assert engine._build is None


def test_an_engine_that_is_no_longer_used_ends_its_compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = tmp_path / "slow"
    slow.write_text("#!/bin/sh\nexec sleep 100\n")
    slow.chmod(0o755)
    monkeypatch.setenv("CC", str(slow))
    engine = _auto()
    engine.worked(100.0)
    work = engine._build
    assert work is not None and work.is_running
    del engine
    gc.collect()
    assert not work.is_running
    assert list(cache_folder().iterdir()) == []


def test_a_change_of_what_writes_c_is_another_library(monkeypatch: pytest.MonkeyPatch) -> None:
    engine = _auto()
    assert engine._compiler is not None
    before = engine._name(engine._compiler, engine._parts_of_native)
    assert _auto()._name(engine._compiler, engine._parts_of_native) == before
    monkeypatch.setattr(auto_engine, "_writers", lambda: "another")
    assert engine._name(engine._compiler, engine._parts_of_native) != before
