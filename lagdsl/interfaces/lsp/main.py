"""The process of `lag lsp`."""

from __future__ import annotations

import gc
import os
import sys
from typing import BinaryIO, cast

from lagdsl.interfaces.lsp.bodies import Bodies
from lagdsl.interfaces.lsp.protocol import quiet
from lagdsl.interfaces.lsp.server import LagServer
from lagdsl.interfaces.lsp.wiring import wired

_DEEPEST = 200_000  # of recursion, for all threads: the limit is one for the process
_OBJECTS_PER_COLLECTION = 200_000  # of those just made: none while one version of a text is looked at


def serve() -> None:
    """Talk to an editor by standard input and output until it says goodbye."""
    sys.setrecursionlimit(_DEEPEST)
    gc.freeze()
    gc.set_threshold(_OBJECTS_PER_COLLECTION, 20, 20)
    quiet()
    server = wired(LagServer())
    # Other output than messages goes to standard error, where it breaks none of them.
    source, target = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    try:
        server.start_io(cast(BinaryIO, Bodies(source)), target)
    finally:
        server.end()
