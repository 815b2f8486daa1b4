"""Options of `lag import`, by the kind of file that they are for."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record


@record(kw_only=True)
class RobotOptions:
    """Choices for a robot."""

    limits: Literal["range", "contact", "none"]
    actuators: Literal["file", "all", "none"]
    floating: bool
    lenient: bool
    root: Path | None

    def text(self, file: Path, sink: Sink, folder: Path) -> str | None:
        """The text for a file in `folder`; None after errors."""
        from lagdsl.exchange.robots.plan import Style
        from lagdsl.exchange.robots.read import robot_text

        choices = Style(limits=self.limits, actuators=self.actuators, floating=self.floating)
        return robot_text(file, choices, sink, folder, self.lenient, self.root)


@record(kw_only=True)
class BodyOptions:
    """Choices for a flexible body."""

    interfaces: tuple[str, ...]
    length_unit: Literal["m", "cm", "mm"] | None
    modes: int
    matrices: Path | None

    def text(self, file: Path, sink: Sink, name: str | None) -> str | None:
        """The text of a class `name`, or of the name of the file; None after errors."""
        from lagdsl.exchange.flexible.read import Reading, body_text

        reading = Reading(
            interfaces=self.interfaces, modes=self.modes, length_unit=self.length_unit, matrices=self.matrices
        )
        return body_text(file, reading, sink, name)
