"""The expression graph: what mechanics derives on and every backend prints."""

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group, Op

__all__ = ["ARGUMENT_NAMES", "Graph", "Group", "Op"]
