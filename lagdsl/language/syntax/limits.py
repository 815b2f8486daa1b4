"""Largest size of a text. Every bound has a diagnostic; none is met by a model that people write."""

MAX_CHARACTERS = 1_000_000
MAX_DEPTH = 1000
"""Levels of the syntax tree: a sum of n terms is n levels deep. Later stages recurse over the tree."""

MAX_BRACKETS = 200
"""Brackets open at one place."""

MAX_STACK = 4 * MAX_DEPTH
"""Symbols that wait on the parser's stack for the rest of their statement: bounds `x^x^x^...` before it is a tree."""

MAX_NAME = 200
MAX_STRING = 10_000
MAX_NUMBER = 100
MAX_ERRORS = 50
"""Errors in one text after which the parser stops."""
