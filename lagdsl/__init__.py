"""A language and compiler for mechanics: Lagrange's equations from a page of text to motion.

`compile` turns a model text into a `Model` that computes accelerations, multipliers, energies and motions; `check`
lists what is wrong with a text. Names are loaded when they are first used, so that importing the package costs nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from lagdsl.version import __version__ as __version__

if TYPE_CHECKING:
    from lagdsl.api.check import check
    from lagdsl.api.compile import compile
    from lagdsl.api.import_robot import import_robot
    from lagdsl.api.model import Model
    from lagdsl.api.trajectory import Trajectory
    from lagdsl.diagnostics import CallRefused, CompilationFailed, Diagnostic, UnknownName
    from lagdsl.sessions.many import Sessions
    from lagdsl.sessions.session import Session
    from lagdsl.signals.hold import Hold
    from lagdsl.signals.trajectory import Event
    from lagdsl.simulate.control import control
    from lagdsl.simulate.failure import SimulationFailed
    from lagdsl.simulate.present import Present

_HOMES = {
    "CallRefused": "lagdsl.diagnostics",
    "CompilationFailed": "lagdsl.diagnostics",
    "Diagnostic": "lagdsl.diagnostics",
    "Event": "lagdsl.signals.trajectory",
    "Hold": "lagdsl.signals.hold",
    "Model": "lagdsl.api.model",
    "Present": "lagdsl.simulate.present",
    "Session": "lagdsl.sessions.session",
    "Sessions": "lagdsl.sessions.many",
    "SimulationFailed": "lagdsl.simulate.failure",
    "Trajectory": "lagdsl.api.trajectory",
    "UnknownName": "lagdsl.diagnostics",
    "check": "lagdsl.api.check",
    "compile": "lagdsl.api.compile",
    "control": "lagdsl.simulate.control",
    "import_robot": "lagdsl.api.import_robot",
    "load_ipython_extension": "lagdsl.notebook.extension",
    "unload_ipython_extension": "lagdsl.notebook.extension",
}

__all__ = [
    "CallRefused",
    "CompilationFailed",
    "Diagnostic",
    "Event",
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
