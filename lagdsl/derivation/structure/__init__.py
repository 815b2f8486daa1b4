"""The structure of a model: rank of constraints, degrees of freedom, redundant rows, singular inertia."""
