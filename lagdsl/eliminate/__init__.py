"""Systems of Lagrange's equations solved while they are still expressions: elimination on the graph, in order of depth."""
