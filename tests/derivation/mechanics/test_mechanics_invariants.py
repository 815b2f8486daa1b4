"""Claims that are proved instead of monitored."""

from dataclasses import replace

from mechanics_models import (
    SPANS,
    body,
    constraint,
    coordinate,
    definition,
    drive,
    energy,
    frame,
    mass,
    model,
    point,
    state,
)

from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.derivation.mechanics.invariants import proved_invariants, report_proofs
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import Rotate

CLAIMS = {"E": "energy()", "h": "energy(jacobi)", "p": "momentum(a)", "pb": "momentum(b)"}


def top(moment="A", **parts):
    """Heavy top in Euler angles, moments A, A (or another), C: spin and precession are cyclic, not as they stand."""
    return model(
        parameters={"m": 0.5, "l": 0.05, "A": 8e-4, "B": 9e-4, "C": 1e-3, "c": 0.0},
        coordinates=("a", coordinate("n", 0.5), "b"),
        named=(frame("top", "world", *[Rotate(k, Variable(name)) for k, name in ((2, "a"), (0, "n"), (2, "b"))]),),
        gravity="v(0, 0, -9.81)",
        bodies=(body("top", "m", (0, 0, "l"), ("A", moment, "C", 0, 0, 0)),),
        invariants=CLAIMS,
        **parts,
    )


def test_heavy_top() -> None:
    assert proved_invariants(form_equations(top())) == (True, True, True, True)


def test_unequal_moments_break_the_spin_only() -> None:
    assert proved_invariants(form_equations(top("B"))) == (True, True, True, False)


def test_damping_that_is_switched_off_by_a_parameter_still_breaks_the_proof() -> None:
    assert proved_invariants(form_equations(top(energies=(energy("dissipation", "c*der(b)^2"),)))) == (
        False,
        False,
        True,
        False,
    )


def test_gyroscopic_loads_have_no_power() -> None:
    """Two forces linear in the other's rate: no energy, but they touch both momenta."""
    flat = top(loads=(drive("der(b)", "a"), drive("-der(a)", "b")))
    assert proved_invariants(form_equations(flat)) == (True, True, False, False)


def hoop(**parts):
    return model(
        parameters={"m": 0.1, "R": 0.3, "Omega": 8.0},
        coordinates=("a",),
        named=(
            definition("turned", "Omega*time"),
            frame("hoop", "world", Rotate(1, Variable("turned"))),
            point("P", "R*(sin(a)*hoop.x - cos(a)*hoop.y)"),
            definition("claim", "energy(jacobi)"),
        ),
        gravity="v(0, -9.81, 0)",
        masses=(mass("m", "p(P)"),),
        **parts,
    )


def test_bead_on_spinning_hoop_keeps_the_jacobi_integral_but_not_the_energy() -> None:
    """L has the time in it as it stands, but does not depend on it. The claim may hide behind a name."""
    assert proved_invariants(form_equations(hoop(invariants={"E": "energy()", "h": "claim"}))) == (False, True)


def test_constraints_must_be_scleronomic_and_leave_the_momentum_alone() -> None:
    def on_a_line(residual, level="position"):
        return model(
            parameters={"m": 1.0},
            coordinates=("a", "b"),
            masses=(mass("m", "v(a, b, 0)"),),
            constraints=(constraint("c", residual, level=level),),
            invariants=CLAIMS,
        )

    assert proved_invariants(form_equations(on_a_line("b^2 - 1"))) == (True, True, True, False)
    assert proved_invariants(form_equations(on_a_line("b - time"))) == (False, False, True, False)
    assert proved_invariants(form_equations(on_a_line("der(b) - a*der(a)", "velocity"))) == (True, True, False, False)
    assert proved_invariants(form_equations(on_a_line("der(b) - 1", "velocity"))) == (False, False, True, False)


def test_inputs_and_states_in_the_lagrangian_break_the_energy() -> None:
    flat = model(
        coordinates=("a", "b"),
        states=(state("z", "-z"),),
        inputs=(("u", None),),
        energies=(energy("kinetic", "der(a)^2 + der(b)^2"), energy("potential", "b^2*z")),
        invariants=CLAIMS,
    )
    assert proved_invariants(form_equations(flat)) == (False, False, True, False)
    with_input = replace(flat, energies=(flat.energies[0], energy("potential", "b*u")))
    assert proved_invariants(form_equations(with_input)) == (False, False, True, False)


def test_kinks_are_not_tried_at_points() -> None:
    flat = model(
        coordinates=("a", "b"),
        energies=(energy("kinetic", "der(a)^2 + der(b)^2"), energy("potential", "abs(a) - sqrt(a^2)")),
        invariants=CLAIMS,
    )
    assert proved_invariants(form_equations(flat)) == (True, True, False, True)


def test_only_energies_and_momenta_can_be_proved() -> None:
    flat = model(
        coordinates=("a", "b"),
        energies=(energy("kinetic", "der(a)^2 + der(b)^2"),),
        invariants={"x": "a", "T": "energy(kinetic)"},
    )
    assert proved_invariants(form_equations(flat)) == (False, False)
    assert proved_invariants(form_equations(replace(flat, invariants=flat.invariants[:1]))) == (False,)


def test_integer_parameters_keep_their_value() -> None:
    flat = model(
        parameters={"n": 2.0},
        coordinates=("a", "b"),
        energies=(energy("kinetic", "der(a)^2 + der(b)^2"), energy("potential", "(n - 2)*a")),
        invariants=CLAIMS,
    )
    assert proved_invariants(form_equations(flat))[2] is False
    whole = replace(flat, parameters=(replace(flat.parameters[0], kind="Integer"),))
    assert proved_invariants(form_equations(whole))[2] is True


def test_proofs_are_told() -> None:
    sink = Sink()
    report_proofs(form_equations(hoop(invariants={"E": "energy()", "h": "energy(jacobi)"})), sink)
    (note,) = sink.diagnostics
    assert note.code == "N0515"
    assert "`h`" in note.message
    assert note.labels[0].span == SPANS[0]
