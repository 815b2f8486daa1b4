"""The extension for VS Code: what it takes from the compiler, and its protocol in node."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from lagdsl.interfaces.lsp.features.lenses import COMMANDS
from lagdsl.interfaces.lsp.snippets import snippets_text

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "editors" / "vscode"
MANIFEST = json.loads((FOLDER / "package.json").read_text(encoding="utf-8"))


def test_the_snippets_are_those_of_the_server() -> None:
    assert (FOLDER / "snippets" / "lag.json").read_text(encoding="utf-8") == snippets_text()


def test_every_file_that_the_manifest_names_is_there() -> None:
    given = MANIFEST["contributes"]
    files = [MANIFEST["icon"], *(each["path"] for kind in ("grammars", "snippets") for each in given[kind])]
    files += [language["configuration"] for language in given["languages"]]
    files += [step["media"]["markdown"] for walk in given["walkthroughs"] for step in walk["steps"]]
    assert [name for name in files if not (FOLDER / name).is_file()] == []
    json.loads((FOLDER / "language-configuration.json").read_text(encoding="utf-8"))


def test_the_commands_are_those_of_the_lenses() -> None:
    own = {each["command"] for each in MANIFEST["contributes"]["commands"]} - {"lagdsl.restart"}
    assert own == {f"{name}Model" for name in COMMANDS}
    source = (FOLDER / "src" / "extension.ts").read_text(encoding="utf-8")
    assert all(f'"{word}"' in source for word in COMMANDS.values())


def test_the_license_is_that_of_the_project() -> None:
    assert (FOLDER / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()


@pytest.mark.skipif(
    shutil.which("node") is None or not (FOLDER / "node_modules").is_dir(), reason="needs node and `npm ci`"
)
def test_the_language_client_speaks_with_the_server() -> None:
    environment = {**os.environ, "LAG": f"{sys.executable} -m lagdsl"}
    command = ["node", str(FOLDER / "test" / "client.mjs")]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr == ""
