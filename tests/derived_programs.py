"""Programs as the graph route makes them, before their ranks are known."""

from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.arrange import arrange
from lagdsl.mechanics.equations import form_equations
from lagdsl.program.program import Program


def derive(flat: FlatModel, *, dense: bool | None = None) -> Program:
    return arrange(form_equations(flat), dense=dense)
