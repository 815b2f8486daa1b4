"""A program with the terms of its equations, its regressor and the motion of frames and points: what controllers call
by name. Simulations need none of it, so programs get it only where it is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.derivation.mechanics.equation_terms import equation_terms
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.frame_kinematics import frame_kinematics
from lagdsl.derivation.mechanics.regression.regressor import regressor
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Block, Function, Program


def with_equation_terms(equations: Equations, program: Program) -> Program:
    """`program`, which was made from `equations`, with the function `equation_terms`. Raises CompilationFailed
    (E0856)."""
    return _with(program, "equation_terms", equation_terms(equations))


def with_regressor(equations: Equations, program: Program) -> Program:
    """`program` with the function `regressor`."""
    blocks, slots = regressor(equations)
    return _with(replace(program, layout=replace(program.layout, inertial=slots)), "regressor", blocks)


def with_kinematics(
    equations: Equations, program: Program, frames: Sequence[str] = (), points: Sequence[str] = ()
) -> Program:
    """`program` with the function `kinematics` of `frames` and `points`, which the model has."""
    layout = replace(program.layout, frames=tuple(frames), points=tuple(points))
    return _with(replace(program, layout=layout), "kinematics", frame_kinematics(equations, frames, points))


def _with(program: Program, name: str, blocks: Sequence[Block]) -> Program:
    function = Function(name=name, arguments=OPTIONAL[name], results=tuple(blocks))
    return replace(program, functions=(*program.functions, function))
