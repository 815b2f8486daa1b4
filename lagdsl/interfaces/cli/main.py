"""The group of commands and what is common to all: exit statuses, interrupts, broken pipes."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import NoReturn

import click

from lagdsl.foundation.version import __version__
from lagdsl.interfaces.cli.status import INTERNAL, INTERRUPTED, SUCCESS, USAGE

# Commands by name and what `lag --help` says of each; the module is loaded when the command is used.
_COMMANDS = {
    "check": "Find all errors of a model.",
    "run": "Simulate a model.",
    "show": "Show a machine moving, with sliders and equations, on a page.",
    "sweep": "Simulate a model many times, over values of parameters and starts.",
    "fit": "Find parameters and starts from measured motions.",
    "sensitivity": "Show how the end of a motion changes with parameters and starts.",
    "linearize": "Show the matrices of the motion about a state.",
    "modes": "Show frequencies, damping, mode shapes, stability and thresholds.",
    "bode": "Show a frequency response, with poles, zeros and margins.",
    "trim": "Find an equilibrium.",
    "verify": "Compare results that can be computed in two ways.",
    "derive": "Show the derivation of the equations of motion, step by step.",
    "build": "Write the equations as a module that stands alone.",
    "fmu": "Write the model as an FMU, for other tools to run.",
    "flat": "Show the flat model: coordinates, energies, loads, constraints.",
    "fmt": "Format model texts in place.",
    "explain": "Show the manual page of a diagnostic or a component.",
    "import": "Write the model of a robot from its URDF or MJCF file.",
    "lsp": "Run the language server for editors.",
    "new": "Write a first model, or a copy of one that comes with lagdsl.",
}
# Commands of other tools, and the one that is meant.
_MEANT = {
    **dict.fromkeys(("simulate", "sim", "solve", "integrate", "start", "exec"), "lag run"),
    **dict.fromkeys(("plot", "draw", "graph"), "lag run --plot motion.png"),
    **dict.fromkeys(("animate", "view", "display", "open", "page", "play", "visualize"), "lag show"),
    **dict.fromkeys(("compile", "validate", "test", "parse", "lint"), "lag check"),
    **dict.fromkeys(("format", "pretty"), "lag fmt"),
    **dict.fromkeys(("flatten", "instantiate", "expand"), "lag flat"),
    **dict.fromkeys(("export", "fmi"), "lag fmu"),
    **dict.fromkeys(("generate", "codegen", "translate"), "lag build --target c -o DIR"),
    **dict.fromkeys(("equations", "lagrange", "latex"), "lag derive"),
    **dict.fromkeys(("eigen", "eig", "eigenvalues", "stability", "frequencies"), "lag modes"),
    **dict.fromkeys(("margins", "margin", "nyquist", "frequency", "transfer"), "lag bode"),
    **dict.fromkeys(("equilibrium", "steady"), "lag trim"),
    **dict.fromkeys(("create", "init"), "lag new"),
    **dict.fromkeys(("man", "doc", "docs", "info"), "lag explain"),
    **dict.fromkeys(("scan", "study", "ensemble"), "lag sweep"),
    **dict.fromkeys(("calibrate", "identify", "estimate", "sysid", "regress"), "lag fit"),
    **dict.fromkeys(("gradient", "gradients", "derivatives", "sensitivities"), "lag sensitivity"),
    "help": "lag --help",
    "version": "lag --version",
}
_MODULES = {"import": "import_"}  # a module cannot have the name of a Python keyword
_OBJECTS_PER_COLLECTION = 100_000


class Commands(click.Group):
    """Loads a command when it is used, so that no command pays for another."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in _COMMANDS:
            return None
        module = import_module(f"lagdsl.interfaces.cli.commands.{_MODULES.get(cmd_name, cmd_name)}")
        command: click.Command = module.command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in _COMMANDS and not args[0].startswith("-"):
            from lagdsl.foundation.diagnostics.suggest import nearest

            likely = nearest(args[0], _COMMANDS)
            if args[0].endswith(".lag"):
                ctx.fail(f"the command comes first: lag run {args[0]}")
            if args[0] in _MEANT:
                ctx.fail(f"no command `{args[0]}`; write `{_MEANT[args[0]]}`")
            ctx.fail(f"no command `{args[0]}`" + (f"; did you mean `{likely}`?" if likely else ""))
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(_COMMANDS.items()))


@click.command(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="lag")
def lag() -> None:
    """Compile and simulate mechanical models, written as `.lag` texts."""


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run `lag` and leave with its status; whatever happens, no Python traceback."""
    _open_closed_streams()
    # Start-up makes many objects that stay; looking through them for cycles again and again takes a tenth of its time.
    gc.set_threshold(_OBJECTS_PER_COLLECTION)
    # The matrices are small: threads of the linear algebra would spend their time waiting for each other.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    sys.exit(_status(arguments))


def _status(arguments: Sequence[str] | None) -> int:
    try:
        status = lag.main(args=arguments, prog_name="lag", standalone_mode=False)
        sys.stdout.flush()
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        click.echo("interrupted", err=True)
        return INTERRUPTED
    except (BrokenPipeError, SystemExit):  # click leaves by itself when the reader of a pipe has gone
        _silence_standard_output()
        return SUCCESS
    except OSError as error:
        if error.filename is not None:  # not one of the standard streams
            return _internal_error(error)
        _silence_standard_output()
        _complain(f"cannot write standard output: {error.strerror}")
        return USAGE
    except Exception as error:
        return _internal_error(error)
    return status if isinstance(status, int) else SUCCESS


def _open_closed_streams() -> None:
    """A stream that was closed before we began is None in Python; what goes there is lost."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115 as long as the process


def _silence_standard_output() -> None:
    """Nobody reads any more: let the interpreter's last flush go nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _complain(text: str) -> None:
    with suppress(OSError):  # standard error may be as full
        click.echo(text, err=True)


def _internal_error(error: Exception) -> int:
    import traceback

    place = traceback.extract_tb(error.__traceback__)[-1]
    click.echo(f"internal error: {type(error).__name__}: {error} ({place.filename}:{place.lineno})", err=True)
    click.echo("This is a fault of lagdsl, not of your model. Please report it with the model text.", err=True)
    return INTERNAL
