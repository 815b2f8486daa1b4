"""The flat model as nodes of the graph."""
