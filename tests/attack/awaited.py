"""Rows whose repair is under way: they run with LAGDSL_AWAITED=1 only. The list ends empty."""

AWAITED: frozenset[str] = frozenset(
    (
        "angle_of_a_cam",
        "clutch_by_an_input_that_ramps",
        "hill_of_potential",
        "kinetic_energy_switched_in_place",
        "limit_of_place",
        "narrow_hill_of_force",
        "step_of_a_potential",
        "step_of_a_potential_that_throws_back",
        "strip_of_damping",
        "table_of_place",
        "teeth_of_a_wheel",
        "through_a_state",
    )
)

# Random models, by kind and seed.
SEEDS: frozenset[tuple[str, int]] = frozenset()

# Models beside a stranger, by what is large or small, name and scale.
STRANGERS: frozenset[tuple[str, str, float]] = frozenset()
