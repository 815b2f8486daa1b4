"""FMUs of models/, exported once in a run of the tests, as fmpy reads them."""

from __future__ import annotations

import atexit
import re
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import product
from pathlib import Path
from typing import Any
from unittest.mock import patch

import fmpy
import numpy as np
import pytest
from choice import ALL, EXPLORE, chosen
from fmpy.model_description import ModelDescription, ScalarVariable, read_model_description
from models.corpus import MODELS, compiled
from shared_folder import shared_folder

from lagdsl.engines.runtime.lock import locked
from lagdsl.exchange.fmi.export import export
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.motion.pipeline import Compilation

VERSIONS = (2, 3)
# One of each kind, where all of models/ would take too long.
SAMPLE = (
    "double_pendulum",  # minimal coordinates
    "four_bar",  # constraints, an input
    "pendulum_two_dependent_constraints",  # redundant rows
    "rolling_coin",  # nonholonomic
    "cart_double_pendulum",  # an input
    "bouncing_ball_modelica",  # relations, reinit
    "newtons_cradle",  # contacts
    "furuta_swing_up",  # a clock, sampled control
    "chain",  # arrays
    "van_der_pol",  # states of first order only, stiff
    "clutch",  # constraints that come and go
    "library/parts_with_play",  # components
    "servo_drive",  # ports of every kind
)
EVERY = tuple(MODELS) if EXPLORE else SAMPLE


def in_versions(names: Sequence[str]) -> pytest.MarkDecorator:
    """The test for each `name` in each `version` of the standard; in one of them where not all is run, the same in
    all tests: the same functions stand behind both, and tests share FMUs."""
    pairs = chosen(product(names, VERSIONS), [(name, _usual(name, i)) for i, name in enumerate(names)])
    return pytest.mark.parametrize(("name", "version"), pairs)


def _usual(name: str, otherwise: int) -> int:
    return VERSIONS[(SAMPLE.index(name) if name in SAMPLE else otherwise) % 2]


@dataclass(frozen=True)
class Exported:
    """An FMU, packed and unpacked."""

    path: Path
    folder: Path

    @cached_property
    def description(self) -> ModelDescription:
        return read_model_description(str(self.folder), validate=False)

    @cached_property
    def variables(self) -> dict[str, ScalarVariable]:
        return {variable.name: variable for variable in self.description.modelVariables}

    @property
    def version(self) -> int:
        return int(self.description.fmiVersion[0])

    def entry(self, name: str) -> tuple[ScalarVariable, int | None]:
        """The variable that holds a scalar, and where in it, if it is an array: `der(q[2])` is entry 1 of `der(q)`."""
        if name in self.variables:
            return self.variables[name], None
        found = re.fullmatch(r"(.*)\[([\d,]+)\](.*)", name)  # the last subscript; those before belong to components
        if found is None or found[1] + found[3] not in self.variables:
            raise KeyError(f"{self.path.name} has no variable for {name}")
        variable = self.variables[found[1] + found[3]]
        return variable, int(np.ravel_multi_index([int(i) - 1 for i in found[2].split(",")], variable.shape))

    def columns(self, recorded: Any, names: Iterable[str]) -> dict[str, np.ndarray]:
        """Scalars over time, out of what fmpy has recorded."""
        columns = {}
        for name in names:
            variable, index = self.entry(name)
            values = np.asarray(recorded[variable.name], dtype=float)
            columns[name] = values if index is None else values.reshape(len(values), -1)[:, index]
        return columns


_folder: list[tempfile.TemporaryDirectory[str]] = []


def place() -> Path:
    if not _folder:
        _folder.append(tempfile.TemporaryDirectory(prefix="lagdsl-fmi-"))
        atexit.register(_folder[0].cleanup)
    return Path(_folder[0].name)


@contextmanager
def quickly() -> Iterator[None]:
    """In `make check` FMUs are exported without their two hundred sources, which importers do not read, and are not
    tried out: the tests that ask for them run them. `test_package_export.py` shows whole ones."""
    with ExitStack() as quick:
        if not ALL:
            quick.enter_context(patch("lagdsl.exchange.fmi.export.source_files", return_value={}))
            quick.enter_context(patch("lagdsl.exchange.fmi.export.try_out"))
        yield


def export_quickly(compilation: Compilation, path: Path, **options: Any) -> None:
    """An FMU without its pages."""
    with quickly():
        export(compilation, path, documented=False, **options)


@cache
def exported(name: str, version: int, platforms: tuple[str, ...] = (), *, scalar: bool = False) -> Exported:
    """`scalar`: entries of arrays are variables of their own in FMI 3, too."""
    shared = shared_folder()
    folder = shared / "-".join((name.replace("/", "-"), str(version), *platforms, *["scalar"] * scalar))
    path = folder.with_suffix(".fmu")
    with locked(folder.with_suffix(".lock")):
        if not folder.exists():
            ports = Ports(scalar=scalar)
            export_quickly(compiled(name).compilation, path, version=version, platforms=platforms, ports=ports)
            with tempfile.TemporaryDirectory(dir=shared) as draft:
                fmpy.extract(str(path), str(Path(draft) / "fmu"))
                Path(draft, "fmu").replace(folder)
    return Exported(path, folder)
