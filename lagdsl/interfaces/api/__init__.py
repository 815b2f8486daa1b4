"""Result of `lagdsl.compile`: a facade over the floors below."""
