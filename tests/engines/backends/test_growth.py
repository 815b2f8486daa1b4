"""From text to C, work and results grow with the length of a chain, not with its square.

Counted, not timed: calls of functions, nodes, operations and characters are the same in every run.
"""

from __future__ import annotations

import cProfile
from functools import cache
from math import log
from pathlib import Path

import pytest
from choice import ALL, chosen
from compiled_programs import program_of

from lagdsl.algebra.eliminate.count import flops
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.source import source

pytestmark = pytest.mark.no_cover

SIZES = (40, 60, 100) if ALL else (20, 25, 35)
CHAINS = ("planar_chain", "spatial_chain")


@cache
def _programs(path: Path) -> list[Program]:
    return [program_of(path, {"N": n}) for n in SIZES]


def _assert_linear(counts: list[int]) -> None:
    """The last links add at most a tenth more than twice the amount of half as many before them."""
    first, second, third = counts
    assert third - second <= 2.2 * (second - first) + 100, counts


def test_the_work_of_the_compiler_is_linear(root: Path) -> None:
    path = root / "benchmarks" / "models" / "planar_chain.lag"
    source(program_of(path, {"N": 2}), "chain")  # what is imported and read when first used
    calls = []
    for n in SIZES:
        profile = cProfile.Profile()
        profile.enable()
        source(program_of(path, {"N": n}), "chain")
        profile.disable()
        calls.append(sum(entry.callcount for entry in profile.getstats()))
    _assert_linear(calls)


@pytest.mark.parametrize("name", chosen(CHAINS, CHAINS[:1]))
def test_every_function_is_of_linear_size(root: Path, name: str) -> None:
    programs = _programs(root / "benchmarks" / "models" / f"{name}.lag")
    _assert_linear([len(program.graph) for program in programs])
    for function in programs[0].functions:
        roots = [[x for block in p.function(function.name).results for x in block.elements] for p in programs]
        _assert_linear([len(each) for each in roots])
        _assert_linear([flops(p.graph, each) for p, each in zip(programs, roots, strict=True)])


@pytest.mark.parametrize("name", chosen(CHAINS, CHAINS[:1]))
def test_the_text_hardly_grows(root: Path, name: str) -> None:
    """Code is loops; only tables grow."""
    _, medium, long = _programs(root / "benchmarks" / "models" / f"{name}.lag")
    assert len(source(long, "chain")) <= 1.3 * len(source(medium, "chain"))


def test_work_for_a_chain_of_loops_grows_with_their_number(root: Path) -> None:
    """From 41 coordinates on constrained machines left C, and accelerations cost the cube of the number of loops."""
    path = root / "benchmarks" / "models" / "four_bars.lag"
    few, many = (program_of(path, {"N": n}) for n in (10, 25))
    assert len(few.layout.coordinates) < 40 < len(many.layout.coordinates)
    pairs = {"nodes": (len(few.graph), len(many.graph))}
    both = {function.name for function in few.functions} & {function.name for function in many.functions}
    for name in sorted(both):
        roots = [[x for block in p.function(name).results for x in block.elements] for p in (few, many)]
        pairs[name] = flops(few.graph, roots[0]), flops(many.graph, roots[1])
    assert pairs["elimination"][0] > 100
    grown = {name: log(second / first) / log(2.5) for name, (first, second) in pairs.items() if first > 100}
    assert {name: exponent for name, exponent in grown.items() if exponent > 1.25} == {}
