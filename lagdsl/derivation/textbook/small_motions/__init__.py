"""Results on paper beyond the equations of motion: accelerations, equilibria, linear equations, frequencies."""
