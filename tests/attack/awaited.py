"""Rows whose repair is under way: they run with LAGDSL_AWAITED=1 only. The list ends empty."""

AWAITED: frozenset[str] = frozenset()

# Random models, by kind and seed.
SEEDS: frozenset[tuple[str, int]] = frozenset()

# Models beside a stranger, by what is large or small, name and scale.
STRANGERS: frozenset[tuple[str, str, float]] = frozenset()
