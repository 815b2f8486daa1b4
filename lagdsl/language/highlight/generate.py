"""Writes the grammars of editors from that of the language: `python -m lagdsl.language.highlight.generate`."""

from __future__ import annotations

from pathlib import Path

from lagdsl.foundation.resources import grammar_file
from lagdsl.language.highlight import tree_sitter
from lagdsl.language.highlight.textmate import textmate

TEXTMATE = "editors/vscode/syntaxes/lag.tmLanguage.json"
TREE_SITTER = "editors/tree-sitter-lagdsl"


def files() -> dict[str, str]:
    """Texts of the generated files by their paths in the source tree."""
    return {
        TEXTMATE: textmate(),
        f"{TREE_SITTER}/grammar.js": tree_sitter.grammar(),
        f"{TREE_SITTER}/queries/highlights.scm": tree_sitter.highlights(),
        f"{TREE_SITTER}/src/units.h": tree_sitter.units(),
    }


def write(root: Path) -> None:
    """Write the files below the folder `root`."""
    for name, text in files().items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(grammar_file().parents[1])
