"""Classes: lookup, inheritance, modification, redeclaration, instances."""
