"""Directions without inertia: which rows the balances of forces become, and why some are refused."""

from __future__ import annotations

import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.expression import ForceBalance
from lagdsl.language.flat.model import Constraint
from lagdsl.motion.pipeline import compile_flat, flatten_file, read

HEAD = "model M coordinate Length x(start = 0.1 m), s, r; kinetic 1/2*(1 kg)*der(x)^2;"
HELD = "potential 1/2*(50 N/m)*r^2;"
PULL = "potential 1/2*(100 N/m)*(x - s)^2;"
DAMP = "dissipation 1/2*(5 N.s/m)*der(s)^2;"


def balances(text: str) -> dict[str, Constraint]:
    sink = Sink()
    source = read(f"{HEAD} {text} end M;", sink)
    assert source is not None
    flat = flatten_file(source, sink)
    assert flat is not None, sink.diagnostics
    found = compile_flat(flat, sink)
    assert found is not None, sink.diagnostics
    return {each.name: each for each in found.flat.constraints if balanced(each)}


def weights(constraint: Constraint) -> tuple[tuple[str, float], ...]:
    (residual,) = constraint.residuals
    assert isinstance(residual, ForceBalance)
    return residual.weights


def test_balances_without_rates_hold_places() -> None:
    found = balances(f"{HELD} {PULL} potential 1/2*(30 N/m)*s^2;")
    assert {name: each.level for name, each in found.items()} == {"balance(s)": "position", "balance(r)": "position"}


def test_damping_between_two_ends_leaves_one_balance_without_rates() -> None:
    found = balances(f"{HELD} {PULL} dissipation 1/2*(5 N.s/m)*(der(s) - der(r))^2;")
    assert [(each.level, weights(each)) for each in found.values()] == [
        ("position", (("s", 1.0), ("r", 1.0))),
        ("velocity", (("r", 1.0),)),
    ]


def test_directions_that_constraints_tie_share_a_balance() -> None:
    found = balances(f"{HELD} {PULL} constraint tie: s = 3*r;")
    assert [weights(each) for each in found.values()] == [(("s", 1.0), ("r", pytest.approx(1 / 3)))]


def test_parameters_that_vanish_decide_no_level() -> None:
    """With another value of c the balance holds rates: with c = 0 nothing determines them."""
    (error,) = (
        each
        for each in lagdsl.check(f"{HEAD} parameter Damping c = 0 N.s/m; {HELD} dissipation c*der(s)^2/2; end M;")
        if each.severity == "error"
    )
    assert error.code == "E0503" and error.notes == ("no force determines `s`",)


@pytest.mark.parametrize(
    ("text", "note"),
    [
        (f"{HELD} force 1 N on s;", "no force determines `s`"),
        (
            "potential 1/2*(100 N/m)*(x - s + r)^2;",
            "no force determines the motion in which `s` and `r` change together",
        ),
        (
            f"{HELD} {DAMP} contact c: s >= -1 m with restitution = 0;",
            "constraint `c` acts on it, which comes and goes",
        ),
        (f"{HELD} {PULL} force (if x > 0 m then 1 N else 0 N) on s;", "the forces on it change at instants, and"),
        (f"{HELD} {DAMP} force -(1 N.s2/m2)*der(s)*abs(der(s)) on s;", "the forces that damp it are not linear in the"),
        (
            f"{HELD} {PULL} lagrangian (3 N.s/m)*s*der(x);",
            "forces that change with `s` are balanced by rates of other coordinates alone",
        ),
    ],
)
def test_what_forces_do_not_determine_is_named(text: str, note: str) -> None:
    errors = [each for each in lagdsl.check(f"{HEAD} {text} end M;") if each.severity == "error"]
    assert [each.code for each in errors] == ["E0503"]
    assert errors[0].notes[0].startswith(note)
