"""Rows whose repair is under way: they run with LAGDSL_AWAITED=1 only. The list ends empty."""

AWAITED: frozenset[str] = frozenset(
    (
        "defaulted_rates_beside_an_equation_of_position",
        "defaulted_rates_beside_an_initial_equation",
        "defaulted_rates_of_three",
        "kinetic_energy_switched_in_place",
        "one_explicit_rate_beside_an_initial_equation",
        "step_of_a_potential",
        "step_of_a_potential_that_throws_back",
    )
)

# Random models, by kind and seed.
SEEDS: frozenset[tuple[str, int]] = frozenset({("of_what_is_hard", 14), ("of_what_is_hard", 23)})

# Models beside a stranger, by what is large or small, name and scale.
STRANGERS: frozenset[tuple[str, str, float]] = frozenset(
    {("start", "bouncing_ball", 1e9), ("rate", "bouncing_ball", 1e9)}
)
