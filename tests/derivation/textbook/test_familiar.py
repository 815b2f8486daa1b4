"""The model for people: letters for literal numbers, zeros left out, equal moments of inertia as one."""

from __future__ import annotations

from pathlib import Path

from lagdsl.derivation.textbook.familiar import familiar
from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read

_LETTERS = """
model Letters
  parameter Length L = 0.5 m;
  parameter Mass M = 2 kg;
  parameter Damping D = 0.1 N.s/m;
  parameter Force T = 1 N, V = 2 N, Q = 3 N;
  parameter Acceleration g = 9.81 m/s2;
  parameter Length r = 0.1 m, t = 0.2 m;
  parameter Mass a1 = 1 kg, a_1 = 2 kg;
  coordinate Length q;
  coordinate Angle lean(start = 30 deg);
  gravity = -g*world.y;
  mass M at {q + r + t, 0};
  mass a1 + a_1 at {q + L*sin(lean), -L*cos(lean)};
  dissipation 1/2*D*der(q)^2;
  force Q + T - V on q;
end Letters;
"""
_NUMBERS = """
model Numbers
  parameter Length r0 = 0.3 m;
  parameter TranslationalSpringConstant k = 20 N/m;
  coordinate Length r(start = 0.4 m);
  coordinate Angle theta;
  gravity = {0, -9.81 m/s2};
  mass 2 kg at {r*sin(theta), -r*cos(theta)};
  potential 1/2*k*(r - r0)^2;
end Numbers;
"""


def _flat(text: str) -> FlatModel:
    sink = Sink()
    flat = flatten_file(SourceFile("model.lag", text), sink)
    assert flat is not None, sink.diagnostics
    return flat


def _text(text: str) -> str:
    return render(recipe(_flat(text)), "text")


def test_no_letter_of_the_derivation_is_one_of_the_model() -> None:
    text = _text(_LETTERS)
    for line in ("ℒ = 𝒯 − 𝒱", "𝒟 = ½ D q̇²", "d/d𝔱 ∂ℒ/∂q̇", "𝐫₁ = (q + r + t, 0)", "Q_q = "):
        assert line in text, line
    assert "r, T, V, L, D, t and M are letters of the model; the derivation writes 𝐫, 𝒯, 𝒱, ℒ, 𝒟, 𝔱 and ℳ." in text
    assert "\n    L = T" not in text


def test_names_that_look_alike_are_set_as_they_are_written() -> None:
    assert "(a1 + a_1)" in _text(_LETTERS)


def test_words_get_the_letter_of_their_kind_as_dots_stand_over_letters() -> None:
    text = _text(_LETTERS)
    assert "θ̇_lean" in text
    assert "der(" not in text


def test_numbers_with_a_unit_get_letters_and_keep_it() -> None:
    text = _text(_NUMBERS)
    assert "g       9.81 m/s²" in text
    assert "m₁      2 kg" in text
    assert "m₁ r̈ − m₁ r θ̇² + k (r − r₀) − m₁ g cos θ = 0" in text


def test_zeros_of_components_and_equal_moments_of_inertia() -> None:
    sink = Sink()
    file = read(Path("models/gyroscope_in_gimbals.lag"), sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    prepared = familiar(flat)
    assert "weight.com[1]" in prepared.zeros
    assert dict(prepared.twins)["rotor.I[2]"] == "rotor.I[1]"
    text = render(recipe(flat), "text")
    assert "not printed" not in text
    assert "T_rotor = ½ I_rotor,1 (q̇_outer² sin² q_inner + q̇_inner²)" in text
    assert "r_outer_ring, r_inner_ring and r_rotor vanish" in text


def test_rows_that_always_hold_are_words() -> None:
    sink = Sink()
    file = read(Path("models/four_bar.lag"), sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    text = render(recipe(flat), "text")
    assert "0 = 0" not in text
    assert "closure(D)[3], closure(D)[4] and closure(D)[5] hold whatever the motion is" in text
    assert "q_D = −q_A − q_B − q_C" in text
