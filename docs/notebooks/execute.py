"""Runs the notebooks of this folder and writes their outputs: `python docs/notebooks/execute.py`.

A living page is half a megabyte: it is written as its name. Pictures are PNG.
"""

from __future__ import annotations

import base64
import json
import os
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
_FORMS = ("text/plain", "text/html", "text/latex", "text/markdown")


def names() -> list[str]:
    """The notebooks of this folder."""
    return sorted(path.stem for path in HERE.glob("*.ipynb"))


def read(name: str) -> dict[str, Any]:
    """A notebook as it is stored."""
    found: dict[str, Any] = json.loads((HERE / f"{name}.ipynb").read_text(encoding="utf-8"))
    return found


def executed(notebook: dict[str, Any], *, pictures: bool = True) -> dict[str, Any]:
    """The notebook with the outputs of its cells, run in this process one after the other.

    Raises AssertionError for a cell that fails and is not tagged `raises-exception`. Without `pictures` figures are not
    drawn as PNG.
    """
    import matplotlib

    matplotlib.use("agg")
    from IPython.core.interactiveshell import InteractiveShell
    from IPython.utils.capture import capture_output

    InteractiveShell.clear_instance()
    shell = InteractiveShell.instance(colors="nocolor")
    shell.display_formatter.active_types = [*_FORMS, *(["image/png"] if pictures else [])]
    cells, number = [], 0
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            cells.append(cell)
            continue
        number += 1
        with capture_output() as captured:
            result = shell.run_cell("".join(cell["source"]), store_history=True)
        failed = "raises-exception" in cell["metadata"].get("tags", [])
        assert result.success is not failed, captured.stdout + captured.stderr
        outputs = [_displayed(each.data) for each in captured.outputs if not _is_bar(each.data)]
        if result.result is not None:
            data = _displayed(shell.display_formatter.format(result.result)[0])
            outputs.append({**data, "output_type": "execute_result", "execution_count": number})
        elif captured.stdout and not failed:
            outputs.insert(0, {"output_type": "stream", "name": "stdout", "text": _lines(captured.stdout)})
        cells.append({**cell, "execution_count": number, "outputs": [_ordered(each) for each in outputs]})
    return {**notebook, "cells": cells}


def _is_bar(data: dict[str, str]) -> bool:
    """True for a bar of progress, of which nothing is left in the end."""
    return "<progress" in data.get("text/html", "") or not data.get("text/plain")


def _displayed(data: dict[str, Any]) -> dict[str, Any]:
    kept = {form: text for form, text in data.items() if form in _FORMS and "<iframe" not in text}
    if "image/png" in data:
        kept["image/png"] = base64.b64encode(data["image/png"]).decode()
    return {"output_type": "display_data", **kept}


def _ordered(output: dict[str, Any]) -> dict[str, Any]:
    """An output in the form of nbformat 4."""
    if output["output_type"] == "stream":
        return output
    data = {form: _lines(text) for form, text in sorted(output.items()) if "/" in form}
    rest = {key: value for key, value in output.items() if "/" not in key}
    return {**rest, "data": data, "metadata": {}}


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


def main() -> None:
    """Run all notebooks."""
    os.chdir(HERE)
    for name in names():
        text = json.dumps(executed(read(name)), indent=1, ensure_ascii=False) + "\n"
        (HERE / f"{name}.ipynb").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
