"""Rows whose repair is under way: they run with LAGDSL_AWAITED=1 only. The list ends empty."""

AWAITED: frozenset[str] = frozenset(
    (
        "angle_of_a_cam",
        "beside_a_mass_of_1e-18",
        "both_at_once",
        "bounces_of_a_giant",
        "clutch_by_an_input_that_ramps",
        "defaulted_rates_beside_an_equation_of_position",
        "defaulted_rates_beside_an_initial_equation",
        "defaulted_rates_of_three",
        "discrete_mass",
        "either_at_once",
        "fall_from_1e-12",
        "fast_state",
        "force_on_a_narrow_tooth",
        "hill_of_potential",
        "kinetic_energy_switched_in_place",
        "limit_of_place",
        "narrow_hill_of_force",
        "one_explicit_rate_beside_an_initial_equation",
        "rotating_arm_hits_a_pin",
        "step_of_a_potential",
        "step_of_a_potential_that_throws_back",
        "strip_of_damping",
        "table_of_place",
        "teeth_by_mod",
        "teeth_of_a_wheel",
        "through_a_state",
        "track_of_an_abs",
        "track_with_a_corner",
        "very_narrow_teeth",
    )
)

# Random models, by kind and seed.
SEEDS: frozenset[tuple[str, int]] = frozenset({("of_what_is_hard", 14), ("of_what_is_hard", 23)})

# Models beside a stranger, by what is large or small, name and scale.
STRANGERS: frozenset[tuple[str, str, float]] = frozenset(
    {("start", "bouncing_ball", 1e9), ("rate", "bouncing_ball", 1e9)}
)
