"""Names and what they stand for: scopes, values, the state of one compilation."""
