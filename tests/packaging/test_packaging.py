"""A wheel and an sdist carry grammar, library, pages and C sources, and the wheel runs from wherever it lies."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest
from choice import repeats

from lagdsl.engines.runtime.building.build_library import wheel_tag
from lagdsl.engines.runtime.building.linking import zig_program
from lagdsl.engines.runtime.building.platforms import PLATFORMS, library_name, this_machine

CARRIED = {
    "grammar/lagdsl.lark": "lagdsl/_data/grammar/lagdsl.lark",
    "stdlib/Lag/package.lag": "lagdsl/_data/stdlib/Lag/package.lag",
    "stdlib/Lag/Planar/Revolute.lag": "lagdsl/_data/stdlib/Lag/Planar/Revolute.lag",
    "docs/diagnostics/E0401.md": "lagdsl/_data/diagnostics/E0401.md",
    "models/four_bar.lag": "lagdsl/_data/models/four_bar.lag",
    "models/library/dc_motor.lag": "lagdsl/_data/models/library/dc_motor.lag",
    "LICENSE": "lagdsl/_data/LICENSE",
    "lagdsl/language/syntax/grammar.jsonl": "lagdsl/language/syntax/grammar.jsonl",
    "lagdsl/engines/runtime/c/lag/model.h": "lagdsl/engines/runtime/c/lag/model.h",
    "lagdsl/engines/runtime/c/lag/equations/dynamics.c": "lagdsl/engines/runtime/c/lag/equations/dynamics.c",
    "lagdsl/exchange/fmi/c/lag/instance/instance.h": "lagdsl/exchange/fmi/c/lag/instance/instance.h",
    "lagdsl/exchange/fmi/c/lag/fmi2/fmi2.c": "lagdsl/exchange/fmi/c/lag/fmi2/fmi2.c",
    "lagdsl/exchange/fmi/c/lag/fmi3/fmi3.c": "lagdsl/exchange/fmi/c/lag/fmi3/fmi3.c",
}


@pytest.fixture(scope="module")
def packages(root: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """(sdist, wheel built from what the sdist holds), by the build backend and without the network."""
    folder = tmp_path_factory.mktemp("dist")
    build = "import sys; from hatchling.build import build_{0}; print(build_{0}(sys.argv[1]))"
    _run([sys.executable, "-c", build.format("sdist"), str(folder)], root)
    (sdist,) = folder.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        _extract(archive, folder / "unpacked")
    (source,) = (folder / "unpacked").iterdir()
    for compiled in (
        "lagdsl/engines/runtime/lib/objects",
        "lagdsl/exchange/fmi/lib",
    ):  # by their content: what differs is compiled
        if (root / compiled).is_dir():
            shutil.copytree(root / compiled, source / compiled)
    _run([sys.executable, "-c", build.format("wheel"), str(folder)], source)
    (wheel,) = folder.glob("*.whl")
    return sdist, wheel


@pytest.fixture(scope="module")
def site(packages: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files that the wheel installs."""
    folder = tmp_path_factory.mktemp("site")
    with zipfile.ZipFile(packages[1]) as archive:
        archive.extractall(folder)
    return folder


def _extract(archive: tarfile.TarFile, folder: Path) -> None:
    """Without links out of the folder, where Python has filters: since 3.11.4, and from 3.12 on it warns without."""
    if hasattr(tarfile, "data_filter"):
        archive.extractall(folder, filter="data")
    else:
        archive.extractall(folder)


def _run(command: list[str], folder: Path, **environment: str) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env=environment or None)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_sdist_carries_the_whole_project(packages: tuple[Path, Path]) -> None:
    with tarfile.open(packages[0]) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert set(CARRIED) <= names
    assert {"LICENSE", "README.md", "Makefile", "models/pendulum.lag", "tests/conftest.py"} <= names


def test_the_wheel_carries_what_runs(packages: tuple[Path, Path], root: Path) -> None:
    with zipfile.ZipFile(packages[1]) as archive:
        names = set(archive.namelist())
    assert set(CARRIED.values()) <= names
    classes = {path.relative_to(root).as_posix() for path in (root / "stdlib").rglob("*.lag")}
    assert {f"lagdsl/_data/{name}" for name in classes} <= names
    assert not any(name.startswith(("tests/", "models/")) for name in names)
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_the_wheel_is_for_one_platform_and_carries_the_runtime(packages: tuple[Path, Path]) -> None:
    library = f"lagdsl/engines/runtime/lib/{library_name(this_machine().partition('-')[0])}"
    assert packages[1].name.endswith(f"-{wheel_tag()}.whl")
    with zipfile.ZipFile(packages[1]) as archive:
        assert [name for name in archive.namelist() if name.startswith("lagdsl/engines/runtime/lib/")] == [library]
        (wheel,) = (name for name in archive.namelist() if name.endswith(".dist-info/WHEEL"))
        assert "Root-Is-Purelib: false" in archive.read(wheel).decode()
    with tarfile.open(packages[0]) as archive:
        assert not any("/runtime/lib/" in name or "/fmi/lib/" in name for name in archive.getnames())


