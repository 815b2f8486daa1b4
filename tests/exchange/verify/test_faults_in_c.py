"""Faults that are planted in sources of the C runtime are found by the line on tangents of motions."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from choice import chosen
from models.corpus import path_of

from lagdsl.engines.runtime.building import build_library
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.foundation.resources import c_folder, runtime_library_folder

# File, sound text, wrong text, model. Behind an instant f+ dtau is forgotten; columns do not begin with those of the
# start.
FAULTS = {
    "an instant": (
        "sensitivity_instants.c",
        "lag_axpy(n, -time, s->instant.f_after, behind);",
        "",
        "bouncing_ball",
    ),
    "the start": (
        "sensitivity_start.c",
        "lag_columns_put(s, k, 0, n, found, s->columns.x, variables);",
        "",
        "double_pendulum",
    ),
}
# A process that takes its runtime from a folder and tells the line.
VERIFY = """
import sys
from pathlib import Path

import lagdsl
from lagdsl.engines.runtime import library

library.runtime_library_folder = lambda: Path(sys.argv[1])
library.is_checkout = lambda: False
from lagdsl.exchange.verify.tangents import motion_tangents

model = lagdsl.compile(sys.argv[2], engine="tape")
print(motion_tangents(model._compilation, model._engine).verdict)
"""


@pytest.mark.parametrize("place", chosen(FAULTS, ["an instant"]))
def test_a_fault_in_the_runtime_is_found(place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Objects of the other sources are those of the runtime."""
    name, sound, wrong, model = FAULTS[place]
    runtime_library()
    shutil.copytree(c_folder() / "lag", tmp_path / "c" / "lag")
    shutil.copytree(runtime_library_folder() / "objects", tmp_path / "objects")
    monkeypatch.setattr(build_library, "c_folder", lambda: tmp_path / "c")
    source = tmp_path / "c" / "lag" / "sensitivities" / name
    text = source.read_text()
    assert text.count(sound) == 1
    source.write_text(text.replace(sound, wrong))
    build_library.build_library(tmp_path, objects=tmp_path / "objects")
    command = [sys.executable, "-c", VERIFY, str(tmp_path), str(path_of(model))]
    assert subprocess.run(command, check=True, capture_output=True, text=True).stdout == "failed\n"
