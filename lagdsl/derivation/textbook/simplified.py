"""The equations of motion in SymPy as people read them: what `model.equations` gives.

The same formation as the oracle's (`derive`), of the model with exact numbers, and every element made short. A model
beyond the extent of a written derivation keeps the plain form: shortening is bounded, its work is not worth the wait.
"""

from __future__ import annotations

from dataclasses import replace

from sympy import Expr, ImmutableDenseMatrix, Symbol

from lagdsl.derivation.textbook.derive import derive, equations_of
from lagdsl.derivation.textbook.equations import Energies, EquationsOfMotion
from lagdsl.derivation.textbook.extent import extent
from lagdsl.derivation.textbook.familiar import familiar
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY, STANDARD_GRAVITY_VALUE, read
from lagdsl.language.flat.model import FlatModel


def simplified(model: FlatModel) -> EquationsOfMotion:
    """The equations of `model`; `parameters` holds the values of all symbols that do not move, those of g too."""
    prepared = familiar(model).flat
    if extent(prepared).reasons:
        return derive(model)
    reading = read(prepared, written_out=True)
    found, tidy = equations_of(prepared, reading.symbols, reading.parts), reading.tidy

    def short(matrix: ImmutableDenseMatrix) -> ImmutableDenseMatrix:
        return ImmutableDenseMatrix(*matrix.shape, [tidy(element) for element in matrix])

    def each(values: dict[Symbol, Expr]) -> dict[Symbol, Expr]:
        return {symbol: tidy(value) for symbol, value in values.items()}

    energies = found.energies
    parameters = dict(found.parameters)
    parameters.setdefault(STANDARD_GRAVITY, float(STANDARD_GRAVITY_VALUE))
    return replace(
        found,
        parameters=parameters,
        lagrangian=tidy(found.lagrangian),
        dissipation=tidy(found.dissipation),
        energies=Energies(
            total=tidy(energies.total),
            kinetic=tidy(energies.kinetic),
            potential=tidy(energies.potential),
            jacobi=tidy(energies.jacobi),
        ),
        mass_matrix=short(found.mass_matrix),
        forcing=short(found.forcing),
        generalized_force=short(found.generalized_force),
        dissipative_force=short(found.dissipative_force),
        momenta=short(found.momenta),
        constraint=short(found.constraint),
        constraint_jacobian=short(found.constraint_jacobian),
        velocity_constraint=short(found.velocity_constraint),
        gamma=short(found.gamma),
        state_derivatives=each(dict(found.state_derivatives)),
        outputs={name: tidy(value) for name, value in found.outputs.items()},
    )
