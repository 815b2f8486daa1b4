"""Assignments that a model does not take."""

from __future__ import annotations

_LONGEST = 60


class SettingError(ValueError):
    """A text that is no value of what it is assigned to."""


class UnknownSettingError(SettingError):
    """A name that the model does not have, or that cannot be set."""


def short(text: str) -> str:
    """As much of what was typed as a message can hold."""
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
