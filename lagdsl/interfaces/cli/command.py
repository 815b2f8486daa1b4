"""One command: assignments that do not fit are wrong usage."""

from __future__ import annotations

from typing import Any

import click

from lagdsl.language.settings.failure import SettingError

# Options of other tools, with those that mean the same here; a command may have one of several.
_MEANT = {
    **dict.fromkeys(("t", "tstop", "tend", "t-end", "end", "duration", "time", "stop-time"), ("--stop",)),
    **dict.fromkeys(("dt", "step-size", "h"), ("--step", "--interval")),
    **dict.fromkeys(("tol", "rtol", "reltol", "abstol", "atol"), ("--tolerance",)),
    **dict.fromkeys(("method", "integrator"), ("--solver",)),
    **dict.fromkeys(("p", "param", "params", "parameter", "override"), ("--set",)),
    **dict.fromkeys(("out", "csv", "save"), ("--output",)),
}


def _meant(option: str) -> tuple[str, ...]:
    return _MEANT.get(option.lstrip("-").lower().replace("_", "-"), ())


class Command(click.Command):
    """A click command that leaves with status 2 where a text is no value of what it is assigned to, and that knows the
    usual slips of a command line: one dash for two, blanks without quotes, an option twice."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        given = list(args)
        try:
            rest = super().parse_args(ctx, args)
            self._require_once(ctx, given)
            return rest
        except click.NoSuchOption as error:
            long = [name for param in self.params for name in param.opts if f"-{name.lstrip('-')}" in given]
            if len(long) == 1 and long[0].startswith("--"):
                raise click.UsageError(f"options have two dashes: write `{long[0]}`", ctx) from error
            meant = [name for name in _meant(error.option_name) if any(name in param.opts for param in self.params)]
            if meant:
                raise click.UsageError(f"no option `{error.option_name}`; write `{meant[0]}`", ctx) from error
            raise
        except click.UsageError as error:
            if error.message.startswith("Got unexpected extra argument"):
                hint = "there is one FILE; a value with blanks stands in quotes, as in --set 'm=2 kg'"
                raise click.UsageError(f"{error.message.rstrip('.')}: {hint}", ctx) from error
            raise

    def _require_once(self, ctx: click.Context, given: list[str]) -> None:
        """Of an option that takes one value, two would be one too many: the first would be left out in silence."""
        _, _, order = self.make_parser(ctx).parse_args(args=given)
        values = [param for param in order if isinstance(param, click.Option) and not param.multiple]
        for param in values:
            if not param.is_flag and not param.count and values.count(param) > 1:
                raise click.UsageError(f"`{max(param.opts, key=len)}` is given twice", ctx)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except SettingError as error:
            raise click.UsageError(str(error), ctx) from error
