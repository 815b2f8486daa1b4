"""The variables of an exported model: one table, of which descriptions and C sources are made."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from typing import Literal, TypeAlias

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.start import Start
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.exchange.fmi.variables import builtin_variables, continuous_states, declared
from lagdsl.exchange.fmi.variables.arrays import grouped
from lagdsl.exchange.fmi.variables.dependencies import dependencies
from lagdsl.exchange.fmi.variables.dependent_coordinates import DependentCoordinate, dependent_coordinates, leading
from lagdsl.exchange.fmi.variables.held_relations import held_relations
from lagdsl.exchange.fmi.variables.names import apart
from lagdsl.exchange.fmi.variables.parameter_use import free_places
from lagdsl.exchange.fmi.variables.ports import Ports, shown
from lagdsl.exchange.fmi.variables.scalar import Role, Scalar, Variable
from lagdsl.exchange.fmi.variables.settings import Settings, settings
from lagdsl.exchange.fmi.variables.structure import Structure, structure
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

Version: TypeAlias = Literal[2, 3]
Kind: TypeAlias = Literal["me", "cs"]
KINDS: tuple[Kind, ...] = ("me", "cs")


@record(kw_only=True)
class Table:
    """Value references are indices of `variables`; the first is time. `dependent` coordinates are no states."""

    version: Version
    kinds: tuple[Kind, ...]
    flat: FlatModel
    program: Program
    settings: Settings
    variables: tuple[Variable, ...]
    dependent: tuple[DependentCoordinate, ...]
    structure: Structure

    def of(self, role: Role) -> Iterator[tuple[int, Variable]]:
        """Variables of one role with their value references."""
        return ((index, v) for index, v in enumerate(self.variables) if v.attributes.role is role)


def table(
    compilation: Compilation,
    version: Version,
    start: Start,
    *,
    kinds: Collection[Kind] = KINDS,
    engine: Engine | None = None,
    redundant: Sequence[bool] | None = None,
    parameters: Sequence[float] | None = None,
    ports: Ports | None = None,
    sink: Sink | None = None,
) -> Table:
    """Of a program with all its named values. `start` is the consistent state for the default parameters, `redundant`
    flags rows of constraints near it, `parameters` are the defaults with free ones as they were found. `ports` are
    wishes for the variables, what there is to say of them goes to `sink`."""
    flat, program = compilation.flat, compilation.program
    known = settings(compilation, start, engine, redundant, parameters)
    wishes = Ports() if ports is None else ports
    arrays = version == 3 and not wishes.scalar
    dependent = dependent_coordinates(flat, program)
    leaders = leading(dependent)
    scalars = _scalars(flat, program, known, version, kinds, leaders, clocks=wishes.clocks)
    variables = grouped(shown(scalars, wishes, Sink() if sink is None else sink, arrays=arrays), arrays=arrays)
    variables = variables if version == 2 else _without_aliases_of_unknowns(variables)
    return Table(
        version=version,
        kinds=tuple(kind for kind in KINDS if kind in kinds),
        flat=flat,
        program=program,
        settings=known,
        variables=variables,
        dependent=dependent,
        structure=structure(
            variables,
            dependencies(program, free_places(flat)),
            program.layout.kinds,
            held_relations(flat, program),
            _leading_states(leaders, len(flat.coordinates)),
        ),
    )


def _without_aliases_of_unknowns(variables: Sequence[Variable]) -> tuple[Variable, ...]:
    """Other names of outputs that are initial unknowns as variables of their own, behind the rest. In FMI 3 an alias is
    an output, too, and fmpy, with which importers validate, expects all of them among the initial unknowns, where a
    value reference stands once."""

    def is_unknown(variable: Variable) -> bool:
        return variable.attributes.causality == "output" and variable.initial in ("approx", "calculated")

    added = [
        replace(
            variable,
            name=name,
            attributes=replace(
                variable.attributes,
                role=Role.DEPENDENT if variable.attributes.role is Role.STATE else variable.attributes.role,
                causality="local",
                setting="NEVER",
                doc=doc,
            ),
            initial="calculated",
            starts=(),
            reinit=False,
            derivative_of=None,
            others=(),
        )
        for variable in variables
        if is_unknown(variable)
        for name, doc in variable.others
    ]
    return (*(replace(v, others=()) if is_unknown(v) else v for v in variables), *added)


def _leading_states(leaders: Mapping[int, Sequence[int]], n: int) -> dict[int, list[int]]:
    """By dependent entry of (q, qd), the states that it follows from."""
    return {place + first: [leader + first for leader in own] for first in (0, n) for place, own in leaders.items()}


def _scalars(
    flat: FlatModel,
    program: Program,
    known: Settings,
    version: Version,
    kinds: Collection[Kind],
    dependent: Collection[int],
    *,
    clocks: bool,
) -> Sequence[Scalar]:
    own = list(
        chain(
            [builtin_variables.time()],
            declared.parameters(flat, program, known),
            declared.constants(flat),
            continuous_states.states(flat, program, known, dependent),
            continuous_states.derivatives(flat, known, dependent),
            declared.inputs(flat, known),
            declared.outputs(flat),
            declared.definitions(flat, program),
            declared.discretes(flat),
        )
    )
    taken = [name.text for scalar in own for name in (scalar.name, *(other.name for other in scalar.others))]
    added = list(
        chain(
            declared.contacts(flat),
            declared.frictions(flat),
            builtin_variables.multipliers(flat),
            builtin_variables.indicators(flat, program, taken) if version == 3 else (),
            builtin_variables.balance(flat, taken),
            builtin_variables.clocks(flat, program, known, taken) if version == 3 and clocks else (),
            builtin_variables.options(taken) if "cs" in kinds else (),
        )
    )
    names = apart([scalar.name for scalar in added], taken)
    return [*own, *(replace(scalar, name=name) for scalar, name in zip(added, names, strict=True))]
