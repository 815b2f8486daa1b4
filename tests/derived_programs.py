"""Programs as the graph route makes them, before their ranks are known."""

from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.derivation.program.program import Program
from lagdsl.language.flat.model import FlatModel


def derive(flat: FlatModel, *, dense: bool | None = None) -> Program:
    return arrange(form_equations(flat), dense=dense)
