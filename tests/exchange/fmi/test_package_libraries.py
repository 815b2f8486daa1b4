"""Libraries of FMUs: what they show and ask for, on every platform; the same sources, the same bytes.

Only this machine's own is made of a model in every run; all others take the compiler a minute (LAGDSL_EXPLORE=1).
"""

from __future__ import annotations

import os
import re
import shutil
import struct
import subprocess
from functools import cache
from pathlib import Path

import pytest
from models.corpus import compiled

from fmi.libraries import library
from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.engines.runtime.building.platforms import PLATFORMS, platform_of, this_machine
from lagdsl.exchange.fmi.contents import library_files, texts
from lagdsl.exchange.fmi.export_model import export_model
from lagdsl.exchange.fmi.package import toolchain as toolchains
from lagdsl.exchange.fmi.package.binary import Objects, objects_of
from lagdsl.exchange.fmi.package.libraries import universal, without_timestamps
from lagdsl.exchange.fmi.package.sources import require_fmpy
from lagdsl.foundation.diagnostics import CompilationFailed, Sink

VERSIONS = (2, 3)
EXPLORING = bool(os.environ.get("LAGDSL_EXPLORE"))
MADE = PLATFORMS if EXPLORING else (this_machine(),)
SYSTEMS = {
    "linux": {"libc.so.6", "libm.so.6"},
    "windows": {f"api-ms-win-crt-{part}-l1-1-0.dll" for part in ("heap", "math", "stdio")},
    "macos": {"/usr/lib/libSystem.B.dylib"},
}
# Symbols that the linker of macOS adds to every library.
OF_THE_LINKER = {"__dso_handle", "_mh_dylib_header"}


@cache
def sources(version):
    return texts(export_model(compiled("pendulum").compilation, version, ("me", "cs"), {}, {}, Sink()))[1]


@cache
def made(version, platform):
    return objects_of(sources(version), "Pendulum", [platform_of(platform)]).libraries()[platform]


def functions(version):
    """Functions that the standard declares."""
    text = (require_fmpy() / "c-code" / f"fmi{version}Functions.h").read_text(encoding="utf-8")
    return set(re.findall(rf"^\s*FMI{version}_Export\s+\w+\s+(fmi{version}\w+);", text, re.MULTILINE))


@pytest.mark.parametrize("platform", MADE)
@pytest.mark.parametrize("version", VERSIONS)
def test_a_library_shows_the_functions_of_the_standard_and_asks_for_the_libraries_of_c(version, platform):
    found = library(made(version, platform))
    system, processor = platform.split("-")
    assert found.machine == processor
    assert found.exported - (OF_THE_LINKER if system == "macos" else set()) == functions(version)
    assert {name for name in found.needed if "string" not in name} <= SYSTEMS[system]
    versions = [tuple(int(part) for part in name.removeprefix("GLIBC_").split(".")) for name in found.versions]
    assert all(each <= (2, 17) for each in versions)
    assert bool(versions) == (system == "linux")


@pytest.mark.parametrize("platform", MADE)
def test_nothing_tells_where_a_library_was_made(platform):
    for place in (Path.home(), Path.cwd(), "/tmp", ".cache"):
        assert str(place).encode() not in made(2, platform)
    for name in (b"lag_run_to", b"model_dynamics"):  # of functions within
        assert name not in made(2, platform)


SINE = """#include <math.h>
#if defined(_WIN32)
__declspec(dllexport) double fmi2Sine(double);
#else
__attribute__((visibility("default"))) double fmi2Sine(double);
#endif
double fmi2Sine(double x) { return sin(x); }
"""


# Windows, too: what a library for it is linked from is compiled at each link.
@pytest.mark.parametrize("platform", sorted({*MADE, "windows-x86_64"}))
def test_libraries_do_not_depend_on_folders_nor_on_names_of_objects(platform, tmp_path):
    tool = toolchains.toolchain(platform_of(platform))
    found = []
    for name in ("one", "another-one"):
        folder = tmp_path / name
        folder.mkdir()
        (folder / "sine.c").write_text(SINE)
        tool.compile(folder, "sine.c", f"{name}.o")
        tool.link(tmp_path, [f"{folder / name}.o"], "sine")
        found.append(without_timestamps((tmp_path / "sine").read_bytes()))
    assert found[0] == found[1]
    assert library(found[0]).exported - OF_THE_LINKER == {"fmi2Sine"}


