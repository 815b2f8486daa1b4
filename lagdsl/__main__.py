"""`python -m lagdsl` is the command `lag`; so is the script of that name."""

import os
import sys
from typing import NoReturn

from lagdsl.cli.status import INTERRUPTED


def main() -> NoReturn:
    """Run `lag`. An interrupt while its modules are loaded ends it as one while it works does."""
    try:
        from lagdsl.cli.main import main as lag

        lag()
    except KeyboardInterrupt:
        os.write(2, b"\ninterrupted\n")
        sys.exit(INTERRUPTED)


if __name__ == "__main__":
    main()
