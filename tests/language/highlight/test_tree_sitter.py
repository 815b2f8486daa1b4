"""The grammar of tree-sitter: it reads every text that the parser accepts, and its queries colour it alike.

Its generator makes a parser in C: the test needs `tree-sitter` of tree-sitter-cli, a C compiler and the package
tree-sitter.
"""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from typing import Any

import pytest

from highlight.kinds_of_texts import GAP, ROOT, TRAPS, as_the_parser_reads, texts
from lagdsl.language.highlight.generate import TREE_SITTER
from lagdsl.language.highlight.rules import Kind

tree_sitter = pytest.importorskip("tree_sitter", reason="pip install tree-sitter")
GENERATOR = shutil.which("tree-sitter")
COMPILER = shutil.which("cc")
pytestmark = pytest.mark.skipif(GENERATOR is None or COMPILER is None, reason="needs tree-sitter-cli and a C compiler")

KINDS = {
    "comment": Kind.COMMENT,
    "string": Kind.STRING,
    "number": Kind.NUMBER,
    "type.builtin": Kind.UNIT,
    "keyword": Kind.KEYWORD,
    "boolean": Kind.LITERAL,
    "operator": Kind.OPERATOR,
    "punctuation.delimiter": Kind.MARK,
    "punctuation.bracket": Kind.MARK,
    "variable": Kind.NAME,
    "type": Kind.NAME,
    "function": Kind.NAME,
}


@pytest.fixture(scope="module")
def language(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The language, generated and compiled."""
    folder = tmp_path_factory.mktemp("tree_sitter") / "tree-sitter-lagdsl"
    shutil.copytree(ROOT / TREE_SITTER, folder)
    assert GENERATOR is not None
    assert COMPILER is not None
    subprocess.run([GENERATOR, "generate"], cwd=folder, check=True, capture_output=True)
    sources = ["src/parser.c", "src/scanner.c"]
    command = [COMPILER, "-shared", "-fPIC", "-Isrc", *sources, "-o", "lagdsl.so", "-Wall", "-Wextra", "-Werror"]
    subprocess.run(command, cwd=folder, check=True)
    library = ctypes.CDLL(str(folder / "lagdsl.so"))
    library.tree_sitter_lagdsl.restype = ctypes.c_void_p
    capsule = ctypes.pythonapi.PyCapsule_New
    capsule.restype, capsule.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return tree_sitter.Language(capsule(library.tree_sitter_lagdsl(), b"tree_sitter.Language", None))


def test_every_text_is_read_and_coloured_as_the_parser_reads_it(language: Any) -> None:
    parser = tree_sitter.Parser(language)
    query = tree_sitter.Query(language, (ROOT / TREE_SITTER / "queries" / "highlights.scm").read_text(encoding="utf-8"))
    read = 0
    for name, text in (texts() | {f"trap {number}": trap for number, trap in enumerate(TRAPS)}).items():
        kinds = as_the_parser_reads(text)
        if kinds is None:
            continue
        tree, read = parser.parse(text.encode()), read + 1
        assert not tree.root_node.has_error, (name, str(tree.root_node)[:400])
        wanted = [kind for kind, character in zip(kinds, text, strict=True) for _ in character.encode()]
        found = [GAP] * len(wanted)
        for capture, nodes in tree_sitter.QueryCursor(query).captures(tree.root_node).items():
            for node in nodes:
                found[node.start_byte : node.end_byte] = [KINDS[capture]] * (node.end_byte - node.start_byte)
        blanks = [character.isspace() for character in text for _ in character.encode()]
        wrong = [at for at, blank in enumerate(blanks) if not blank and found[at] != wanted[at]]
        assert not wrong, (name, text.encode()[max(wrong[0] - 40, 0) : wrong[0] + 20])
    assert read > 600


@pytest.mark.parametrize("text", ["force on q;", "parameter = 3;", "mass 1 kg at;", "Length x = 5 6;"])
def test_what_the_parser_refuses_is_an_error(language: Any, text: str) -> None:
    tree = tree_sitter.Parser(language).parse(f"model A\n  {text}\nend A;\n".encode())
    assert tree.root_node.has_error


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("5 m", "m"),
        ("5m", "m"),
        ("5 m/s2", "m/s2"),
        ("5 m/x", "m"),
        ("5 /s", "/s"),
        ("5 / s", None),
        ("5/s", None),
        ("5 kg.m2/s^-2", "kg.m2/s^-2"),
        ("5 m.x", "m"),
        ("5 m2 + 4", "m2"),
        ("5 mass", None),
        ("5 m^x", None),
    ],
)
def test_units_are_those_of_the_lexer(language: Any, text: str, unit: str | None) -> None:
    """The scanner ends a unit where the terminal QUANTITY ends."""
    tree = tree_sitter.Parser(language).parse(f"model A\n  Real k = {text};\nend A;\n".encode())
    found = tree_sitter.QueryCursor(tree_sitter.Query(language, "(unit) @unit")).captures(tree.root_node)
    assert [node.text.decode() for node in found.get("unit", [])] == ([] if unit is None else [unit])
