"""The annotation `page`: quantities of all kinds by their names, inherited unless redefined; faults have places."""

from __future__ import annotations

from flattening import accepted, pendulum, run, said

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.quantity import Page
from lagdsl.language.flat.text import flat_text
from lagdsl.language.syntax.printer import format_text

MORE = "input Torque M[2]; torque M[1] + M[2] on theta; output Length r[2] = {l, 2*l};"


def test_names_are_those_of_the_results() -> None:
    flat = accepted(f"{MORE} annotation(page(sliders = {{l, M, theta, der(theta)}}, curves = r[2]));")
    assert flat.page == Page(sliders=("l", "M[1]", "M[2]", "theta", "der(theta)"), curves=("r[2]",))
    assert flat_text(flat).endswith("page:\n  sliders l, M[1], M[2], theta, der(theta)\n  curves r[2]\n")
    assert accepted("").page == Page()


def test_a_component_has_its_names_and_a_model_its_own_page() -> None:
    base = """model Base
      parameter Length l = 1 m; coordinate Angle q; gravity = -g_n*world.y; mass 1 kg at {l*sin(q), -l*cos(q)};
      annotation(page(sliders = {l}));
    end Base;
    """
    assert (flat := run(f"{base} model M extends Base; end M;")[0]) is not None and flat.page.sliders == ("l",)
    inside = run(f"{base} model M Base a; annotation(page(sliders = {{a.q}})); end M;")[0]
    assert inside is not None and inside.page.sliders == ("a.q",)
    redefined = run(f"{base} model M extends Base; annotation(page(sliders = {{q}})); end M;")[0]
    assert redefined is not None and redefined.page.sliders == ("q",)


def test_what_is_no_control_is_told_where_it_stands() -> None:
    for text, code, place in (
        ("page(sliders = {thet})", "E0201", "thet"),
        ("page(slider = {l})", "E0202", "slider"),
        ("page(sliders = {l}, sliders = {m})", "E0212", "sliders = {m}"),
        ("page(sliders)", "E0220", "sliders"),
        ("page(sliders = {2*l})", "E0246", "2*l"),
        ("page(curves = {l})", "E0246", "l"),
    ):
        assert said(pendulum(f"annotation({text});")[1]) == [(code, place)], text


def test_a_parameter_that_only_a_slider_has_is_unused() -> None:
    assert said(pendulum("parameter Length d = 1 m; annotation(page(sliders = {d}));")[1]) == [("W0206", "d")]


def test_the_formatter_keeps_it() -> None:
    text = "model M\n  coordinate Angle q;\n  annotation(page(sliders = {q}, curves = {q, der(q)}));\nend M;\n"
    assert format_text(SourceFile("m.lag", text), Sink()) == text
