"""Which engine `auto` is."""

from __future__ import annotations

from pathlib import Path

import pytest

import lagdsl
from lagdsl.runtime.c_engine import CEngine
from lagdsl.runtime.numpy_engine import NumpyEngine


def _engine(path: Path, **structural: float) -> object:
    return lagdsl.compile(path, engine="auto", structural=structural)._engine


def test_small_models_run_in_numpy(root: Path) -> None:
    assert isinstance(_engine(root / "models" / "pendulum.lag"), NumpyEngine)


def test_large_models_run_in_c(root: Path) -> None:
    assert isinstance(_engine(root / "benchmarks" / "models" / "planar_chain.lag", N=100), CEngine)


def test_without_a_compiler_large_models_run_in_numpy(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert isinstance(_engine(root / "benchmarks" / "models" / "planar_chain.lag", N=100), NumpyEngine)
