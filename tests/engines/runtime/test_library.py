"""The runtime as a shared library: prototypes, when a checkout builds it, words where it cannot be loaded."""

from __future__ import annotations

import os
import re
from ctypes import c_double, c_int, c_size_t, c_void_p
from pathlib import Path

import pytest
from choice import together

from lagdsl.engines.runtime import library as libraries
from lagdsl.engines.runtime.building import build_library as building
from lagdsl.engines.runtime.building.compiler import FLAGS
from lagdsl.engines.runtime.building.platforms import PLATFORMS, library_name, this_machine
from lagdsl.engines.runtime.library import PROTOTYPES, Runtime, runtime_library
from lagdsl.engines.runtime.structures import Range
from lagdsl.foundation import resources
from lagdsl.foundation.diagnostics import CompilationFailed

# A declaration in a header: result, name without `lag_`, arguments.
DECLARED = re.compile(r"^(?!typedef|static)(\w[\w ]*?[ *]+)lag_(\w+)\(([^;{]*)\);", re.MULTILINE | re.DOTALL)
BY_VALUE = {"double": c_double, "size_t": c_size_t, "int": c_int, "lag_range": Range, "lag_status": c_int}
FUNCTIONS = {"lag_function": c_int}


def _declarations() -> dict[str, tuple[str, str]]:
    headers = sorted((resources.c_folder() / "lag").rglob("*.h"))
    texts = [re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.DOTALL) for header in headers]
    return {name: (result, given) for text in texts for result, name, given in DECLARED.findall(text)}


def _type(text: str) -> type:
    if "*" in text or "(" in text:
        return c_void_p
    (kind,) = [word for word in text.split() if word in BY_VALUE or word in FUNCTIONS]
    return {**BY_VALUE, **FUNCTIONS}[kind]


def _arguments(text: str) -> tuple[type, ...]:
    """Parameters that are pointers to functions hold commas of their own."""
    flat = re.sub(r"\(\*\w+\)\([^)]*\)", "*", text)
    return tuple(_type(each) for each in flat.split(","))


@together("name", PROTOTYPES)
def test_prototypes_are_those_of_the_headers(name: str) -> None:
    result, arguments = _declarations()[name]
    assert PROTOTYPES[name] == (None if result.strip() == "void" else _type(result), _arguments(arguments))
    assert getattr(runtime_library(), name).argtypes == PROTOTYPES[name][1]


def test_a_function_without_prototype_is_refused() -> None:
    with pytest.raises(AttributeError, match="lag_run_nothing"):
        runtime_library().run_nothing  # noqa: B018


def test_the_library_is_for_every_processor_of_its_kind() -> None:
    assert not any("native" in flag for flag in FLAGS)
    assert {library_name(name.partition("-")[0]) for name in PLATFORMS} == {"liblag.so", "lag.dll", "liblag.dylib"}


def test_a_checkout_builds_it_when_a_source_changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = tmp_path / "lag.c"
    source.write_text("")
    monkeypatch.setattr(building, "_newest_source", lambda: source.stat().st_mtime_ns)
    library = tmp_path / "lib" / "liblag.so"
    built: list[Path] = []

    def build(path: Path) -> None:
        built.append(path)
        path.write_text("")
        os.utime(path, ns=(source.stat().st_mtime_ns, source.stat().st_mtime_ns))

    for _ in range(2):
        building.up_to_date(library, build)
    assert built == [library]
    os.utime(source, ns=(0, library.stat().st_mtime_ns + 1))
    building.up_to_date(library, build)
    assert built == [library, library]


def test_an_installed_package_compiles_nothing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def refuse(path: Path) -> Path:
        raise AssertionError(path)

    monkeypatch.setattr(building, "up_to_date", refuse)
    monkeypatch.setattr(libraries, "is_checkout", lambda: False)
    assert isinstance(libraries.runtime_library.__wrapped__(), Runtime)
    monkeypatch.setattr(libraries, "runtime_library_folder", lambda: tmp_path)
    (tmp_path / library_name(this_machine().partition("-")[0])).write_text("cut short")
    with pytest.raises(CompilationFailed) as caught:
        libraries.runtime_library.__wrapped__()
    assert caught.value.diagnostics[0].code == "E0914"
    assert "pip install" in (caught.value.diagnostics[0].help or "")


def test_objects_are_compiled_again_when_a_header_they_include_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "c"
    part = folder / "lag" / "part"
    part.mkdir(parents=True)
    (folder / "lag" / "one.h").write_text("#define ONE 1\n")
    for name in ("one", "two"):
        (part / f"{name}.c").write_text(f"int lag_{name}(void);\nint lag_{name}(void) {{ return 1; }}\n")
    with (part / "one.c").open("a") as file:
        file.write('#include "lag/one.h"\n')
    monkeypatch.setattr(building, "c_folder", lambda: folder)
    objects = tmp_path / "objects"
    objects.mkdir()

    def built() -> dict[str, str]:
        building.build_library(tmp_path, objects=objects)
        return {path.name.partition("-")[0]: path.name for path in objects.glob("*.o")}

    before = built()
    assert set(before) == {"one", "two"}
    (folder / "lag" / "one.h").write_text("#define ONE 2\n")
    after = built()
    assert after["two"] == before["two"]
    assert after["one"] != before["one"]
