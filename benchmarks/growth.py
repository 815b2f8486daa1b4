"""No swell: how program size and Python time of the hanging chain grow with the number of links."""

import math
import statistics
from dataclasses import dataclass
from pathlib import Path

from measure import cpu_seconds

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.derive import derive
from lagdsl.program.program import Program
from lagdsl.semantics.flatten import flatten
from lagdsl.semantics.library import read_source
from lagdsl.syntax.parser import parse

CHAIN = Path(__file__).parents[1] / "models" / "chain.lag"
SIZES = (10, 20, 40, 80)


@dataclass(frozen=True)
class Row:
    """One chain: nodes that the results of all functions need, and CPU time from text to program."""

    links: int
    nodes: int
    seconds: float


def compile_chain(links: int) -> Program:
    """Text to program, every stage of the compiler that a larger model pays for."""
    sink = Sink()
    source = read_source(CHAIN, sink)
    assert source is not None
    unit = parse(source, sink)
    assert unit is not None
    flat = flatten(unit, sink, structural={"N": float(links)})
    sink.raise_if_errors()
    assert flat is not None
    return derive(flat)


def measure() -> list[Row]:
    """A row for each of SIZES."""
    rows = []
    for links in SIZES:
        program = compile_chain(links)
        roots = [element for function in program.functions for block in function.results for element in block.elements]
        seconds = cpu_seconds(lambda links=links: compile_chain(links), runs=3)
        rows.append(Row(links, len(program.graph.live(roots)), seconds))
    return rows


def exponent(sizes: list[float], values: list[float]) -> float:
    """Least-squares slope of log(value) over log(size)."""
    x = [math.log(size) for size in sizes]
    y = [math.log(value) for value in values]
    return statistics.linear_regression(x, y).slope
