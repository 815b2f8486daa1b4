"""Programs for packages that stand in an environment of their own: `make peers`, or PEERS=folder of a virtual one."""

from __future__ import annotations

import os
import subprocess
from functools import cache
from pathlib import Path

PEERS = Path(os.environ.get("PEERS", ".peers")) / "bin" / "python"


@cache
def has(package: str) -> bool:
    if not PEERS.exists():
        return False
    return subprocess.run([PEERS, "-c", f"import {package}"], capture_output=True, check=False).returncode == 0


def in_peers(*arguments: object, folder: Path) -> str:
    """Output of a program with these arguments, run in `folder`."""
    done = subprocess.run(
        [PEERS.absolute(), *map(str, arguments)], capture_output=True, text=True, check=False, cwd=folder, timeout=600
    )
    assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    return done.stdout
