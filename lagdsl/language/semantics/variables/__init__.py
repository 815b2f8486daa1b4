"""Variables with their attributes; the resolver that gives each its value when it is first asked for."""
