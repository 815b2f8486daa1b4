"""Request to a client and its answer: two files of JSON, given on the command line.

Asked: `fmu`, `folder` (the same unpacked), `variables` with `references`, `step`, `count`. Answered: `version` of the
importer, `time`, `rows`. Clients run in an environment of their own that knows nothing of this project.
"""

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any


def answer(client: Callable[[dict[str, Any]], dict[str, Any]]) -> None:
    asked, told = (Path(argument) for argument in sys.argv[1:3])
    told.write_text(json.dumps(client(json.loads(asked.read_text()))))
