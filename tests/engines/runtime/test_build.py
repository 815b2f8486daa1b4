"""Finding compilers, and the cache of compiled models."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from choice import repeats
from sample_programs import pendulum

from lagdsl.engines.backends.c.emit import engine_sources, model_symbol, sources
from lagdsl.engines.runtime.building import compiler as compilers
from lagdsl.engines.runtime.building.background_build import BackgroundBuild
from lagdsl.engines.runtime.building.build import build, content_hash
from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.building.compiler import FLAGS, Compiler, find_compiler
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.native_model import load_compiled
from lagdsl.foundation.diagnostics import CompilationFailed

QUICKLY = ["-O0"]
SOURCES = {"answer.c": "int answer(void);\nint answer(void) { return 42; }\n"}


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("CC", raising=False)


@pytest.fixture(scope="module")
def runtime() -> Path:
    """The cache of all other tests, with the object files of the runtime."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("CC", raising=False)
        build(sources(pendulum("First")), QUICKLY)
        return cache_folder()


@pytest.fixture
def _compiled_runtime(_own_cache: None, runtime: Path) -> None:
    """The cache holds what all models share."""
    for path in runtime.glob("*.o"):
        shutil.copy(path, cache_folder())


def _code(caught: pytest.ExceptionInfo[CompilationFailed]) -> str:
    return caught.value.diagnostics[0].code


def test_a_library_is_built_once_and_found_again() -> None:
    first = build(SOURCES)
    before = first.stat().st_mtime_ns
    assert build(SOURCES) == first
    assert first.stat().st_mtime_ns == before
    assert build({**SOURCES, "more.c": "int more(void);\nint more(void) { return 1; }\n"}) != first
    assert [path.name for path in first.parent.iterdir() if path.name.startswith("build-")] == []
    assert first.parent.stat().st_mode & 0o077 == 0


def test_the_name_depends_on_everything() -> None:
    plain = Compiler(("cc",), "1")
    hashes = {
        content_hash(texts, compiler)
        for texts in ({"a.c": "x", "b.c": "y"}, {"a.c": "xb.c", "c": "y"}, {"b.c": "y"})
        for compiler in (plain, Compiler(("cc", "-g"), "1"), Compiler(("cc",), "2"))
    }
    assert len(hashes) == 9


def test_a_broken_library_is_built_again() -> None:
    program = pendulum()
    library = build(engine_sources(program))
    library.write_bytes(b"not a library")
    assert np.isfinite(CEngine(program).evaluate("start", 0.0, np.array(program.layout.defaults))[0]).all()


def test_another_version_of_the_interface_is_refused() -> None:
    program = pendulum("Old")
    texts = engine_sources(program)
    texts["Old.c"] = texts["Old.c"].replace("LAG_MODEL_VERSION", "99u")
    with pytest.raises(OSError, match="version 99 "):
        load_compiled(build(texts), model_symbol(program))


