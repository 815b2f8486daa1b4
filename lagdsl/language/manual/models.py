"""The models that come with the compiler, to start from: `lag new --from four_bar`."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.resources import models_folder
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse


class UnknownModel(LookupError):  # noqa: N818 named after what it says
    """No model of this name comes with the compiler; `suggestion` is the nearest name or None."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name
        self.suggestion = nearest(name, model_names())

    def __str__(self) -> str:
        text = f"no model `{self.name}` comes with lagdsl"
        return f"{text}; " + (
            f"did you mean `{self.suggestion}`?" if self.suggestion else "`lag new --list` lists them"
        )


def model_names() -> tuple[str, ...]:
    """`four_bar`, `robots/ur5`, `library/dc_motor`: mechanisms, then imported arms, then one for each component."""
    root = models_folder()
    files = [file for folder in ("", "robots/", "library/") for file in sorted(root.glob(f"{folder}*.lag"))]
    return tuple(path.relative_to(root).with_suffix("").as_posix() for path in files)


def model_text(name: str) -> str:
    """The text of the model `name`, with or without `.lag` and folder. Raises UnknownModel."""
    plain = name.removesuffix(".lag")
    for known in model_names():
        if plain in (known, known.rpartition("/")[2]):
            return (models_folder() / f"{known}.lag").read_text(encoding="utf-8")
    raise UnknownModel(name)


def model_title(name: str) -> str:
    """The doc string of the model `name`."""
    return _main_class(model_text(name)).doc or ""


def renamed(text: str, name: str) -> str:
    """The text with its last class, which is the one that runs, called `name`."""
    main = _main_class(text)
    places = [main.name_span]
    if main.end_name is not None:
        start = main.span.start + main.span.text.rindex(main.end_name)
        places.append(Span(main.span.file, start, start + len(main.end_name)))
    for place in reversed(places):
        text = text[: place.start] + name + text[place.end :]
    return text


def _main_class(text: str) -> nodes.Class:
    sink = Sink()
    unit = parse(SourceFile("model", text), sink)
    assert unit is not None, sink.diagnostics
    return next(item for item in reversed(unit.items) if isinstance(item, nodes.Class))
