"""Pages of components: every class of the library has one that tells its parameters, ports and equations."""

from __future__ import annotations

import re

from choice import together

from lagdsl.language.manual.component_page import component_page
from lagdsl.language.manual.library import class_names, library_class, package_names, package_title
from lagdsl.language.manual.models import model_names, model_text, renamed


@together("name", class_names())
def test_every_parameter_of_a_class_is_on_its_page(name: str) -> None:
    """Read from the text of the class, without the tree that the page is made of."""
    text = library_class(name).node.span.text.partition("\nprotected")[0]
    page = component_page(name)
    for statement in re.findall(r"^  (?:final |structural )*parameter \w+ ([^;\"]*)", text, re.MULTILINE):
        assert f"`{re.match(r'[a-zA-Z_0-9]+', statement)[0]}" in page  # type: ignore[index]
    assert page.startswith(f"# {name}\n\n")
    assert page.splitlines()[2].strip(".")


def test_an_inherited_parameter_has_the_default_of_the_heir() -> None:
    assert "| `l0` |" in component_page("Lag.Forces.GasSpring")
    page = component_page("Lag.Planar.Bar")
    assert "| `density` | Density | kg/m3 | `7700 kg/m3` | steel |" in page
    assert "`Lag.Planar.FixedTranslation`" in page


def test_equations_of_ancestors_stand_first() -> None:
    equations = component_page("Lag.Electrical.DCMotor").split("## Equations")[1].split("## Text")[0]
    assert equations.index("lagrangian k*phi*der(q);") < equations.index("kinetic 1/2*L*der(q)^2;")


def test_packages_have_titles() -> None:
    assert "Lag.Planar" in package_names()
    assert all(package_title(name) for name in package_names())


@together("name", model_names())
def test_every_model_takes_another_name(name: str) -> None:
    text = renamed(model_text(name), "Other")
    assert len(re.findall(r"\bOther\b", text)) == 2
