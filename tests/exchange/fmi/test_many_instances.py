"""Instances by thousands and in threads, from a host in C: nothing is left behind, and nobody knows of the others."""

from __future__ import annotations

import platform
import shutil
import subprocess
from functools import cache
from pathlib import Path

import fmpy
import pytest
from choice import ALL, paired
from models.corpus import compiled

from fmi.exported import VERSIONS, exported
from fmi.motions import span

CYCLES = 10_000 if ALL else 1_000
HOST = Path(__file__).with_name("crowd.c")

pytestmark = pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="what the heap holds is asked of glibc")


@cache
def host(folder: Path) -> Path:
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler for the host")
    path = folder / "crowd"
    headers = Path(fmpy.__file__).parent / "c-code"
    warnings = ["-std=gnu11", "-Wall", "-Wextra", "-Werror"]
    command = [compiler, *warnings, "-O1", f"-I{headers}", str(HOST), "-o", str(path), "-ldl", "-pthread"]
    subprocess.run(command, check=True)
    return path


@pytest.mark.parametrize(("name", "version"), paired(["four_bar", "bouncing_ball_modelica"], VERSIONS[::-1]))
def test_ten_thousand_lives_leave_nothing_and_threads_do_not_meet(
    name: str, version: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.getbasetemp() / "crowd"
    folder.mkdir(exist_ok=True)
    fmu = exported(name, version)
    described = fmu.description
    inner = "linux64" if version == 2 else "x86_64-linux"
    library = fmu.folder / "binaries" / inner / f"{described.coSimulation.modelIdentifier}.so"
    coordinates = [coordinate.name for coordinate in compiled(name).flat.coordinates]
    references = [str(fmu.variables[coordinate].valueReference) for coordinate in coordinates]
    token = described.guid or described.instantiationToken
    arguments = [str(version), token, fmu.folder.as_uri(), repr(span(name)[1]), str(CYCLES), *references]
    done = subprocess.run([host(folder), library, *arguments], check=True, capture_output=True, text=True, timeout=300)
    early, late, strangers = map(int, done.stdout.split())
    assert late == early
    assert strangers == 0
