"""Family 09: export, engines and files."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error

ROWS: dict[str, Row] = {
    "E0911": error(
        "the C engine needs a C compiler, and none was found",
        help="install one so that `cc` runs (or name it in the environment variable CC), or `pip install ziglang`, "
        "which brings one along; the engine `numpy` needs neither",
    ),
    "E0912": error(
        "the C compiler `{compiler}` failed",
        help="check that `{compiler}` compiles C11, name another compiler in the environment variable CC, "
        "or use the engine `numpy`",
    ),
    "E0913": error(
        "no folder for compiled models can be written: {reason}",
        help="set XDG_CACHE_HOME to a folder of your own that can be written",
    ),
    "E0914": error(
        "the runtime library of lagdsl cannot be loaded: {reason}",
        help="install lagdsl again, from the folder of its sources: `pip install --force-reinstall .`",
    ),
}
