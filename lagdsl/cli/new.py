"""`lag new NAME`: a first model to start from."""

from __future__ import annotations

import re
from pathlib import Path
from shlex import quote

import click

from lagdsl.cli.output import Unwritable

_TEMPLATE = """\
model {name} "Point mass on a massless rod"
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg) "from the downward vertical";
  point P = l*{{sin(theta), -cos(theta)}};
  gravity = -g_n*world.y;
  mass m at P;
  draw rod from world.origin to P;
  invariant E: energy();
  annotation(experiment(StopTime = 10, Tolerance = 1e-9));
end {name};
"""


@click.command("new")
@click.argument("name")
def command(name: str) -> None:
    """Write NAME.lag, a small model that runs. An existing file is never overwritten."""
    path = Path(name if name.endswith(".lag") else f"{name}.lag")
    model = _model_name(path.stem)
    try:
        with path.open("x", encoding="utf-8", newline="\n") as file:
            file.write(_TEMPLATE.format(name=model))
    except FileExistsError as error:
        raise click.UsageError(f"{path} exists already; choose another name") from error
    except OSError as error:
        raise Unwritable(path, error) from error
    click.echo(f"wrote {path}; next: lag run {quote(str(path))}")


def _model_name(stem: str) -> str:
    """`my-first model` becomes `MyFirstModel`."""
    words = re.findall(r"[A-Za-z0-9_]+", stem)
    name = "".join(word[:1].upper() + word[1:] for word in words)
    if stem.startswith(".") or not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name):
        raise click.UsageError(f"`{stem}` makes no model name; it must begin with a letter")
    return name
