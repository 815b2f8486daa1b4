"""`python -m lagdsl` is the command `lag`; so is the script of that name."""

import os
import signal
import sys
from typing import NoReturn

from lagdsl.interfaces.cli.status import INTERRUPTED


def main() -> NoReturn:
    """Run `lag`. An interrupt while its modules are loaded ends it as one while it works does."""
    try:
        from lagdsl.interfaces.cli.main import main as lag

        lag()
    except KeyboardInterrupt:
        os.write(2, b"\ninterrupted\n")
        sys.exit(INTERRUPTED)
    finally:
        # Results and status are there: an interrupt while the interpreter ends would kill the process.
        signal.signal(signal.SIGINT, signal.SIG_IGN)


if __name__ == "__main__":
    main()
