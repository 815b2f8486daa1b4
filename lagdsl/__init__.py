"""A language and compiler for mechanics: Lagrange's equations from a page of text to motion.

`compile` turns a model text into a `Model` that computes accelerations, multipliers, energies and motions; `check`
lists what is wrong with a text. Names are loaded when they are first used, so that importing the package costs nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from lagdsl.foundation.version import __version__ as __version__

if TYPE_CHECKING:
    from lagdsl.foundation.diagnostics import CallRefused, CompilationFailed, Diagnostic, UnknownName
    from lagdsl.interfaces.api.check import check
    from lagdsl.interfaces.api.compile import compile
    from lagdsl.interfaces.api.fit import Fit
    from lagdsl.interfaces.api.imports import import_body, import_robot
    from lagdsl.interfaces.api.model import Model
    from lagdsl.interfaces.api.trajectory import Trajectory
    from lagdsl.motion.sessions.many import Sessions
    from lagdsl.motion.sessions.session import Session
    from lagdsl.motion.signals.hold import Hold
    from lagdsl.motion.signals.trajectory import Event
    from lagdsl.motion.simulate.control import control
    from lagdsl.motion.simulate.failure import SimulationFailed
    from lagdsl.motion.simulate.present import Present

_HOMES = {
    "CallRefused": "lagdsl.foundation.diagnostics",
    "CompilationFailed": "lagdsl.foundation.diagnostics",
    "Diagnostic": "lagdsl.foundation.diagnostics",
    "Event": "lagdsl.motion.signals.trajectory",
    "Fit": "lagdsl.interfaces.api.fit",
    "Hold": "lagdsl.motion.signals.hold",
    "Model": "lagdsl.interfaces.api.model",
    "Present": "lagdsl.motion.simulate.present",
    "Session": "lagdsl.motion.sessions.session",
    "Sessions": "lagdsl.motion.sessions.many",
    "SimulationFailed": "lagdsl.motion.simulate.failure",
    "Trajectory": "lagdsl.interfaces.api.trajectory",
    "UnknownName": "lagdsl.foundation.diagnostics",
    "check": "lagdsl.interfaces.api.check",
    "compile": "lagdsl.interfaces.api.compile",
    "control": "lagdsl.motion.simulate.control",
    "import_body": "lagdsl.interfaces.api.imports",
    "import_robot": "lagdsl.interfaces.api.imports",
    "load_ipython_extension": "lagdsl.interfaces.notebook.extension",
    "unload_ipython_extension": "lagdsl.interfaces.notebook.extension",
}

__all__ = [
    "CallRefused",
    "CompilationFailed",
    "Diagnostic",
    "Event",
    "Fit",
    "Hold",
    "Model",
    "Present",
    "Session",
    "Sessions",
    "SimulationFailed",
    "Trajectory",
    "UnknownName",
    "check",
    "compile",
    "control",
    "import_body",
    "import_robot",
]


def __getattr__(name: str) -> object:
    try:
        home = _HOMES[name]
    except KeyError:
        raise AttributeError(f"module 'lagdsl' has no attribute {name!r}") from None
    value = getattr(import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """The names that users complete; none of how the package is made."""
    return sorted([*__all__, "__version__", "__doc__"])
