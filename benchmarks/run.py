"""Run all benchmarks, print the tables and write them to benchmarks/README.md: `make bench`."""

import sys
from pathlib import Path

import dynamics
import growth
import scale
from measure import first_call_cpu_seconds, process_cpu_seconds

README = Path(__file__).with_name("README.md")
PENDULUM = Path(__file__).parents[1] / "models" / "pendulum.lag"


def no_swell() -> list[str]:
    """Table of growth with the fitted exponents."""
    rows = growth.measure()
    sizes = [float(row.links) for row in rows]
    nodes = growth.exponent(sizes, [float(row.nodes) for row in rows])
    seconds = growth.exponent(sizes, [row.seconds for row in rows])
    return [
        "## No swell: the hanging chain, text to program, all functions",
        "",
        "| links | graph nodes | CPU s |",
        "|---|---|---|",
        *(f"| {row.links} | {row.nodes} | {row.seconds:.3f} |" for row in rows),
        f"| exponent (must stay below 2) | {nodes:.2f} | {seconds:.2f} |",
    ]


def against_sympy() -> list[str]:
    """Cart double pendulum, definition to callable functions."""
    ours = first_call_cpu_seconds("against_sympy", "lagdsl_cart_double_pendulum")
    theirs = first_call_cpu_seconds("against_sympy", "sympy_cart_double_pendulum")
    return [
        "## Text to callable NumPy functions: the cart double pendulum",
        "",
        "First call in a fresh process, imports not counted.",
        "",
        "| | CPU s |",
        "|---|---|",
        f"| lagdsl, all functions (text to callable) | {ours:.3f} |",
        f"| SymPy `LagrangesMethod` and `lambdify`, mass matrix and forcing | {theirs:.3f} |",
        f"| ratio (must be at most 0.1) | {ours / theirs:.3f} |",
    ]


def start_up() -> list[str]:
    """`lag check` of a ten-line model as a whole process."""
    numpy = process_cpu_seconds([sys.executable, "-c", "import numpy"])
    check = process_cpu_seconds([sys.executable, "-m", "lagdsl", "check", str(PENDULUM)])
    return [
        "## `lag check` on a ten-line model",
        "",
        "| whole process | CPU s |",
        "|---|---|",
        f'| `python -c "import numpy"` | {numpy:.3f} |',
        f"| `lag check models/pendulum.lag` | {check:.3f} |",
        f"| ratio (must be at most 4) | {check / numpy:.2f} |",
    ]


def against_peers() -> list[str]:
    """Forward dynamics against the installed peers, growth, many states."""
    rows = dynamics.measure(dynamics.CASES, _say)
    curves = scale.curves(_say)
    peers: dict[str, list[tuple[int, float]]] = {}
    for row in rows:
        for peer in ("pinocchio", "mujoco", "casadi"):
            time = dynamics.best(row, peer)
            if time is not None and row.model.endswith("_chain"):
                peers.setdefault(f"{row.model}, {peer}", []).append((row.n, time))
    scale.draw(curves, peers)
    return [*dynamics.tables(rows), "", *scale.batch(), "", *scale.tables(curves)]


def _say(what: str) -> None:
    """To people who wait."""
    print(what, file=sys.stderr, flush=True)


def main() -> None:
    """Measure, print, write."""
    lines = [
        "# Benchmarks",
        "",
        "Written by `make bench`: medians of CPU time, every ratio from one run on one machine.",
    ]
    for table in (start_up, against_sympy, no_swell, against_peers):
        lines += ["", *table()]
    text = "\n".join(lines) + "\n"
    print(text)
    README.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