@pytest.mark.skipif(not EXPLORING, reason="compiles the runtime anew: with LAGDSL_EXPLORE=1")
@pytest.mark.parametrize("platform", MADE)
def test_another_cache_gives_the_same_bytes(platform, monkeypatch, tmp_path):
    before = made(2, platform)
    tmp_path.chmod(0o700)
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(Path.home() / ".cache" / "zig"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert objects_of(sources(2), "Pendulum", [platform_of(platform)]).libraries()[platform] == before


def test_another_model_finds_the_runtime_compiled(monkeypatch):
    made(2, this_machine())
    compile_before, asked = toolchains.Toolchain.compile, []

    def counting(self, folder, source, target):
        asked.append(source)
        compile_before(self, folder, source, target)

    monkeypatch.setattr(toolchains.Toolchain, "compile", counting)
    own = {name: f"{text}\n/* another model */\n" for name, text in sources(2).items() if name.startswith("Pendulum")}
    objects_of({**sources(2), **own}, "Pendulum", [platform_of(this_machine())])
    assert set(asked) <= {"Pendulum.c", "Pendulum_fmu.c", "Pendulum_start.c"}


def test_progress_goes_up_to_one():
    parts, linked = [], []
    objects_of(sources(2), "Pendulum", [platform_of(this_machine())], parts.append).libraries(linked.append)
    assert parts == sorted(parts)
    assert parts[-1] == 1.0
    assert linked == [1.0]


def test_a_library_that_fails_to_link_ends_the_others(monkeypatch):
    """All are linked at the same time, each in a folder of its own."""
    folders = []

    def failing(self, folder, objects, target, *, opened=False):
        folders.append(folder)
        (folder / target).write_bytes(self.platform.name.encode())
        if self.platform.name == "windows-x86_64":
            raise failure("E0906", platform=self.platform.name, compiler="zig")

    monkeypatch.setattr(toolchains.Toolchain, "link", failing)
    tools = [toolchains.Toolchain(platform_of(name), ("zig",), "", True) for name in PLATFORMS]
    objects = Objects("M", tuple(tools), {name: [] for name in PLATFORMS})
    with pytest.raises(CompilationFailed):
        objects.libraries()
    others = Objects("M", tuple(tool for tool in tools if tool.platform.system != "windows"), objects.paths)
    assert others.libraries() == {tool.platform.name: tool.platform.name.encode() for tool in others.tools}
    assert len(set(folders)) == len(folders)


# ---- compilers -------------------------------------------------------------------------------------------------------


def test_without_the_cross_compiler_there_is_this_machine_alone(monkeypatch):
    monkeypatch.setattr(toolchains, "zig_program", lambda: None)
    other = next(name for name in PLATFORMS if name != this_machine())
    with pytest.raises(CompilationFailed) as failed:
        toolchains.toolchain(platform_of(other))
    assert failed.value.diagnostics[0].code == "E0905"
    assert other in failed.value.diagnostics[0].message


@pytest.mark.skipif(
    not EXPLORING or shutil.which("cc") is None, reason="compiles the runtime anew: with LAGDSL_EXPLORE=1"
)
def test_without_the_cross_compiler_this_machine_s_own_does_the_same(monkeypatch):
    monkeypatch.setattr(toolchains, "zig_program", lambda: None)
    content = objects_of(sources(2), "Pendulum", [platform_of(this_machine())]).libraries()[this_machine()]
    found = library(content)
    assert found.exported - OF_THE_LINKER == functions(2)
    assert found.needed <= SYSTEMS[this_machine().split("-")[0]]


def test_what_the_compiler_says_is_told():
    broken = {**sources(2), "Pendulum_start.c": "this is not C\n"}
    with pytest.raises(CompilationFailed) as failed:
        objects_of(broken, "Pendulum", [platform_of(this_machine())])
    (diagnostic,) = failed.value.diagnostics
    assert diagnostic.code == "E0906"
    assert "Pendulum_start.c" in diagnostic.notes[0]


def test_a_missing_function_is_found_when_it_is_linked():
    lacking = dict(sources(2))
    del lacking["lag/equations/motion.c"]
    unit = lacking["units/integration.c"]
    lacking["units/integration.c"] = unit.replace('#include "lag/equations/motion.c"\n', "")
    assert lacking["units/integration.c"] != unit
    with pytest.raises(CompilationFailed) as failed:
        objects_of(lacking, "Pendulum", [platform_of(this_machine())]).libraries()
    assert "lag_motion_" in failed.value.diagnostics[0].notes[0]


# ---- where they go ---------------------------------------------------------------------------------------------------


def test_folders_are_those_of_the_version():
    libraries = {name: bytes.fromhex("cffaedfe") + bytes(12) + name.encode() for name in PLATFORMS}
    third = library_files(libraries, "X", 3)
    assert sorted(third) == [
        "binaries/aarch64-darwin/X.dylib",
        "binaries/aarch64-linux/X.so",
        "binaries/x86_64-darwin/X.dylib",
        "binaries/x86_64-linux/X.so",
        "binaries/x86_64-windows/X.dll",
    ]
    second = library_files(libraries, "X", 2)
    assert sorted(second) == [
        "binaries/aarch64-darwin/X.dylib",
        "binaries/aarch64-linux/X.so",
        "binaries/darwin64/X.dylib",
        "binaries/linux64/X.so",
        "binaries/win64/X.dll",
    ]
    assert second["binaries/linux64/X.so"] == libraries["linux-x86_64"]
    assert second["binaries/darwin64/X.dylib"] == universal([libraries["macos-x86_64"], libraries["macos-aarch64"]])


@pytest.mark.parametrize("name", ["linux-aarch64", "macos-aarch64"])
def test_importers_that_know_no_other_folder_find_the_only_library(name):
    content = bytes.fromhex("cffaedfe0c000001") + bytes(24)
    files = library_files({name: content}, "X", 2)
    folder = {"linux": "linux64", "macos": "darwin64"}[name.split("-")[0]]
    (found,) = [each for path, each in files.items() if f"/{folder}/" in path]
    assert found.endswith(content) or content in found
    assert len(files) == 2


def test_one_file_for_two_processors():
    slices = [
        struct.pack("<III", 0xFEEDFACF, kind, 3) + bytes(100 * n) for n, kind in ((1, 0x01000007), (2, 0x0100000C))
    ]
    whole = universal(slices)
    magic, count = struct.unpack_from(">II", whole)
    assert (magic, count) == (0xCAFEBABE, 2)
    for number, content in enumerate(slices):
        processor, _, place, size, power = struct.unpack_from(">IIIII", whole, 8 + 20 * number)
        assert whole[place : place + size] == content
        assert place % (1 << power) == 0
        assert processor == struct.unpack_from("<I", content, 4)[0]


def test_the_time_of_linking_is_taken_out_of_a_dll():
    head = b"MZ" + bytes(58) + struct.pack("<I", 64)
    dll = head + b"PE\0\0" + struct.pack("<HHI", 0x8664, 3, 0x12345678) + b"rest"
    assert without_timestamps(dll) == head + b"PE\0\0" + struct.pack("<HHI", 0x8664, 3, 0) + b"rest"
    for other in (b"\x7fELF" + bytes(80), b"MZ" + bytes(100)):
        assert without_timestamps(other) == other


@pytest.mark.skipif(not EXPLORING or shutil.which("llvm-objdump") is None, reason="with LAGDSL_EXPLORE=1 and LLVM")
def test_another_reader_of_universal_files(tmp_path):
    file = tmp_path / "both.dylib"
    file.write_bytes(universal([made(2, "macos-x86_64"), made(2, "macos-aarch64")]))
    command = ["llvm-objdump", "--macho", "--universal-headers", file]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert re.findall(r"^architecture (\w+)", told, re.MULTILINE) == ["x86_64", "arm64"]
