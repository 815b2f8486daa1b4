"""The table of variables as C reads it is the one of descriptions, and it covers every array of the model."""

from __future__ import annotations

import subprocess
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from choice import paired, spread

from fmi.described import of_text, table_of, table_of_model, table_of_text
from fmi.test_descriptions import EVERYTHING, SAMPLE
from lagdsl.engines.runtime.building.compiler import find_compiler
from lagdsl.exchange.fmi.description.table import table_source
from lagdsl.exchange.fmi.variables.builtin_variables import indicator_count
from lagdsl.exchange.fmi.variables.scalar import Role
from lagdsl.exchange.fmi.variables.variables import Table, Version
from lagdsl.foundation.resources import c_folder, fmi_folder
from lagdsl.language.flat.model import Definition

VERSIONS = pytest.mark.parametrize("version", [2, 3])
# In the order of lag/fmu.h.
ROLES = list(Role)
TYPES = ["REAL", "INTEGER", "BOOLEAN", "STRING", "ENUMERATION"]
SETTINGS = ["NEVER", "START", "TUNABLE", "ALWAYS"]
STRICT = ("-std=c11", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", "-Wshadow", "-O0")
HEADER = '#include "lag/model.h"\nextern const lag_model Model_model;\nextern const lag_start Model_start;\n'


def printed(given: Table, folder: Path, token: str = "{1}") -> dict[str, list[list[str]]]:
    """Lines of the program by their first word."""
    layout = given.program.layout
    states = 2 * len(layout.coordinates) + len(layout.states)
    sizes = [
        states,
        *map(len, (layout.constraints, layout.inputs, layout.outputs, layout.invariants, layout.parameters)),
    ]
    files = {
        "Model.h": HEADER,
        "Model_fmu.c": table_source(given, "Model", token),
        "rest.c": '#include "Model.h"\nextern const size_t sizes[6];\n'
        f"const size_t sizes[6] = {{{str(sizes)[1:-1]}}};\n"
        "const lag_model Model_model = {0};\nconst lag_start Model_start = {0};\n",
    }
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    includes = [f"-I{folder}", f"-I{c_folder()}", f"-I{fmi_folder()}"]
    sources = [folder / "Model_fmu.c", folder / "rest.c", Path(__file__).with_name("print_table.c")]
    subprocess.run([*find_compiler().command, *STRICT, *includes, *sources, "-o", folder / "print"], check=True)
    text = subprocess.run([folder / "print"], check=True, capture_output=True).stdout.decode()
    found: dict[str, list[list[str]]] = {}
    for line in text.splitlines():
        word, _, rest = line.partition(" ")
        found.setdefault(word, []).append(rest.split(" ") if rest else [])
    return found


def numbers(line: list[str]) -> list[float]:
    return [float.fromhex(word) if word[-1] != "f" else float(word) for word in line]


@VERSIONS
def test_the_table_is_that_of_the_description(version: Version, tmp_path: Path) -> None:
    given = table_of_text(EVERYTHING, version)
    found = printed(given, tmp_path)
    assert found["token"] == [["{1}"]]
    for variable, (role, kind, setting, first, count, *constants) in zip(
        given.variables, found["variable"], strict=True
    ):
        attributes = variable.attributes
        assert ROLES[int(role)] is attributes.role
        whole = {"ENUMERATION": "INTEGER"} if version == 2 else {}
        assert TYPES[int(kind)] == whole.get(attributes.type, attributes.type)
        assert SETTINGS[int(setting)] == attributes.setting
        assert (int(first), int(count)) == (variable.first, variable.count)
        if attributes.role is Role.CONSTANT:
            assert numbers(constants) == [float(start) for start in variable.starts]
    settings = given.settings
    for name, values in (
        ("nominal", settings.nominal),
        ("group", settings.groups),
        ("natural", settings.natural),
        ("cap", settings.caps),
        ("row_sizes", settings.row_sizes),
        ("lasting", settings.lasting),
    ):
        assert numbers(found[name][0]) == [float(value) for value in values]
    # road, its rate and its second rate are the inputs 1, 2 and 3 of 4
    names = [slot.name for slot in given.program.layout.parameters]
    ranges = {name: numbers(line) for name, line in zip(names, found["range"], strict=True)}
    assert ranges["teeth"] == [1, 99] and ranges["gears[2]"] == [1, 2] and ranges["l"] == [-np.inf, np.inf]
    assert found["input_rates"] == [["4", "2", "3", "4"]]
    assert numbers(found["experiment"][0]) == [0.0, 10.0, 1e-8]
    assert found["general"] == [["2"]] and found["kinds"] == [["3"]]


@pytest.mark.parametrize(("name", "version"), paired([*spread(SAMPLE, 5), None], [2, 3]))
def test_every_entry_of_the_model_is_there_once(name: str | None, version: Version) -> None:
    """But for what is protected, the coordinates of cut joints, which are outputs and definitions, and clocks and
    relations of w."""
    given = table_of_text(EVERYTHING, version) if name is None else table_of_model(name, version)
    layout, flat = given.program.layout, given.flat
    entries = {
        role: Counter(i for _, v in given.of(role) if v.attributes.type != "STRING" for i in v.entries) for role in Role
    }
    n, nz = len(layout.coordinates), len(layout.states)
    quantities = (*flat.parameters, *flat.outputs, *flat.events.discretes, *flat.observed)
    definitions = [item for item in flat.named if isinstance(item, Definition)]
    hidden = {item.name for item in (*quantities, *definitions) if item.protected}
    absent = {output.name for output in flat.outputs} | hidden
    independent, settled = layout.parameters, [p for p in flat.parameters if p.structural and p.kind != "String"]
    following = [each.place + first for first in (0, n) for each in given.dependent]
    whole = {
        Role.PARAMETER: [i for i, slot in enumerate(independent) if slot.name not in hidden],
        Role.CONSTANT: [i for i, parameter in enumerate(settled) if parameter.name not in hidden],
        Role.STATE: [i for i in range(2 * n + nz) if i not in following],
        Role.DEPENDENT: following,
        Role.DERIVATIVE: range(n, 2 * n + nz),
        Role.INPUT: range(len(layout.inputs)),
        Role.OUTPUT: [i for i, slot in enumerate(layout.outputs) if slot.name not in hidden],
        Role.LOCAL: [i for i, slot in enumerate(layout.definitions) if slot.name not in absent],
        Role.DISCRETE: [
            i
            for i, (kind, slot) in enumerate(zip(layout.kinds, layout.discretes, strict=True))
            if kind in ("variable", "contact", "impacts") and slot.name not in hidden
        ],
        Role.MULTIPLIER: range(len(layout.constraints)),
        Role.INDICATOR: range(indicator_count(flat, given.program) if version == 3 else 0),
        Role.ENERGY: range(3),
        Role.RESIDUAL: range(2 if layout.constraints else 0),
    }
    for role, expected in whole.items():
        assert entries[role] == Counter(expected), role
    assert [v.starts for _, v in given.of(Role.PARAMETER)]
    entries_of_x = [v for v in given.variables if v.attributes.role in (Role.STATE, Role.DEPENDENT)]
    assert [start for v in entries_of_x for start in v.starts] == list(given.settings.start.x)


def test_texts_and_limits_reach_c(tmp_path: Path) -> None:
    text = """model Texts "quotes in constants"
      structural parameter String way = "a \\"b\\" \\\\ %d ??/ é";
      constant Real c = 0.1;
      coordinate Length x; gravity = 0; mass 1 kg at {x, 0};
      invariant p: der(x) with tol = 1e-3;
      invariant r: der(x)^2;
    end Texts;"""
    found = printed(table_of(of_text(text), 2, ("cs",)), tmp_path)
    constants = [line[5:] for line in found["variable"] if ROLES[int(line[0])] is Role.CONSTANT]
    assert " ".join(constants[0]) == 'a "b" \\ %d ??/ é'
    assert numbers(constants[1]) == [0.1]
    assert numbers(found["invariant_limits"][0]) == [1e-3, 0.0]
    assert found["kinds"] == [["2"]]


def test_accuracy_is_measured_as_in_simulations() -> None:
    """Rows that come and go do not count as lasting; angles have size one at most."""
    given = table_of_model("newtons_cradle", 2)
    assert not any(given.settings.lasting) and given.settings.general == 0
    four_bar = table_of_model("four_bar", 2).settings
    angles = [c.dimension.is_dimensionless for c in table_of_model("four_bar", 2).flat.coordinates]
    assert np.isfinite(four_bar.caps[: len(angles)]).tolist() == angles
    assert all(four_bar.lasting) and four_bar.general == 2  # three angles, one degree of freedom
