"""The equations of motion as a matrix times what is linear in them: inertias, damping, friction."""
