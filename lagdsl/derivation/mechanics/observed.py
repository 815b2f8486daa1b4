"""Other outputs, invariants and start values for a model whose equations are formed, ranked and solved: pages and
pictures observe more of the same motion."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.derivation.mechanics.arrange import observed, start
from lagdsl.derivation.mechanics.builtin_quantities import Provider
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.friction import load_functions
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Symbols
from lagdsl.derivation.mechanics.shared_position_sums import share_positions
from lagdsl.derivation.mechanics.turns import turn_functions
from lagdsl.derivation.program.layout import layout
from lagdsl.derivation.program.program import Block, Function, Program
from lagdsl.language.flat.model import FlatModel


def with_observed(equations: Equations, program: Program, flat: FlatModel) -> tuple[Equations, Program]:
    """`equations` and `program`, which was made from them, for `flat`: their model with other outputs and invariants,
    and with further parameters behind its own, which start values may name.

    Raises CompilationFailed where an output needs a derivative that does not exist (E0304, E0308).
    """
    symbols = Symbols(equations.graph, flat)
    symbols.rows = equations.symbols.rows
    lowering = Lowering(equations.graph, flat, symbols)
    share_positions(lowering, flat)
    lowering.provide = Provider(lowering, flat, symbols, equations.dynamics, equations.energies, equations.required)
    equations = replace(equations, flat=flat, symbols=symbols, lowering=lowering)
    results = {name: tuple(blocks) for name, blocks in (observed(equations) | start(equations)).items()}
    program = replace(
        program, functions=tuple(_with(each, results) for each in program.functions if each.name != "turn")
    )
    # how loads change outputs; the rest of what it gives has factors of rows in `program`
    gains = {each.name: each.results for each in load_functions(lowering, flat, program) if each.name == "load_gain"}
    functions = (*(_with(each, gains) for each in program.functions), *turn_functions(lowering, flat))
    names = layout(flat)
    own = replace(
        program.layout,
        parameters=names.parameters,
        defaults=names.defaults,
        outputs=names.outputs,
        invariants=names.invariants,
    )
    return equations, replace(program, functions=functions, layout=own)


def _with(function: Function, results: dict[str, tuple[Block, ...]]) -> Function:
    return replace(function, results=results[function.name]) if function.name in results else function
