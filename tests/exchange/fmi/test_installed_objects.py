"""Objects that an installation brings are used for the texts and flags that they were made from, and for no others."""

from __future__ import annotations

import shutil

import pytest

from lagdsl.engines.runtime.building.compiler import machine_compiler
from lagdsl.engines.runtime.building.platforms import platform_of, this_machine
from lagdsl.exchange.fmi.package import installed_objects, toolchain
from lagdsl.exchange.fmi.package.binary import objects_of
from lagdsl.exchange.fmi.package.toolchain import Toolchain
from lagdsl.foundation import resources

HERE = platform_of(this_machine())
# Two files of a runtime, one that reads a header of the standard, which a build does not have.
RUNTIME = {
    "lag/twice.h": "double lag_twice(double x);\n",
    "lag/part/twice.c": '#include "lag/twice.h"\ndouble lag_twice(double x) { return 2.0*x; }\n',
    "lag/part/other.c": "int lag_other(void) { return 1; }\n",
}
SHELL = {"lag/fmi2/door.c": '#include "fmi2Functions.h"\nint lag_door(void) { return NUMBER; }\n'}
MODEL = {
    "fmi2Functions.h": "#define NUMBER 2\n",
    "M.c": '#include "lag/twice.h"\ndouble fmi2Four(void) { return lag_twice(2.0); }\n',
}


@pytest.fixture
def compiled(monkeypatch, tmp_path):
    """Files that a compiler is called for, where an installation brings the objects of RUNTIME; nothing is cached."""
    for top, files in (("c", RUNTIME), ("shells", SHELL)):
        for path, text in files.items():
            (tmp_path / top / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / top / path).write_text(text)
    monkeypatch.setattr(installed_objects, "c_folder", lambda: tmp_path / "c")
    monkeypatch.setattr(installed_objects, "compiled_runtime", lambda: resources.sources_in(tmp_path / "c"))
    monkeypatch.setattr(installed_objects, "fmi_folder", lambda: tmp_path / "shells")
    monkeypatch.setattr(installed_objects, "fmi_objects_folder", lambda: tmp_path / "brought")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    made = installed_objects.make_installed_objects(tmp_path / "brought", [HERE])
    assert sorted(made) == sorted((tmp_path / "brought").glob("*.o"))
    assert len(made) == 2
    compile_before, asked = Toolchain.compile, []

    def counting(self, folder, source, target):
        asked.append(source)
        compile_before(self, folder, source, target)

    monkeypatch.setattr(Toolchain, "compile", counting)
    return asked


def libraries(**changed):
    sources = {**RUNTIME, **SHELL, **MODEL, **changed}
    return objects_of(sources, "M", [HERE]).libraries()[HERE.name]


def test_only_what_the_installation_lacks_is_compiled(compiled):
    libraries()
    assert sorted(compiled) == ["M.c", "lag/fmi2/door.c"]


def test_brought_objects_give_the_same_bytes(compiled, tmp_path):
    before = libraries()
    shutil.rmtree(tmp_path / "brought")
    assert libraries() == before
    assert set(compiled) == {"M.c", *(path for path in (*RUNTIME, *SHELL) if path.endswith(".c"))}


def test_an_edited_text_is_compiled(compiled):
    libraries(**{"lag/part/other.c": "int lag_other(void) { return 2; }\n"})
    assert sorted(compiled) == ["M.c", "lag/fmi2/door.c", "lag/part/other.c"]


def test_an_edited_header_is_compiled_with_all_that_read_it(compiled):
    libraries(**{"lag/twice.h": "extern double lag_twice(double x);\n"})
    assert sorted(compiled) == ["M.c", "lag/fmi2/door.c", "lag/part/twice.c"]


def test_other_flags_are_compiled(compiled, monkeypatch):
    monkeypatch.setattr(toolchain, "SHARED", (*toolchain.SHARED, "-DOTHER"))
    libraries()
    assert set(compiled) >= {"lag/part/twice.c", "lag/part/other.c"}


@pytest.mark.skipif(machine_compiler() is None, reason="no compiler but ziglang")
def test_another_compiler_neither_makes_nor_takes_them(compiled, monkeypatch, tmp_path):
    for module in (toolchain, installed_objects):
        monkeypatch.setattr(module, "zig_program", lambda: None)
    assert installed_objects.make_installed_objects(tmp_path / "none", [HERE]) == []
    libraries()
    assert set(compiled) >= {"lag/part/twice.c", "lag/part/other.c"}


def test_a_build_removes_objects_of_older_texts(compiled, tmp_path):
    (tmp_path / "c/lag/part/other.c").unlink()
    made = installed_objects.make_installed_objects(tmp_path / "brought", [HERE])
    assert list((tmp_path / "brought").glob("*.o")) == made
    assert compiled == []
