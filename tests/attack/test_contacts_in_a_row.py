"""Bodies that touch in a row: one that is pulled away opens its own contact, the others go on as they are."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin, sqrt

from attack.rows import Attack, check, model, rows

# Masses of 1 that touch, pushed by 1 for a second, then pulled back by 1: three go at 1/3, the first turns back.
PUSHED = {"a": 1 / 6 + 1 / 3 - 1 / 2, "der(a)": -2 / 3, "der(b)": 1 / 3, "der(c)": 1 / 3, "c": 0.2 + 1 / 6 + 1 / 3}
ONE_OPENS = {("one", "opened"): 1, ("two", "opened"): 0}


def in_a_row(masses: Sequence[float], force: str) -> str:
    names = "abcd"[: len(masses)]
    items = [f"coordinate Real {x}(start = {0.1 * i:.1f});" for i, x in enumerate(names)]
    items += [f"kinetic 1/2*{m!r}*der({x})^2;" for x, m in zip(names, masses, strict=True)]
    contacts = zip(names, names[1:], ("one", "two", "three"), strict=False)
    items += [f"contact {name}: {y} - {x} >= 0.1 with restitution = 0;" for x, y, name in contacts]
    return "".join(items) + force


ROW = [
    Attack(
        "pulled_by_time", model(in_a_row([1.0] * 3, "force if time < 1 then 1 else -1 on a;")), 2.0, PUSHED, ONE_OPENS
    ),
    Attack(
        "pulled_by_a_saw",
        model(in_a_row([1.0] * 3, "force 1 - 2*floor(time) on a;")),
        1.999999,
        {"der(b)": 1 / 3, "der(c)": 1 / 3},
        ONE_OPENS,
    ),
    Attack(
        "pulled_by_a_tick",
        model(
            in_a_row([1.0] * 3, "discrete Real u(start = 1); force u on a;"),
            "when sample(1, 10) then u = -1; end when;",
        ),
        2.0,
        PUSHED,
        ONE_OPENS,
    ),
    Attack(
        "pulled_by_its_place",
        model(in_a_row([1.0] * 3, f"force if a > {1 / 6!r} then -1 else 1 on a;")),
        1.25,
        {"der(a)": 1 / 3 - 0.25, "der(b)": 1 / 3, "der(c)": 1 / 3},
        ONE_OPENS,
    ),
    Attack(
        "blow_without_a_force_afterwards",
        model(in_a_row([1.0] * 3, "force 1e5*max(0, 1 - abs(time - 1)/1e-5) on a;")),
        2.0,
        {"der(a)": 1 / 3, "der(b)": 1 / 3, "der(c)": 1 / 3, "a": 1 / 3},
        {("one", "opened"): 0, ("two", "opened"): 0},
    ),
    Attack(
        "heavy_and_light",
        model(in_a_row([1.0, 1e-6, 1e6, 1.0], "force if time < 1 then 1e6 else -1e6 on a;")),
        1.5,
        {"der(b)": 1e6 / (1e6 + 2.000001), "der(d)": 1e6 / (1e6 + 2.000001)},
        {("one", "opened"): 1, ("two", "opened"): 0, ("three", "opened"): 0},
    ),
    Attack(
        "pulled_from_both_ends",
        model(in_a_row([1.0] * 3, "force if time < 1 then 1 else -1 on a;force if time < 1 then -1 else 1 on c;")),
        2.0,
        {"der(a)": -1.0, "der(b)": 0.0, "der(c)": 1.0},
        {("one", "opened"): 1, ("two", "opened"): 1},
    ),
    # No force acts before the soft stop does: two masses that run together turn around as one on a spring of 8.
    Attack(
        "soft_stop_of_two",
        model(
            "coordinate Real a(der(start = 1.5)), b(start = 0.1, der(start = 1.5));"
            "kinetic 1/2*der(a)^2; kinetic 1/2*der(b)^2;"
            "contact one: b - a >= 0.1 with restitution = 0;"
            "contact soft: b <= 0.85 with compliance = 8, damping = 0;"
        ),
        0.5 + 1.0,
        {"a": 0.75 + 0.75 * sin(2.0), "der(a)": 1.5 * cos(2.0), "der(b)": 1.5 * cos(2.0)},
        {("one", "opened"): 0, ("one", "closed"): 0},
    ),
    *(
        Attack(
            f"reset_in_a_row_{name}",
            model(
                in_a_row([1.0] * 3, "force if time < 1 then 3 else 0 on a;" + declared),
                f"when time > 1.5 then reinit(der(a), 4);{more} end when;",
            ),
            2.0,
            {"der(a)": 4.0, "der(b)": 4.0, "der(c)": 4.0},
        )
        for name, declared, more in (
            ("alone", "", ""),
            ("with_a_counter", "discrete Integer n(start = 0);", " n = pre(n) + 1;"),
        )
    ),
    Attack(
        "reset_that_stops_the_last_pusher",
        model(
            in_a_row([1.0] * 3, "force if time < 1 then 3 else 0 on a;"),
            "when time > 1.5 then reinit(der(a), 0); end when;",
        ),
        2.0,
        {"a": 1.0, "der(a)": 0.0, "der(b)": 1.0, "c": 0.2 + 0.5 + 1.0},
        {("one", "opened"): 1, ("two", "opened"): 0},
    ),
]


def rocked(inertia: float, half: float, tilt: float) -> dict[str, float]:
    """A plank of mass 1 falls from its tilt onto edges without rebound; g = 10, s is the integral of the angle.

    Each blow keeps the momentum about the next edge: the rate changes by the ratio (I - b^2)/(I + b^2), and with it the
    time of the next flight, whose integral is rate*time^2/6 with the sign of the tilt (Housner, Bull. Seism. Soc. Am.
    53, 1963).
    """
    back = 10 * half / (inertia + half**2)
    ratio = (inertia - half**2) / (inertia + half**2)
    fall = sqrt(2 * tilt / back)
    rate = ratio * back * fall
    return {"s": tilt * fall * 2 / 3 - rate * (2 * rate / back) ** 2 / 6 / (1 + ratio**3), "a": 0.0, "y": 0.0}


def rocks(inertia: float, half: float) -> str:
    return model(
        f"coordinate Real y(start = {0.1 * half!r}), a(start = 0.1); kinetic 1/2*der(y)^2 + 1/2*{inertia!r}*der(a)^2; "
        f"potential 10*y; state Real s; contact left: y + {half!r}*a >= 0 with restitution = 0; "
        f"contact right: y - {half!r}*a >= 0 with restitution = 0;",
        "der(s) = a;",
    )


ROCKING = [
    Attack(f"rocks_{ratio}", rocks(inertia, 0.5), 3.0, rocked(inertia, 0.5, 0.1))
    for ratio in (0.1, 0.5, 0.8)
    for inertia in (0.25 * (1 + ratio) / (1 - ratio),)
]


@rows(ROCKING)
def test_rocking_planks_come_to_rest(row: Attack, engine: str) -> None:
    check(row, engine)


@rows(ROW)
def test_contacts_in_a_row(row: Attack, engine: str) -> None:
    check(row, engine)
