"""`--input`: values of inputs by name, and tables in files."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.model_file import Format, leave_with_errors, tell
from lagdsl.interfaces.cli.options import InputOptions
from lagdsl.interfaces.cli.status import USAGE
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.settings import constants, split
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.table_io import Tables, in_si, read_inputs


@record()
class Inputs:
    """Arguments of `--input`: tables by name, and texts of values by name; with `hold` tables keep their values between
    the rows."""

    tables: Tables
    values: dict[str, str]
    hold: bool = False

    def of(self, flat: FlatModel, sink: Sink, style: Format) -> dict[str, Signal]:
        """All of them for this model; leaves with status 1 where units of tables do not fit. Raises SettingError for
        names and values that do not fit."""
        found = {**in_si(self.tables, flat, sink, hold=self.hold), **constants(flat, self.values, sink)}
        if sink.has_errors:
            leave_with_errors(sink.diagnostics, style)
        return found


_WAY = "check the name of the file; the value of an input is written NAME=VALUE"


def inputs_or_leave(options: InputOptions, style: Format) -> Inputs:
    """Assignments and files of `--input`; leaves with status 2 where a file cannot be read. Raises SettingError."""
    tables: Tables = {}
    values = split([text for text in options.given if _is_assignment(text)])
    for text in options.given:
        if _is_assignment(text):
            continue
        sink = Sink()
        found = read_inputs(Path(text), sink, way=_WAY)
        tell(sink.diagnostics, style)
        if found is None:
            click.get_current_context().exit(USAGE)
        twice = [name for name in found if name in tables or name in values]
        if twice:
            raise SettingError(f"--input {text}: `{twice[0]}` is given twice")
        tables |= found
    return Inputs(tables, values, options.held)


def _is_assignment(text: str) -> bool:
    """A file may have an equals sign in its name."""
    try:
        return "=" in text and not Path(text).exists()
    except (OSError, ValueError):  # no file has such a name: it is too long, or holds a zero
        return True
