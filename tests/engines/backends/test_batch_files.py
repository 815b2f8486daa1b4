"""Exported functions of many states and of many directions at once: those of single ones, faster."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from choice import spread
from made_modules import PLAIN, Made
from sample_programs import chain, closed_chain

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.emit import CBackend

_PROGRAM = Path(__file__).with_name("many_states.c")


@pytest.mark.parametrize("program", spread([closed_chain(2), chain(3)], 1), ids=lambda program: program.name)
def test_the_files_of_the_batch_build_and_agree(tmp_path: Path, made: Made, program: Program) -> None:
    files = CBackend(batch=True).emit(program).files
    (stem,) = (name.removesuffix("_states.c") for name in files if name.endswith("_states.c"))
    more = {f"{stem}_states.c", f"{stem}_tangents.c", f"{stem}_parameter_tangents.c"}
    assert set(files) - set(CBackend().emit(program).files) == more
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    (tmp_path / "main.c").write_text(_PROGRAM.read_text(encoding="utf-8").replace("STEM", stem), encoding="utf-8")
    done = made(tmp_path, stem, f"CFLAGS={PLAIN}")
    assert (done.returncode, done.stderr) == (0, "")
    assert subprocess.run([str(tmp_path / stem)], check=False).returncode == 0
