"""The package python-control, which is loaded where it is asked for."""

from __future__ import annotations

from types import ModuleType


def python_control() -> ModuleType:
    """The module `control`. Raises ModuleNotFoundError with the way to install it."""
    try:
        import control
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(f"this needs python-control: pip install control ({missing})") from missing
    module: ModuleType = control
    return module


def signal_name(name: str) -> str:
    """The name that python-control has for a signal: it allows no dots, which part systems from signals."""
    return name.replace(".", "_")
