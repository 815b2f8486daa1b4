"""Rows whose repair is under way: they run with LAGDSL_AWAITED=1 only. The list ends empty."""

AWAITED: frozenset[str] = frozenset()
