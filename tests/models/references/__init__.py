"""Motions by closed forms and by equations written down independently of the compiler.

Every function takes the parameters of a model by name, in SI units, and an array of times, and returns columns by name.
`tests/models/<model>.toml` names the function, its source and the tolerance.
"""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from models.references import fields, linkages, oscillators, pendulums, rolling, wires

Floats = NDArray[np.float64]
Reference = Callable[[Mapping[str, float], Floats], dict[str, Floats]]

REFERENCES: dict[str, Reference] = {
    name: function
    for module in (fields, linkages, oscillators, pendulums, rolling, wires)
    for name, function in vars(module).items()
    if callable(function) and getattr(function, "__module__", "") == module.__name__ and not name.startswith("_")
}
