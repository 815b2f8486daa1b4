"""Motions by closed forms and by equations written down independently of the compiler.

Every function takes the parameters of a model by name, in SI units, and an array of times, and returns columns by name.
`tests/models/<model>.toml` names the function, its source and the tolerance.
"""

import importlib
import pkgutil
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Reference = Callable[[Mapping[str, float], Floats], dict[str, Floats]]

REFERENCES: dict[str, Reference] = {
    name: function
    for module in (importlib.import_module(f"{__name__}.{found.name}") for found in pkgutil.iter_modules(__path__))
    for name, function in vars(module).items()
    if callable(function) and getattr(function, "__module__", "") == module.__name__ and not name.startswith("_")
}
