"""Small motions about a state: linearization on the minimal state, modes, thresholds, equilibria."""
