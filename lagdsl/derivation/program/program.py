"""The program: product of the program floor and input of every backend.

Named functions over one expression graph, each a list of output blocks whose elements are node ids. `graph.evaluate` is
its meaning; a backend is right if it computes the same numbers. No SymPy, no source text: names are in the layout only.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import prod

from lagdsl.algebra.eliminate.solve import Factor
from lagdsl.algebra.graph.graph import ZERO, Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import Kind


@record(kw_only=True)
class Slot:
    """One entry of an argument or result array: its name in results and its coherent SI unit; where it was declared."""

    name: str
    unit: str = "1"
    place: str | None = None


@record(kw_only=True)
class Instants:
    """Events, in the order of the results of `indicator`, `contact` and `event`.

    `strict` flags relations that do not hold at zero, `jumping` those with which energies or rows of constraints may
    jump, `whole_inputs` inputs that are no Reals, empty where all are.
    `contact_rows` are rows of constraints; `one_way` flags contacts of rates, empty where none is. `frictions` are
    names, `friction_rows` rows of constraints, one or two of each friction as `friction_slips` tells;
    `friction_contacts` are the contacts under which they act, the number of contacts where there is none.
    `switched_rows` are rows of position level that discretes switch. `resets` are as results call them, `reset_places`
    their entries in (q, qd, z); `stops` and `failures` are messages.
    """

    strict: tuple[bool, ...] = ()
    jumping: tuple[bool, ...] = ()
    whole_inputs: tuple[bool, ...] = ()
    contact_rows: tuple[int, ...] = ()
    one_way: tuple[bool, ...] = ()
    frictions: tuple[str, ...] = ()
    friction_rows: tuple[int, ...] = ()
    friction_slips: tuple[int, ...] = ()
    friction_contacts: tuple[int, ...] = ()
    switched_rows: tuple[int, ...] = ()
    resets: tuple[str, ...] = ()
    reset_places: tuple[int, ...] = ()
    stops: tuple[str, ...] = ()
    failures: tuple[str, ...] = ()


@record(kw_only=True)
class Layout:
    """Names by index. `kinds` are those of the discretes.

    `parameters` are the independent ones, with their default values beside them.

    `definitions` are those of the function `definition`, where the program has it.
    `row_factors` are powers of two by which the rows of constraints are multiplied, see
    `program/passes/row_factors.py`; where it is empty, none is. A multiplier in the text is that of the program times
    this.
    `redundant` flags constraint rows found dependent on others; `position_level` flags rows that restrict q itself.
    `inertial` are the inertial parameters of the function `regressor`, `frames` and `points` those of the function
    `kinematics`, where the program has them.
    `components` (nq + nz,) are the connected components of what the equations couple, see
    `program/passes/components.py`; where it is empty, everything counts as coupled.
    `aliases` are other names of coordinates, each with the one that stands in `coordinates`.
    `speeds` flags inputs that prescribe a speed, see `program/passes/speeds.py`; where it is empty, none is known to.
    """

    coordinates: tuple[Slot, ...]
    states: tuple[Slot, ...]
    inputs: tuple[Slot, ...]
    discretes: tuple[Slot, ...]
    kinds: tuple[Kind, ...] = ()
    instants: Instants = Instants()
    parameters: tuple[Slot, ...]
    defaults: tuple[float, ...]
    outputs: tuple[Slot, ...]
    constraints: tuple[Slot, ...]
    position_level: tuple[bool, ...]
    row_factors: tuple[float, ...] = ()
    redundant: tuple[bool, ...]
    invariants: tuple[Slot, ...]
    assertions: tuple[str, ...]
    definitions: tuple[Slot, ...] = ()
    inertial: tuple[Slot, ...] = ()
    frames: tuple[str, ...] = ()
    points: tuple[str, ...] = ()
    components: tuple[int, ...] = ()
    speeds: tuple[bool, ...] = ()
    aliases: tuple[tuple[str, str], ...] = ()

    def row_factor(self, row: int) -> float:
        return self.row_factors[row] if self.row_factors else 1.0

    def size(self, group: Group) -> int:
        """Length of the argument array of `group`."""
        match group:
            case Group.TIME:
                return 1
            case Group.Q | Group.QD | Group.QDD | Group.DIRECTION_Q | Group.DIRECTION_QD | Group.DIRECTION_QDD:
                return len(self.coordinates)
            case Group.Z | Group.DIRECTION_Z:
                return len(self.states)
            case Group.U | Group.DIRECTION_U:
                return len(self.inputs)
            case Group.W:
                return len(self.discretes)
            case Group.P | Group.DIRECTION_P:
                return len(self.parameters)
            case Group.LAMBDA | Group.DIRECTION_LAMBDA:
                return len(self.constraints)
            case Group.RELEASE | Group.RELEASE_RATE:
                raise AssertionError("release symbols never reach a program")


@record(kw_only=True)
class Block:
    """One result array of a function. `nodes` are ids of its elements in row-major order of `shape`: all of them or,
    of a matrix, those that are not zero by themselves, which stand at `places`."""

    name: str
    shape: tuple[int, ...]
    nodes: tuple[int, ...]
    places: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        assert len(self.nodes) == (len(self.places) if self.is_sparse else self.size), self.name

    @property
    def is_sparse(self) -> bool:
        """True if `places` tell where the nodes stand."""
        return len(self.shape) == 2

    @property
    def size(self) -> int:
        """Number of elements."""
        return prod(self.shape)

    @property
    def elements(self) -> tuple[int, ...]:
        """All of them: of a matrix made anew, zeros included."""
        if not self.is_sparse:
            return self.nodes
        whole = [ZERO] * self.size
        for place, node in zip(self.places, self.nodes, strict=True):
            whole[place] = node
        return tuple(whole)

    @property
    def entries(self) -> Iterator[tuple[int, int]]:
        """Places, ascending, and nodes of the elements that are not zero by themselves."""
        found = zip(self.places, self.nodes, strict=True) if self.is_sparse else enumerate(self.nodes)
        return ((place, node) for place, node in found if node != ZERO)

    def with_nodes(self, nodes: Sequence[int]) -> Block:
        """Others in the place of its nodes."""
        if not self.is_sparse:
            return Block(name=self.name, shape=self.shape, nodes=tuple(nodes))
        return _sparse(self.name, self.shape, dict(zip(self.places, nodes, strict=True)))


def number_block(name: str, node: int) -> Block:
    return Block(name=name, shape=(), nodes=(node,))


def vector_block(name: str, nodes: Sequence[int]) -> Block:
    return Block(name=name, shape=(len(nodes),), nodes=tuple(nodes))


def matrix_block(name: str, rows: Sequence[Mapping[int, int] | Sequence[int]], columns: int) -> Block:
    """Of rows by column, or with all their elements."""
    found: dict[int, int] = {}
    for i, row in enumerate(rows):
        for j, node in sorted(row.items()) if isinstance(row, Mapping) else enumerate(row):
            if node != ZERO:
                found[i * columns + j] = node
    return _sparse(name, (len(rows), columns), found)


def whole_block(name: str, shape: tuple[int, ...], elements: Sequence[int]) -> Block:
    """Of all elements."""
    assert len(elements) == prod(shape), name
    if len(shape) == 2:
        return _sparse(name, shape, dict(enumerate(elements)))
    return Block(name=name, shape=shape, nodes=tuple(elements))


def _sparse(name: str, shape: tuple[int, ...], found: Mapping[int, int]) -> Block:
    """`found` by place, ascending."""
    kept = [(place, node) for place, node in found.items() if node != ZERO]
    return Block(
        name=name, shape=shape, nodes=tuple(node for _, node in kept), places=tuple(place for place, _ in kept)
    )


@record(kw_only=True)
class Function:
    """`arguments` in the order of the signature; every symbol a result depends on belongs to one of them."""

    name: str
    arguments: tuple[Group, ...]
    results: tuple[Block, ...]
    doc: str = ""


@record(kw_only=True)
class Eliminated:
    """The function `elimination`, and what solves other right-hand sides in the same way; `pivot` is that of both.

    `accelerations` and `multipliers` are those of the function, with the nodes that `factor` has too.
    """

    function: Function
    factor: Factor
    pivot: int
    accelerations: Block
    multipliers: Block


@record(kw_only=True, weak=True)
class Program:
    """One complete model as functions. `lagdsl/derivation/program/functions.py` lists the functions.

    `kept_rows` are the rows, ascending, whose multipliers the function `elimination` leaves to run time; `eliminated`
    is how it solves for all else.
    """

    name: str
    layout: Layout
    graph: Graph
    functions: tuple[Function, ...]
    kept_rows: tuple[int, ...] = ()
    eliminated: Eliminated | None = None

    def has(self, name: str) -> bool:
        return any(f.name == name for f in self.functions)

    def function(self, name: str) -> Function:
        return next(f for f in self.functions if f.name == name)
