"""The Makefile of an export takes the objects of the runtime that came with it where they are what it would compile."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.engines.runtime.building.platforms import PLATFORMS, platform_of, this_machine
from lagdsl.exchange.fmi.package.installed_objects import installed_runtime
from lagdsl.interfaces.cli.main import lag

pytestmark = [
    pytest.mark.skipif(shutil.which("make") is None or shutil.which("gcc") is None, reason="no make or gcc"),
    pytest.mark.skipif(not this_machine().startswith("linux") or this_machine() not in PLATFORMS, reason="not Linux"),
]
READY = f"lib/{this_machine()}/integration.o"


@pytest.fixture(scope="module")
def exported(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An export with one object that came with it, whatever the installation brings."""
    folder = tmp_path_factory.mktemp("pendulum")
    arguments = ["build", str(root / "models/pendulum.lag"), "--target", "c", "-o", str(folder)]
    assert CliRunner().invoke(lag, arguments).exit_code == 0
    (folder / READY).parent.mkdir(parents=True, exist_ok=True)
    (folder / READY).write_bytes(b"")
    return folder


def compiled(folder: Path, *arguments: str) -> bool:
    """True if `make` compiles the runtime."""
    kept = {name: value for name, value in os.environ.items() if name not in ("CC", "CFLAGS", "MAKEFLAGS")}
    done = subprocess.run(
        ["make", "-n", "CC=gcc", *arguments], cwd=folder, env=kept, check=True, capture_output=True, text=True
    )
    assert ("lag/run/run.c" in done.stdout) != (READY in done.stdout)
    return "lag/run/run.c" in done.stdout


def test_they_are_taken(exported: Path) -> None:
    assert not compiled(exported)


@pytest.mark.parametrize("argument", ["CFLAGS=-O2", "CC=gcc -m32"])
def test_other_flags_compile_the_sources(exported: Path, argument: str) -> None:
    assert compiled(exported, argument)


def test_another_machine_compiles_the_sources(exported: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(exported, tmp_path / "copy")
    (folder / "lib" / this_machine()).rename(folder / "lib" / "linux-other")
    assert compiled(folder)


def test_an_edited_source_is_compiled(exported: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(exported, tmp_path / "copy")
    newer = (folder / READY).stat().st_mtime + 10
    os.utime(folder / "lag/linalg/arena.h", (newer, newer))
    assert compiled(folder)


def test_a_program_of_them_finds_the_motion(root: Path, tmp_path: Path) -> None:
    if not installed_runtime(platform_of(this_machine())):
        pytest.skip("this checkout was installed before its runtime was edited, or without ziglang")
    model = root / "models/pendulum.lag"
    arguments = ["build", str(model), "--target", "c", "-o", str(tmp_path)]
    assert CliRunner().invoke(lag, arguments).exit_code == 0
    subprocess.run(["make", "Pendulum"], cwd=tmp_path, check=True, capture_output=True)
    assert not list(tmp_path.glob("lag/*/*.o"))
    command = [str(tmp_path / "Pendulum"), "1", "0.5", "1e-9"]
    last = subprocess.run(command, capture_output=True, check=True, text=True).stdout.splitlines()[-1].split(",")
    motion = lagdsl.compile(model).simulate(stop=1.0, interval=0.5, tolerance=1e-9)
    assert float(last[1]) == pytest.approx(motion["theta"][-1], abs=1e-7)
