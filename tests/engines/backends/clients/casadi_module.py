"""Compares a module for CasADi with values: run by an interpreter that has CasADi.

casadi_module.py FOLDER MODULE VALUES.npz: prints the largest error of each function, relative to the largest value or
to 1.
"""

import importlib
import json
import sys

import numpy as np


def main(folder: str, module: str, values: str) -> None:
    sys.path.insert(0, folder)
    functions = importlib.import_module(module).functions
    given = np.load(values)
    worst: dict[str, float] = {}
    for name in given["functions"].tolist():
        arguments = [given[f"{name}/in/{k}"] for k in range(int(given[f"{name}/inputs"]))]
        for state in range(len(arguments[0])):
            found = functions[name](*(argument[state] for argument in arguments))
            for k, block in enumerate(found if isinstance(found, tuple) else (found,)):
                wanted = given[f"{name}/out/{k}"][state]
                worst[name] = max(worst.get(name, 0.0), error(np.array(block).reshape(wanted.shape), wanted))
    print(json.dumps(worst))


def error(found: np.ndarray, wanted: np.ndarray) -> float:
    finite = np.isfinite(wanted)
    if not np.array_equal(np.isfinite(found), finite):
        return float("inf")
    size = max(1.0, float(np.abs(wanted[finite]).max(initial=0.0)))
    return float(np.abs(found - wanted)[finite].max(initial=0.0)) / size


main(*sys.argv[1:])
