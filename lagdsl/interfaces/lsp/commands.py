"""Commands of the lenses: `lag run`, `derive`, `verify` of the text as it is in the editor."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

_ENDINGS = {"run": ".txt", "derive": ".html", "verify": ".txt"}
_LONGEST = 600  # seconds


def result_of(word: str, name: str, text: str, model: str) -> Path:
    """The file with what `lag WORD` says of `model` in `text`; `name` is the file of the text.

    The text is written beside that file while the command runs, so that it finds what lies there.
    """
    beside = Path(name).parent if Path(name).is_absolute() and Path(name).parent.is_dir() else None
    folder = Path(tempfile.mkdtemp(prefix="lag-"))
    result = folder / f"{model}-{word}{_ENDINGS[word]}"
    with tempfile.NamedTemporaryFile("w", suffix=".lag", prefix=".lag-", dir=beside, encoding="utf-8") as copy:
        copy.write(text)
        copy.flush()
        command = [sys.executable, "-m", "lagdsl", word, copy.name, "--model", model]
        if word == "derive":
            command += ["-o", str(result)]
        done = subprocess.run(
            command,
            check=False,
            capture_output=True,
            text=True,
            encoding="utf-8",
            timeout=_LONGEST,
            stdin=subprocess.DEVNULL,
        )
        if not result.is_file():
            said = (done.stdout + done.stderr).replace(copy.name, Path(name).name)
            result = result.with_suffix(".txt")
            result.write_text(said, encoding="utf-8")
    return result
