"""The core compiles for a processor without operating system by a compiler without C library."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
from choice import ALL, spread
from made_modules import Made
from sample_programs import closed_chain, pendulum, quaternion_body

import lagdsl
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.registry import BACKENDS

COMPILERS = {
    "clang": "clang --target=thumbv7em-none-eabihf -mcpu=cortex-m7 -mfpu=fpv5-d16",
    "zig": f"{sys.executable} -m ziglang cc -target thumb-freestanding-eabihf -mcpu=cortex_m7",
}
FLAGS = "-O1 -ffreestanding -Ifreestanding -Wvla -Wframe-larger-than=2048"
# Functions that compilers for Arm call by themselves, and bring along: missing arithmetic, the moving of memory.
OF_THE_COMPILER = re.compile(r"__aeabi_\w+|memcpy|memset|memmove|fma")

BOUNCING = """
model Bouncing "Impacts, a resting contact, a clock and a reset"
  coordinate Length h(start = 1 m), x(der(start = 1 m/s));
  discrete Force f(start = 0);
  gravity = -g_n*world.y;
  mass 0.1 kg at {x, h};
  force f on x;
  contact floor: h >= 0 with restitution = 0.8;
equation
  when sample(0, 0.1 s) then
    f = if x > 1 m then -0.1 N else 0.1 N;
  elsewhen x >= 2 m then
    reinit(der(x), -der(x));
  end when;
  when time >= 10 s then
    terminate("long enough");
  end when;
end Bouncing;
"""


def _bouncing() -> Program:
    return lagdsl.compile(BOUNCING)._compilation.program


def _missing(compiler: str) -> bool:
    return shutil.which("clang") is None if compiler == "clang" else find_spec("ziglang") is None


def _symbols(library: Path, *options: str) -> set[tuple[str, str]]:
    """(kind, name) by `nm`."""
    command = ["nm", "--format=posix", *options, library.name]
    listed = subprocess.run(command, cwd=library.parent, check=True, capture_output=True, text=True).stdout
    return {(line.split()[1], line.split()[0]) for line in listed.splitlines() if len(line.split()) > 1}


def _declared(folder: Path) -> set[str]:
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.h")))
    return set(re.findall(r"^\w[\w ]*?[ *](\w+)\(", text, re.MULTILINE))


@pytest.mark.skipif(shutil.which("nm") is None, reason="nm is not installed")
@pytest.mark.skipif(not ALL, reason="compiles the runtime for another processor: make check-all")
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("make", [pendulum, lambda: closed_chain(2), quaternion_body, _bouncing])
def test_the_library_builds_without_a_c_library(tmp_path: Path, made: Made, compiler: str, make: object) -> None:
    if _missing(compiler):
        pytest.skip(f"{compiler} is not installed")
    artifact = BACKENDS["c"].emit(make())  # type: ignore[operator]
    for path, text in artifact.files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    (stem,) = (path.stem for path in tmp_path.glob("*.h"))
    done = made(tmp_path, "-j2", f"lib{stem}.a", f"CC={COMPILERS[compiler]}", f"CFLAGS={FLAGS}")
    assert (done.returncode, done.stderr) == (0, "")
    symbols = _symbols(tmp_path / f"lib{stem}.a")
    defined = {name for kind, name in symbols if kind not in "Uw"}
    undefined = {name for kind, name in symbols if kind == "U"} - defined
    assert {f"{stem}_model", "lag_run_to", "lag_run_fixed"} <= defined
    allowed = _declared(tmp_path / "freestanding")
    assert {"pow", "atan2", "memcpy"} <= allowed
    assert {name for name in undefined - allowed if OF_THE_COMPILER.fullmatch(name) is None} == set()
    assert [name for kind, name in symbols if kind in "bBdDcC"] == []  # no state outside of the caller's block


@pytest.mark.skipif(shutil.which("gcc") is None, reason="gcc is not installed")
def test_headers_of_the_module_are_all_it_needs(tmp_path: Path) -> None:
    """No header of a C library is there: those of the compiler and of the module do."""
    for path, text in BACKENDS["c"].emit(_bouncing()).files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    own = subprocess.run(["gcc", "-print-file-name=include"], check=True, capture_output=True, text=True).stdout.strip()
    programs = {"main.c", "realtime.c"}
    units = sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*.c") if path.name not in programs)
    assert len(units) > 50
    options = ["-std=c11", "-ffreestanding", "-nostdinc", "-isystem", own, "-Ifreestanding", "-I.", "-fsyntax-only"]
    command = ["gcc", *options, "-Wall", "-Wvla", *spread(units, 20)]
    done = subprocess.run(command, cwd=tmp_path, check=False, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
