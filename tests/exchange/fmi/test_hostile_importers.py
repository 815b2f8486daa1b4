"""Generated models under importers that call anything in any order: a status, never a crash, under sanitizers."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from models.corpus import compiled

from fmi.exported import EVERY
from lagdsl.exchange.fmi.contents import texts
from lagdsl.exchange.fmi.export_model import export_model
from lagdsl.exchange.fmi.package.sources import require_fmpy
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.resources import fmi_folder

RUNTIME = Path(__file__).parents[3] / "lagdsl" / "engines" / "runtime" / "c"
SHELLS = fmi_folder()
SHELL, LIBRARY = "build/sanitized/all.a", str(RUNTIME / "build/sanitized/all.so")
FLAGS = ("-std=c11", "-g", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
EXPLORE = bool(os.environ.get("LAGDSL_EXPLORE"))
MODELS = EVERY if EXPLORE else ("newtons_cradle",)
LIVES = 20 if EXPLORE else 10

pytestmark = pytest.mark.skipif(
    shutil.which("make") is None or shutil.which("cc") is None, reason="neither make nor cc is installed"
)


def run(*command: str, folder: Path) -> None:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout[-2000:]}\n{done.stderr[-4000:]}"


@pytest.mark.parametrize("name", MODELS)
def test_calls_at_random_get_a_status(name: str, tmp_path: Path) -> None:
    """By the table of FMI 3, which has arrays, too."""
    run("make", "--silent", f"PYTHON={sys.executable}", "objects", folder=SHELLS)
    exported = export_model(compiled(name).compilation, 3, ("me", "cs"), {}, {}, Sink())
    _, sources = texts(exported)
    own = {path: text for path, text in sources.items() if "/" not in path and path.startswith(exported.stem)}
    for path, text in own.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    found = (tmp_path, SHELLS, RUNTIME, require_fmpy() / "c-code")
    host = Path(__file__).with_name("c") / "visit.c"
    generated = sorted(path for path in own if path.endswith(".c"))
    includes = [f"-I{folder}" for folder in found]
    run(
        "cc",
        *FLAGS,
        *includes,
        "-o",
        "visit",
        str(host),
        *generated,
        str(SHELLS / SHELL),
        LIBRARY,
        "-lm",
        folder=tmp_path,
    )
    for seed in (1, 2, 3) if EXPLORE else (1,):
        run("./visit", str(seed), str(LIVES), folder=tmp_path)
