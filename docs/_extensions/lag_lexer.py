"""Colors for model texts: the lexer of Modelica with the words of this language."""

from __future__ import annotations

from pygments.lexers.modeling import ModelicaLexer
from pygments.token import Keyword, Name, Token
from sphinx.application import Sphinx

WORDS = frozenset(
    [
        "at",
        "body",
        "closure",
        "compliance",
        "contact",
        "coordinate",
        "damping",
        "dissipation",
        "draw",
        "force",
        "frame",
        "gravity",
        "invariant",
        "joint",
        "kinematics",
        "kinetic",
        "lagrangian",
        "mass",
        "on",
        "point",
        "potential",
        "restitution",
        "state",
        "structural",
        "torque",
        "with",
    ]
)


class LagLexer(ModelicaLexer):
    """`.lag` texts."""

    name = "lag"
    aliases = ("lag", "modelica")
    filenames = ("*.lag",)

    def get_tokens_unprocessed(self, text):  # type: ignore[no-untyped-def]
        """The tokens of Modelica, with the statements of mechanics as keywords."""
        for index, token, value in super().get_tokens_unprocessed(text):
            yield index, Keyword if token in (Name, Token.Name) and value in WORDS else token, value


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the lexer."""
    app.add_lexer("lag", LagLexer)
    app.add_lexer("modelica", LagLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
