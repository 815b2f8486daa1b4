"""The functions of a program stand once: C is written from the table, and ctypes sees what C has."""

from __future__ import annotations

import ctypes
import re
from ctypes import Structure
from pathlib import Path

import pytest

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import ALONG_MANY, COUNTED, FUNCTIONS, OPTIONAL, SIGNATURES
from lagdsl.engines.runtime import generate, structures
from lagdsl.engines.runtime.building.build import build
from lagdsl.engines.runtime.engines.native_model import native_model
from lagdsl.engines.runtime.engines.one_state import VECTORS
from lagdsl.engines.runtime.headers import STRUCTURES, structures_text
from lagdsl.engines.runtime.structures import VERSION, WHAT, InitialFault, Model, SignalKind, Status
from lagdsl.foundation.resources import c_folder, sources_in

MIRRORED: dict[str, type[Structure]] = {name: getattr(structures, mirror) for name, (_, mirror) in STRUCTURES.items()}


def test_structures_are_those_of_the_headers() -> None:
    """`make update` writes them."""
    assert structures_text() == generate.STRUCTURES.read_text(encoding="utf-8")


@pytest.mark.parametrize("path", generate.texts(), ids=lambda path: path.name)
def test_generated_sections_are_those_of_the_table(path: Path) -> None:
    """`make update` writes them."""
    assert generate.texts()[path] == path.read_text(encoding="utf-8")


def test_a_file_without_marks_is_not_written(tmp_path: Path) -> None:
    path = tmp_path / "model.h"
    path.write_text("nothing\n")
    with pytest.raises(AssertionError, match=r"model\.h has no marks"):
        generate._with(path, "", "")


@pytest.fixture(scope="module")
def layouts() -> dict[str, list[tuple[int, int]]]:
    """For every structure its size, then the offsets and sizes of its members, as C has them."""
    headers = ["model.h", "batch.h", "call.h", "run.h", "initial.h", "ensemble.h", "signals.h", "hold.h"]
    headers.append("sensitivities/sensitivities.h")
    lines = ["#include <stddef.h>", *(f'#include "lag/{name}"' for name in headers)]
    for name, mirror in MIRRORED.items():
        members = [f"{{offsetof({name}, {field[0]}), sizeof((({name} *)0)->{field[0]})}}" for field in mirror._fields_]
        entries = ", ".join([f"{{sizeof({name}), {len(members)}}}", *members])
        lines.append(f"const size_t layout_of_{name}[][2] = {{{entries}}};")
    texts = {name: path.read_text() for name, path in sources_in(c_folder()).items() if path.suffix == ".h"}
    library = ctypes.CDLL(str(build({"layouts.c": "\n".join(lines) + "\n", **texts})))
    pair = ctypes.c_size_t * 2
    return {
        name: [tuple(row) for row in (pair * (1 + len(mirror._fields_))).in_dll(library, f"layout_of_{name}")]
        for name, mirror in MIRRORED.items()
    }


@pytest.mark.parametrize("name", MIRRORED)
def test_structures_lie_as_in_c(name: str, layouts: dict[str, list[tuple[int, int]]]) -> None:
    mirror = MIRRORED[name]
    fields = [getattr(mirror, field[0]) for field in mirror._fields_]
    assert layouts[name] == [(ctypes.sizeof(mirror), len(fields)), *((f.offset, f.size) for f in fields)]


@pytest.mark.parametrize(
    ("header", "kind", "names"),
    [
        ("status.h", "LAG", [each.name for each in Status]),
        ("initial.h", "LAG_INITIAL", [each.name for each in InitialFault]),
        ("signals.h", "LAG_SIGNAL", [each.name for each in SignalKind]),
        ("event_notice.h", "LAG", [each.upper() for each in WHAT]),
    ],
)
def test_enumerations_are_those_of_c(header: str, kind: str, names: list[str]) -> None:
    text = (c_folder() / "lag" / header).read_text(encoding="utf-8")
    (body,) = re.findall(
        r"typedef enum lag_\w+ \{(.*?)\n\}", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL), re.DOTALL
    )
    assert [entry.split("=")[0].strip() for entry in body.split(",")] == [f"{kind}_{name}" for name in names]


def test_the_table_is_whole() -> None:
    assert len({function.name for function in FUNCTIONS}) == len(FUNCTIONS) == len(SIGNATURES) + len(OPTIONAL)
    assert [function.name for function in FUNCTIONS] == [*SIGNATURES, *OPTIONAL]
    for function in FUNCTIONS:
        names = [result.name for result in function.results]
        assert len(set(names)) == len(names)
        for result in function.results:
            for length in result.shape:
                assert length in COUNTED or hasattr(Model, length), f"{length} of {function.name} is no member"
    assert {name for name in OPTIONAL if not hasattr(Model, name)} == set(ALONG_MANY)
    assert {ARGUMENT_NAMES[group] for group in VECTORS} | {"t"} == set(ARGUMENT_NAMES.values())
    assert Group.TIME not in VECTORS


def test_a_model_of_another_version_is_refused() -> None:
    with pytest.raises(OSError, match=f"version {VERSION + 1} of lag/model.h"):
        native_model(Model(version=VERSION + 1), None)
