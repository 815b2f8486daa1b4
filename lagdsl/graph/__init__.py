"""The expression graph: what mechanics derives on and every backend prints."""

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import ARGUMENT_NAMES, Group, Op

__all__ = ["ARGUMENT_NAMES", "Graph", "Group", "Op"]
