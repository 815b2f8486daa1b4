"""The runtime on other machines: the WebAssembly module, 64-bit Arm under QEMU, Windows under Wine.

All step the same tapes from the same bytes. The library of mathematics is another one on each, so the last digits of
powers and logarithms may differ; where there are none of these, on Arm, the bits are the same.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from ctypes import byref, c_double, c_size_t
from pathlib import Path

import numpy as np
import pytest
from choice import ALL
from models.corpus import compiled

from lagdsl.derivation.structure.names import contact_rows
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.engines.runtime.build_wasm import build_wasm
from lagdsl.engines.runtime.building.build_library import build_library
from lagdsl.engines.runtime.building.linking import zig_program
from lagdsl.engines.runtime.building.platforms import library_name, platform_of, this_machine
from lagdsl.engines.runtime.engines.buffers import aligned
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.resources import c_folder
from lagdsl.motion.simulate.initialize import initial_state

HERE = Path(__file__).parent
# Smooth, contact with impacts, closed loops, sampled control, friction and clutches.
CHOSEN = {"double_pendulum": 2.0, "bouncing_ball": 2.0, "four_bar": 2.0, "library/blocks_pid": 2.0, "clutch": 2.0}
TOLERANCE, ROWS = 1e-10, 40
# Commands that run programs of the platform, and which libraries it needs for them.
EMULATORS = {
    "linux-x86_64": ["env"],  # another compiler than this machine's
    "linux-aarch64": ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"],
    "windows-x86_64": ["wine"],
}

needs_zig = pytest.mark.skipif(zig_program() is None, reason="ziglang is not installed")


def tape_of(name: str) -> bytes:
    flat, program = compiled(name).flat, compiled(name).graph
    initial = initial_state(flat, TapeEngine(program))
    return tape(program, start_of(flat, initial.t, initial.x.tolist()))


def loose(name: str) -> list[int]:
    """The rows that come and go."""
    return sorted(contact_rows(compiled(name).flat))


def on_this_machine(name: str, made: bytes, stop: float) -> Floats:
    runtime = runtime_library()
    held = aligned(len(made) // 8 + 1)
    held.view(np.uint8)[: len(made)] = np.frombuffer(made, dtype=np.uint8)
    needed = c_size_t(0)
    assert runtime.tape_check(held.ctypes.data, len(made), byref(needed)) == 0
    memory = aligned(needed.value // 8 + 1)
    model = runtime.tape_model(held.ctypes.data, len(made), memory.ctypes.data)
    start = runtime.tape_start(model)
    block = aligned(runtime.session_size(model, start) // 8 + 1)
    session = runtime.session_place(block.ctypes.data, model, start, TOLERANCE, stop)
    lasting = (c_double * 1000).from_address(runtime.session_lasting(session))
    for row in loose(name):
        lasting[row] = 0.0
    assert runtime.session_begin(session, 0.0) == 0
    rows: list[Floats] = []
    for k in range(1, ROWS + 1):
        assert runtime.session_to(session, stop * k / ROWS, 0) == 0
        found = (c_double * runtime.session_width(session)).from_address(runtime.session_row(session))
        rows.append(np.array(found))
    return np.array(rows)


def close(found: Floats, expected: Floats, part: float) -> None:
    """Within a part of the range of each column; residuals, the last two, are round-off."""
    found, expected = found[:, :-2], expected[:, :-2]
    size = np.ptp(expected, axis=0) + np.max(np.abs(expected), axis=0)
    assert np.all(np.abs(found - expected) <= part * size)


@pytest.fixture(scope="module")
def wasm(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if not ALL:
        pytest.skip("compiles the runtime for web pages: make check-all")
    return build_wasm(tmp_path_factory.mktemp("wasm"))


def _sections(data: bytes) -> set[int]:
    """The numbers of the sections of a WebAssembly module (specification, 5.5)."""
    assert data[:8] == b"\0asm\1\0\0\0"
    found, at = set(), 8
    while at < len(data):
        found.add(data[at])
        at, size, shift = at + 1, 0, 0
        while True:
            byte, at = data[at], at + 1
            size |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                break
        at += size
    assert at == len(data)
    return found


@needs_zig
def test_the_module_for_web_pages_imports_nothing(wasm: Path) -> None:
    imports, exports = 2, 7
    sections = _sections(wasm.read_bytes())
    assert imports not in sections
    assert exports in sections


@needs_zig
@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
@pytest.mark.parametrize("name", CHOSEN)
def test_a_web_page_sees_the_same_motion(name: str, wasm: Path, tmp_path: Path) -> None:
    made, path = tape_of(name), tmp_path / "model.tape"
    path.write_bytes(made)
    command = ["node", HERE / "session.mjs", wasm, path, str(TOLERANCE), str(CHOSEN[name]), str(ROWS)]
    command.append(",".join(map(str, loose(name))))
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert told["imports"] == []
    close(np.array(told["rows"]), on_this_machine(name, made, CHOSEN[name]), 1e-9)


@pytest.mark.skipif(not os.environ.get("LAGDSL_EXPLORE"), reason="compiles for other machines: with LAGDSL_EXPLORE=1")
@needs_zig
@pytest.mark.parametrize("name", EMULATORS)
def test_other_machines_compute_the_same(name: str, tmp_path: Path) -> None:
    emulator = EMULATORS[name]
    if emulator == ["env"] and this_machine() != name:
        pytest.skip("of another processor")
    if shutil.which(emulator[0]) is None:
        pytest.skip(f"{emulator[0]} is not installed")
    platform = platform_of(name)
    library = build_library(tmp_path, name)
    program = tmp_path / "session.exe"
    zig = [str(zig_program()), "cc", "-target", platform.target, "-O1", "-I", str(c_folder())]
    libraries = ["-ldl"] if platform.system == "linux" else []
    subprocess.run([*zig, str(HERE / "session.c"), "-o", str(program), *libraries], check=True)
    assert library.name == library_name(platform.system)
    for model, stop in CHOSEN.items():
        made = tape_of(model)
        (tmp_path / "model.tape").write_bytes(made)
        run = [*emulator, str(program), f"./{library.name}", "model.tape", repr(TOLERANCE), repr(stop), str(ROWS)]
        run.append(",".join(map(str, loose(model))))
        environment = {**os.environ, "WINEDEBUG": "-all", "WINEPREFIX": str(tmp_path / "wine")}
        told = tmp_path / "rows"  # a file: Wine's services outlive the program and would keep a pipe open
        with told.open("w") as file:
            done = subprocess.run(
                run, stdout=file, stderr=subprocess.DEVNULL, cwd=tmp_path, env=environment, timeout=240, check=False
            )
        assert done.returncode == 0, (model, done.returncode)
        found = np.array([[float.fromhex(x) for x in line.split()] for line in told.read_text().splitlines()])
        expected = on_this_machine(model, made, stop)
        if name == "linux-aarch64":
            np.testing.assert_array_equal(found, expected, err_msg=model)
        else:
            close(found, expected, 1e-9)
