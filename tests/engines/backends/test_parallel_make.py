"""`make` of an exported module compiles on all cores, unless whoever calls it decides otherwise."""

import os
import re
import shutil
import subprocess

import pytest

from lagdsl.foundation.resources import c_folder

pytestmark = pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
SHOW = "\nshow:\n\t@echo '$(MAKEFLAGS)'\n"
OUTER = "all:\n\t+$(MAKE) -s show\n"


def jobs(folder, *arguments, makefile=None, **variables):
    """The number of `-j` in what a recipe sees; None without one."""
    text = (c_folder() / "example" / "Makefile").read_text()
    (folder / "Makefile").write_text(f"MODEL := m\n{text}{SHOW}")
    outer = ["-f", "outer", "all"] if makefile else ["show"]
    (folder / "outer").write_text(makefile or "")
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("MAKE", "MFLAGS"))} | variables
    command = ["make", "-s", *arguments, *outer]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    found = re.search(r"-j ?(\d+)", done.stdout)
    return None if found is None else int(found[1])


def test_a_plain_make_takes_all_cores(tmp_path):
    assert jobs(tmp_path) == os.sysconf("SC_NPROCESSORS_ONLN")


def test_the_caller_decides(tmp_path):
    assert jobs(tmp_path, "-j1") == 1
    assert jobs(tmp_path, "-j3") == 3
    assert jobs(tmp_path, "JOBS=5") == 5
    assert jobs(tmp_path, JOBS="4") == 4


def test_another_make_decides(tmp_path):
    assert jobs(tmp_path, makefile=OUTER) is None
    assert jobs(tmp_path, "-j2", makefile=OUTER) == 2