def test_threads_may_build_the_same_at_once() -> None:
    found: list[Path] = []
    threads = [threading.Thread(target=lambda: found.append(build(SOURCES))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4
    assert len(set(found)) == 1


def test_the_compiler_of_the_environment_comes_first(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    own = tmp_path / "own-compiler"
    own.write_text('#!/bin/sh\nexec cc "$@"\n')
    own.chmod(0o755)
    monkeypatch.setenv("CC", f"{own} -g")
    found = find_compiler()
    assert Path(found.command[0]).name == "own-compiler"
    assert found.command[1:] == ("-g",)


def test_without_a_compiler_both_ways_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(CompilationFailed) as caught:
        find_compiler()
    assert _code(caught) == "E0911"
    help_text = caught.value.diagnostics[0].help or ""
    assert "`cc`" in help_text
    assert "ziglang" in help_text


def test_ziglang_is_the_last_resort(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("ziglang")
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)
    assert find_compiler().command == (sys.executable, "-m", "ziglang", "cc")


def test_a_failing_compiler_is_quoted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(CompilationFailed) as caught:
        build({"bad.c": "this is no C\n"})
    assert _code(caught) == "E0912"
    assert "bad.c" in caught.value.diagnostics[0].notes[0]
    silent = tmp_path / "nothing"
    silent.write_text("no program")
    silent.chmod(0o755)
    monkeypatch.setenv("CC", str(silent))
    with pytest.raises(CompilationFailed) as caught:
        build(SOURCES)
    assert _code(caught) == "E0912"


def test_the_cache_must_be_ones_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = cache_folder()
    folder.chmod(0o777)
    with pytest.raises(CompilationFailed, match="can be written by others") as caught:
        build(SOURCES)
    assert _code(caught) == "E0913"
    folder.chmod(0o700)
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    with pytest.raises(CompilationFailed, match="belongs to somebody else"):
        build(SOURCES)
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    with pytest.raises(CompilationFailed) as caught:
        build(SOURCES)
    assert _code(caught) == "E0913"


def test_a_full_disk_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*arguments: object, **more: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(CompilationFailed, match="No space left") as caught:
        build(SOURCES)
    assert _code(caught) == "E0913"


def test_without_a_cache_variable_it_lies_in_the_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder() == tmp_path / ".cache" / "lagdsl"


def test_libraries_are_made_for_the_processor_that_loads_them(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(compilers.platform, "machine", lambda: "x86_64")
    names = set()
    for flags_of_processor in ("sse2", "sse2 avx", None):
        text = tmp_path / "cpuinfo"
        text.unlink(missing_ok=True)
        if flags_of_processor is not None:
            text.write_text(f"processor: 0\ncpu MHz: 2000\nflags: {flags_of_processor}\n\nprocessor: 1\nflags: other\n")
        monkeypatch.setattr(compilers, "_PROCESSORS", text)
        compilers.processor.cache_clear()
        names.add(content_hash(SOURCES, Compiler(("cc",), "1")))
        expected = () if flags_of_processor is None else ("-march=native",)
        assert compilers.native_flags(Compiler(("cc",), "1")) == expected
        assert compilers.native_flags(Compiler(("cc", "-march=x86-64"), "1")) == ()
    compilers.processor.cache_clear()
    assert len(names) == 3


def test_nothing_reorders_arithmetic() -> None:
    assert "-ffp-contract=off" in FLAGS
    assert not any("fast-math" in flag for flag in FLAGS)


@repeats("tests/engines/backends/test_artifacts.py, for which it is compiled, too")
@pytest.mark.usefixtures("_compiled_runtime")
def test_the_runtime_is_compiled_once_for_all_modules() -> None:
    before = set(cache_folder().iterdir())
    assert before
    library = build(sources(pendulum("Second")), QUICKLY)
    assert set(cache_folder().iterdir()) - before == {library}


def test_an_engine_compiles_the_model_alone() -> None:
    library = build(engine_sources(pendulum("Third")))
    assert list(cache_folder().iterdir()) == [library]
    with pytest.raises(AttributeError):
        _ = ctypes.CDLL(str(library)).lag_run_to


def test_a_compiler_that_nobody_waits_for_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = tmp_path / "slow"
    slow.write_text("#!/bin/sh\nexec sleep 100\n")
    slow.chmod(0o755)
    monkeypatch.setenv("CC", str(slow))
    work = BackgroundBuild(lambda: SOURCES, (), "name")
    while not list(cache_folder().glob("build-*")):
        assert work.is_running
    work.cancel()
    assert not work.is_running
    assert work.library is None
    assert list(cache_folder().iterdir()) == []


_RUN = """
import sys
sys.path[:0] = sys.argv[1:]
import numpy as np
from sample_programs import chain
from lagdsl.engines.runtime.engines.c_engine import CEngine
engine = CEngine(chain(3))
draw = np.random.default_rng(0)
q, qd, none = draw.normal(size=3), draw.normal(size=3), np.zeros(0)
print(engine.solve(0.0, q, qd, none, none, none, np.array([1.0, 2.0, 3.0]))[0].tobytes().hex())
"""


def test_runs_are_identical_to_the_bit(root: Path) -> None:
    command = [sys.executable, "-c", _RUN, str(root), str(root / "tests")]
    runs = {subprocess.run(command, capture_output=True, text=True, check=True).stdout for _ in range(2)}
    assert len(runs) == 1
