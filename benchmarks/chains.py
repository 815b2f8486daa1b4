"""Chains of 2 to 100 links: forward dynamics against every peer."""

from collections.abc import Callable

import dynamics

CASES = [(name, n) for name in ("planar_chain", "spatial_chain") for n in (2, 5, 10, 20, 50, 100)]


def measure(say: Callable[[str], None]) -> dict[str, object]:
    """A contest for every chain."""
    rows = []
    for name, n in CASES:
        say(f"chains: {name} {n}")
        rows.append(dynamics.measure(name, n))
    return {"rows": rows}
