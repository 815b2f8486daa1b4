"""Co-simulation of several FMUs, step by step in turn, in this process; it prints what they did, to the bit.

Their libraries are loaded first with all their symbols visible to all: the hardest case for those that share names.
"""

from __future__ import annotations

import ctypes
import json
import sys
from pathlib import Path

from fmpy.model_description import ModelDescription, read_model_description
from fmpy.simulation import instantiate_fmu

STEPS, H = 40, 0.05


class Member:
    """One instance and all its real outputs and states."""

    def __init__(self, folder: str) -> None:
        self.description: ModelDescription = read_model_description(folder, validate=False)
        self.two = self.description.fmiVersion.startswith("2")
        self.raw = instantiate_fmu(folder, self.description, fmi_type="CoSimulation")
        real = [v for v in self.description.modelVariables if v.type in ("Real", "Float64")]
        self.references = [v.valueReference for v in real if not v.dimensions]
        if self.two:
            self.raw.setupExperiment(startTime=0.0)
            self.raw.enterInitializationMode()
        else:
            self.raw.enterInitializationMode(startTime=0.0)
        self.raw.exitInitializationMode()

    def step(self, number: int) -> list[str]:
        self.raw.doStep(currentCommunicationPoint=number * H, communicationStepSize=H)
        values = self.raw.getReal(self.references) if self.two else self.raw.getFloat64(self.references)
        return [float(value).hex() for value in values]


def library(folder: str) -> Path:
    return next(path for path in Path(folder, "binaries").rglob("*") if path.suffix in (".so", ".dll", ".dylib"))


def main(folders: list[str]) -> None:
    libraries = [ctypes.CDLL(str(library(folder)), mode=ctypes.RTLD_GLOBAL) for folder in folders]
    members = [Member(folder) for folder in folders]
    rows = [[member.step(number) for member in members] for number in range(STEPS)]
    for member in members:
        member.raw.terminate()
        member.raw.freeInstance()
    assert len(libraries) == len(folders)
    json.dump([[row[k] for row in rows] for k in range(len(folders))], sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1:])
