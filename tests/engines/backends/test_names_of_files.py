"""Models and members called like modules, keywords, headers and devices: generated files have names of their own."""

from __future__ import annotations

import ast
import keyword
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from sample_programs import pendulum

import lagdsl
from lagdsl.engines.backends.c.emit import stem_of
from lagdsl.engines.backends.registry import BACKENDS
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.commands.build import command
from lagdsl.motion.pipeline import check

TAKEN_BY_PYTHON = (
    *("math", "random", "string", "types", "typing", "collections", "ast", "numpy", "test", "Enum", "ABC", "site"),
    *("lambda", "class", "None", "match", "print", "float", "Aux", "nul", "COM1", "functools", "__future__"),
)
TAKEN_BY_C = (
    *("math", "string", "float", "double", "int", "restrict", "class", "new", "Bool", "main", "time", "features"),
    *("stdio", "assert", "windows", "vector", "version", "aux", "lpt9", "makefile", "lag", "fmi2Functions"),
)


@pytest.mark.parametrize("name", TAKEN_BY_PYTHON)
def test_name_of_the_module(name: str) -> None:
    (path,) = BACKENDS["numpy"].emit(pendulum(name)).files
    stem = path.removesuffix(".py")
    assert stem == f"model_{name}" and not keyword.iskeyword(stem)
    assert stem not in sys.stdlib_module_names


@pytest.mark.parametrize("name", TAKEN_BY_C)
def test_name_of_the_sources(name: str) -> None:
    program = pendulum(name)
    assert stem_of(program) == f"model_{name}"
    assert f"{name}.h" not in {Path(path).name for path in BACKENDS["c"].emit(program).files if "/" not in path}


@pytest.mark.parametrize("name", ["Pendulum", "pendulum", "Maths", "Doubles", "FourBar", "t", "q", "run"])
def test_other_names_stay(name: str) -> None:
    assert stem_of(pendulum(name)) == name
    assert list(BACKENDS["numpy"].emit(pendulum(name)).files) == [f"{name}.py"]


def test_modules_can_be_imported(tmp_path: Path) -> None:
    """A `math.py` hid the module that NumPy needs."""
    stems = []
    for name in ("math", "random", "types", "lambda", "numpy"):
        for path, text in BACKENDS["numpy"].emit(pendulum(name)).files.items():
            (tmp_path / path).write_text(text, encoding="utf-8")
            stems.append(path.removesuffix(".py"))
    imports = "; ".join(f"import {stem}" for stem in stems)
    subprocess.run([sys.executable, "-c", imports], cwd=tmp_path, check=True, capture_output=True)


_MEMBERS = (
    *("double", "t", "numpy", "np", "main", "p", "u", "w", "z", "int", "NULL", "INFINITY", "M_PI", "const", "None"),
    *("self", "lag_model", "evaluate", "FUNCTIONS", "return", "asm", "def", "True", "_", "__init__", "lambda"),
)


def test_members_have_any_name(tmp_path: Path) -> None:
    parameters = ", ".join(f"{name} = {k + 1}" for k, name in enumerate(_MEMBERS))
    text = f"""model Names
      parameter Real {parameters};
      coordinate Length q, sin, DEFAULTS;
      gravity = 0;
      mass 1 kg at {{q, sin, DEFAULTS}};
      force {{1 N, 2 N, 3 N}}*({" + ".join(_MEMBERS)}) at {{q, sin, DEFAULTS}};
    end Names;"""
    model = lagdsl.compile(text)
    total = len(_MEMBERS) * (len(_MEMBERS) + 1) / 2
    np.testing.assert_allclose(model.forward_dynamics(0.0, [0, 0, 0], [0, 0, 0]), total * np.arange(1, 4))
    compilation = check(SourceFile("Names.lag", text))[1]
    assert compilation is not None
    program = compilation.program
    (module,) = BACKENDS["numpy"].emit(program).files.values()
    ast.parse(module)
    (tmp_path / "lag").mkdir()
    for path, source in BACKENDS["c"].emit(program).files.items():
        if path.startswith("Names") or path.endswith(".h"):
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(source, encoding="utf-8")
    options = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-pedantic", "-I.", "-fsyntax-only"]
    subprocess.run(["cc", *options, "Names.c"], cwd=tmp_path, check=True, capture_output=True)


def test_the_mapping_is_told(tmp_path: Path) -> None:
    from click.testing import CliRunner

    path = tmp_path / "m.lag"
    path.write_text("model math coordinate Length x; gravity = 0; mass 1 kg at {x, 0}; end math;")
    for target, reason in (("numpy", "a module of Python"), ("c", "a header of the C library or of a system")):
        result = CliRunner().invoke(command, [str(path), "--target", target, "-o", str(tmp_path / target)])
        assert result.exit_code == 0, result.output
        assert f"note[N0910]: the files and constants of `math` are named `model_math`: `math` is {reason}" in (
            " ".join(result.output.split())
        )
