"""In a process of its own: takes the bytes of a state from a file, goes on, prints what comes, exactly.

python -m fmi.continued FOLDER STATE BEGIN STEP COUNT NAME ...
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from fmi.importing import Exported, slave


def main(folder: str, state: str, begin: str, step: str, count: str, *names: str) -> None:
    fmu = Exported(Path(folder + ".fmu"), Path(folder))
    with slave(fmu) as again:
        again.initialize()
        again.restore(Path(state).read_bytes())
        times = float.fromhex(begin) + float.fromhex(step) * np.arange(int(count) + 1)
        for row in again.rows(names, times):
            print(*(value.hex() for value in row))


if __name__ == "__main__":
    main(*sys.argv[1:])