def test_without_any_compiler_an_installed_package_has_its_runtime(site: Path, root: Path, tmp_path: Path) -> None:
    """No `cc` on the path, no ziglang to import, and nowhere to write."""
    (tmp_path / "none").mkdir()
    lame = "import sys; sys.modules['ziglang'] = None\n"
    environment = {"PYTHONPATH": str(site), "PATH": str(tmp_path / "none"), "HOME": "/nonexistent"}
    load = "from lagdsl.engines.runtime.library import runtime_library; print(len(runtime_library().methods))"
    assert _run([sys.executable, "-c", lame + load], tmp_path, **environment).strip() == "5"
    run = "from lagdsl.interfaces.cli.main import main; main(sys.argv[1:])"
    model = str(root / "models" / "pendulum.lag")
    out = _run([sys.executable, "-c", lame + run, "run", model, "-o", "/dev/stdout"], tmp_path, **environment)
    assert out.startswith("time,theta,der(theta)")


def test_the_build_asks_for_ziglang_where_it_makes_objects_or_no_compiler_is(root: Path, tmp_path: Path) -> None:
    ask = "from hatchling.build import get_requires_for_build_wheel as ask; print(ask())"
    with_compiler = _run([sys.executable, "-c", ask], root, PATH=os.environ["PATH"])
    sdist = _run([sys.executable, "-c", ask.replace("wheel", "sdist")], root, PATH=os.environ["PATH"])
    without = _run([sys.executable, "-c", ask], root, PATH=str(tmp_path))
    other = _run([sys.executable, "-c", ask], root, PATH=os.environ["PATH"], LAGDSL_PLATFORM="windows-x86_64")
    assert sdist.strip() == "[]"
    assert ("ziglang" in with_compiler) == (this_machine() in PLATFORMS)
    assert "ziglang" in without
    assert "ziglang" in other


def test_the_wheel_runs_a_model(site: Path, root: Path, tmp_path: Path) -> None:
    model = tmp_path / "pendulum.lag"
    model.write_text((root / "models" / "pendulum.lag").read_text())
    environment = {"PYTHONPATH": str(site), "PATH": os.environ["PATH"], "HOME": str(tmp_path)}
    paths = "print(lagdsl.__file__, r.grammar_file().is_file(), r.library_folder().is_dir())"
    code = f"import lagdsl; from lagdsl.foundation import resources as r; {paths}"
    where = _run([sys.executable, "-c", code], tmp_path, **environment).split()
    assert str(site) in where[0]
    assert where[1:] == ["True", "True"]
    lag = [sys.executable, "-m", "lagdsl"]
    assert "E0401" in _run([*lag, "explain", "E0401"], tmp_path, **environment)
    assert "rotor" in _run([*lag, "explain", "DCMotor"], tmp_path, **environment)
    parts = tmp_path / "four_bar.lag"
    _run([*lag, "new", "--from", "four_bar"], tmp_path, **environment)
    assert parts.read_text() == (root / "models" / "four_bar.lag").read_text()
    assert "1 degree of freedom" in _run([*lag, "check", str(parts)], tmp_path, **environment)
    out = _run(
        [*lag, "run", str(model), "--stop", "0.2", "--engine", "c", "-o", "/dev/stdout"], tmp_path, **environment
    )
    assert out.startswith("time,theta,der(theta)")


@repeats("tests/exchange/fmi/test_installed_objects.py")
@pytest.mark.skipif(zig_program() is None, reason="ziglang is not installed")
def test_the_first_fmu_of_a_wheel_compiles_the_model_only(site: Path, root: Path, tmp_path: Path) -> None:
    """With an empty cache. Files that read headers of the standard, which fmpy brings, are compiled with it, as one."""
    fmu, cache = tmp_path / "pendulum.fmu", tmp_path / "cache"
    environment = {"PYTHONPATH": str(site), "PATH": os.environ["PATH"], "HOME": str(tmp_path)}
    model = str(root / "models" / "pendulum.lag")
    _run(
        [sys.executable, "-m", "lagdsl", "fmu", model, "-o", str(fmu)],
        tmp_path,
        **environment,
        XDG_CACHE_HOME=str(cache),
    )
    with zipfile.ZipFile(fmu) as archive:
        names = archive.namelist()
    assert {"modelDescription.xml", "sources/Pendulum_fmu.c"} <= set(names)
    own = [name for name in names if name.endswith(".c") and name.startswith("sources/Pendulum")]
    assert len(list((cache / "lagdsl").glob("*.o"))) == len(own) + 1
