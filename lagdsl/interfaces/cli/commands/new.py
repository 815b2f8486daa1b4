"""`lag new NAME`: a first model, or a copy of one that comes with lagdsl."""

from __future__ import annotations

import re
from pathlib import Path
from shlex import quote

import click

from lagdsl.interfaces.cli.output import Unwritable, write_text

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
@click.argument("name", required=False)
@click.option(
    "--from", "origin", metavar="MODEL", help="Start from a model that comes with lagdsl, for instance four_bar."
)
@click.option("--list", "listed", is_flag=True, help="List the models to start from.")
def command(name: str | None, origin: str | None, listed: bool) -> None:
    """Write NAME.lag, a small model that runs. An existing file is never overwritten.

    With --from MODEL the file is a copy of MODEL; without NAME it has the name of MODEL.
    """
    if listed:
        _list_models()
        return
    if name is None and origin is None:
        raise click.UsageError("give a NAME, or --from MODEL")
    path = _path(str(origin).rpartition("/")[2] if name is None else name)
    text = _text(origin, None if name is None else _model_name(path.stem))
    try:
        path.touch(exist_ok=False)
    except FileExistsError as error:
        raise click.UsageError(f"{path} exists already; choose another name") from error
    except OSError as error:
        raise Unwritable(path, error) from error
    try:
        write_text(text, path)
    except BaseException:
        path.unlink(missing_ok=True)
        raise
    click.echo(f"wrote {path}; next: lag run {quote(str(path))}")


def _path(name: str) -> Path:
    return Path(name if name.endswith(".lag") else f"{name}.lag")


def _text(origin: str | None, model: str | None) -> str:
    """The text of the new file; the model in it is called `model`, or as in the original."""
    if origin is None:
        return _TEMPLATE.format(name=model)
    from lagdsl.language.manual.models import UnknownModel, model_text, renamed

    try:
        text = model_text(origin)
    except UnknownModel as error:
        raise click.UsageError(str(error)) from error
    return text if model is None else renamed(text, model)


def _list_models() -> None:
    from lagdsl.language.manual.models import model_names, model_title

    names = model_names()
    width = max(map(len, names))
    for name in names:
        click.echo(f"{name:{width}}  {model_title(name)}")


def _model_name(stem: str) -> str:
    """`my-first model` becomes `MyFirstModel`."""
    words = re.findall(r"[A-Za-z0-9_]+", stem)
    name = "".join(word[:1].upper() + word[1:] for word in words)
    if stem.startswith(".") or not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name):
        raise click.UsageError(f"`{stem}` is not a valid model name; it must begin with a letter")
    return name
