"""Events and contacts in the report."""

from __future__ import annotations

import pytest

from lagdsl.derivation.textbook.recipe import Recipe, recipe
from lagdsl.documents.report.derivation import FORMATS, render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

BALL = """
model Ball
  parameter Real e = 0.8;
  parameter Mass m = 0.1 kg;
  coordinate Length h(start = 1 m), x;
  discrete Force u(start = 2 N) "held";
  gravity = -g_n*world.y;
  mass m at {x, h};
  contact floor: h >= 0 with restitution = e;
  force if h > 0.5 m then u else 0 on x;
equation
  when sample(0, 0.1 s) then
    u = -0.01 N*sign(der(x));
  elsewhen impacts(floor) > 3 then
    reinit(der(x), 0);
    terminate("enough");
  end when;
end Ball;
"""
FREE = """
model Free
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  {items}
end Free;
"""


def derived(text: str) -> Recipe:
    flat = flatten_file(SourceFile("<text>", text), Sink())
    assert flat is not None
    return recipe(flat)


def test_the_contact_enters_the_equations_by_its_gap() -> None:
    text = render(derived(BALL), "text")
    assert "m ḧ + m g_n = λ\n" in text
    assert "floor    h    e              λ" in text
    assert "J_c q̇^+ = −𝔢 J_c q̇^−" in text
    assert "constraint  restricts" not in text


def test_clauses_in_the_order_of_the_text() -> None:
    text = render(derived(BALL), "text")
    events = text[text.index("Events") :]
    assert "u                        N     2             held" in events
    assert "sample(0, 0.1 s) ticks at 0 s + k*(0.1 s)" in events
    assert "  • h > 0.5 m\n" in events
    assert "when sample(0, 0.1 s): u = -0.01*sign(der(x))" in events
    assert 'else when impacts(floor) > 3: reinit(der(x), 0); terminate("enough")' in events


@pytest.mark.parametrize("form", FORMATS)
def test_every_format(form: str) -> None:
    document = render(derived(BALL), form)  # type: ignore[arg-type]
    assert "Contacts" in document
    assert "Events" in document
    assert "U+0" not in document  # no letters without a spelling in LaTeX


def test_nothing_is_conserved_across_jumps() -> None:
    reset = "equation when x > 1 m then reinit(der(x), 0); end when;"
    kept, jumping, bouncing = (
        derived(FREE.format(items=items)).derivation
        for items in ("", reset, "contact wall: x <= 1 m with restitution = 0;")
    )
    assert kept is not None and jumping is not None and bouncing is not None
    assert kept.energy_conserved and kept.cyclic
    assert not jumping.energy_conserved and not jumping.cyclic
    assert not bouncing.energy_conserved and not bouncing.cyclic


def test_the_count_leaves_contacts_out() -> None:
    derivation = derived(BALL).derivation
    assert derivation is not None
    assert (derivation.count.rows, derivation.count.freedom) == (0, 2)


def test_a_delayed_value_is_one_of_an_earlier_time() -> None:
    text = FREE.format(items="parameter Time T = 1 s; force -delay(x, T)*(1 N/m) - delay(x^2, 0.5 s)*(1 N/m2) on x;")
    page = render(derived(text), "text")
    assert "ẍ = −x (t − T) − delay(x^2, 0.5 s)" in page
    assert "Delayed values" in page and "In no formula" not in page
