"""From the text of a model to its library: CPU seconds of Python and of the C compiler, and how large the result is."""

from collections.abc import Callable
from dataclasses import asdict

import ours
import peers

CASES: tuple[tuple[str, int | None], ...] = (
    ("panda", None),
    ("panda_scalars", None),
    ("planar_chain", 10),
    ("planar_chain", 50),
    ("planar_chain", 100),
    ("spatial_chain", 50),
    ("spatial_chain", 100),
)
RUNS = 5
# Compile time of CasADi's C without optimization; with -O2 it takes minutes.
LONG = 50


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A row for every case, and CasADi's for the chain of LONG links."""
    rows = []
    for name, n in CASES:
        say(f"text: {name} {n or ''}")
        made = asdict(ours.in_processes(name, n, runs=RUNS))
        rows.append({"model": name, **{key: made[key] for key in ("n", "python", "compiler", "size", "flops")}})
    casadi = None
    if "casadi" in peers.where():
        say(f"text: CasADi, planar_chain {LONG}")
        ways = [peers.casadi("planar_chain", LONG, way, peers.NO_FLAGS, runs=RUNS)[0] for way in ("plane", "space")]
        best = min(ways, key=lambda each: each.python + each.compiler)
        casadi = {"python": best.python, "compiler": best.compiler, "flags": best.flags}
    return {"rows": rows, "casadi": casadi, "runs": RUNS}
