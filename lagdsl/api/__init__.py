"""What `lagdsl.compile` returns: a facade over the floors below."""
