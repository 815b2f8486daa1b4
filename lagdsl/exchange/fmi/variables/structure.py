"""The model structure of FMI: which variables are computed, and which of those that are known they depend on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from lagdsl.exchange.fmi.variables.dependencies import Dependencies, Entry, Row
from lagdsl.exchange.fmi.variables.scalar import Role, Variable
from lagdsl.foundation.record import record
from lagdsl.motion.analysis.sparsity.influence import Kind

# Roles known between events: all others are computed from these, or constant.
_KNOWN = (Role.STATE, Role.INPUT, Role.TIME)
# A factor that depends on parameters changes where these are tuned.
_WORDS = {Kind.CONSTANT: "constant", Kind.PARAMETER: "tunable", Kind.DISCRETE: "discrete", Kind.DEPENDENT: "dependent"}


@record(kw_only=True)
class Unknown:
    """A computed variable, and those that it depends on with the words of FMI for how."""

    variable: int
    dependencies: tuple[tuple[int, str], ...]


@record(kw_only=True)
class ElementDependency:
    """Entry `element` of a variable depends on entry `other_element` of `other`; from 1, 0 are all of them."""

    element: int
    other: int
    other_element: int
    kind: str


@record(kw_only=True)
class Structure:
    """`elements` are told entry by entry, for each variable."""

    outputs: tuple[Unknown, ...]
    derivatives: tuple[Unknown, ...]
    indicators: tuple[Unknown, ...]
    initial: tuple[Unknown, ...]
    elements: tuple[tuple[ElementDependency, ...], ...]


def structure(
    variables: Sequence[Variable],
    found: Dependencies,
    kinds: Sequence[str],
    held: Sequence[bool],
    leaders: Mapping[int, Sequence[int]],
) -> Structure:
    """Derivatives in the order of the states, all others in that of the variables. `kinds` are those of the
    discretes, `held` flags relations that are no event indicators, `leaders` are the states from which dependent
    entries of x follow."""
    return _Search(variables, found, kinds, held, leaders).structure()


class _Search:
    def __init__(
        self,
        variables: Sequence[Variable],
        found: Dependencies,
        kinds: Sequence[str],
        held: Sequence[bool],
        leaders: Mapping[int, Sequence[int]],
    ) -> None:
        self._variables, self._found, self._kinds, self._held = variables, found, tuple(kinds), tuple(held)
        self._leaders = leaders
        watched = sum(role is Role.INDICATOR for role, _ in found.moving)
        self._indicators = [index for index in range(watched) if not (index < len(held) and held[index])]
        self._place: dict[Entry, tuple[int, int]] = {
            (_role_of_entries(v), entry): (index, element)
            for index, v in reversed([*enumerate(variables)])  # the first of those that have the same entries
            if v.attributes.type not in ("STRING", "CLOCK")
            for element, entry in enumerate(v.entries, 1)
        }
        # Values that initialization starts from.
        self._given = {
            index
            for index, v in enumerate(variables)
            if (v.attributes.causality in ("input", "independent") and v.attributes.type != "CLOCK")
            or (v.initial == "exact" and v.attributes.variability != "constant" and v.attributes.role != Role.OPTION)
        }

    def structure(self) -> Structure:
        of = self._of_role
        return Structure(
            outputs=tuple(self._continuous_state(index) for index in self._outputs()),
            derivatives=tuple(self._continuous_state(index) for index in self._derivatives()),
            indicators=tuple(self._continuous_state(index) for index in of(Role.INDICATOR)),
            initial=tuple(self._initial(index) for index in self._initial_unknowns()),
            elements=tuple(self._elements(variable) for variable in self._variables),
        )

    def _of_role(self, role: Role) -> Iterator[int]:
        return (index for index, v in enumerate(self._variables) if v.attributes.role is role)

    def _outputs(self) -> Iterator[int]:
        return (index for index, v in enumerate(self._variables) if v.attributes.causality == "output")

    def _derivatives(self) -> Iterator[int]:
        return (index for index, v in enumerate(self._variables) if v.derivative_of is not None)

    def _initial_unknowns(self) -> Iterator[int]:
        moving = {*self._derivatives(), *self._of_role(Role.STATE)}
        for index, variable in enumerate(self._variables):
            computed = variable.attributes.causality in ("output", "calculatedParameter") or index in moving
            if computed and variable.initial in ("approx", "calculated"):
                yield index

    # ---- between events ----------------------------------------------------------------------------------------------

    def _rows(self, variable: Variable) -> list[Row]:
        """Of its entries. A state that is an output, or a derivative, as the rate of a coordinate is, follows from
        itself."""
        role, output = variable.attributes.role, variable.attributes.causality == "output"
        if role in (Role.STATE, Role.DEPENDENT) or (role is Role.DISCRETE and output):
            own: list[Row] = [(((_role_of_entries(variable), e), Kind.CONSTANT),) for e in variable.entries]
            rows = own if output or role is Role.DEPENDENT or variable.derivative_of is not None else []
        elif role is Role.INDICATOR:
            rows = [self._indicator(self._indicators[entry]) for entry in variable.entries]
        else:
            rows = [self._found.moving.get((role, entry), ()) for entry in variable.entries]
        rows = [self._at_events(row) if output else self._when_set(row) for row in rows]
        rows = [self._of_states(row) for row in rows]
        known = self._place.keys()
        return [tuple((e, kind) for e, kind in row if e[0] in _KNOWN and e in known) for row in rows]

    def _of_states(self, row: Row) -> Row:
        """With the states from which dependent coordinates follow in place of these."""
        found: dict[Entry, Kind] = {}
        for (role, index), kind in row:
            follows = role is Role.STATE and index in self._leaders
            for entry in self._leaders[index] if follows else (index,):
                found[role, entry] = max(kind, found.get((role, entry), kind))
        return tuple(found.items())

    def _at_events(self, row: Row) -> Row:
        """With what decides upon the discretes in it: outputs are told for event mode, too."""
        found, waiting, seen = dict(row), [entry for entry, _ in row if entry[0] is Role.DISCRETE], set[Entry]()
        while waiting:
            entry = waiting.pop()
            if entry in seen:
                continue
            seen.add(entry)
            for other in self._deciding(entry):
                found[other] = Kind.DEPENDENT
                if other[0] is Role.DISCRETE:
                    waiting.append(other)
        return tuple(found.items())

    def _when_set(self, row: Row) -> Row:
        """With the inputs whose values decide upon relations in it: these are told, since it follows where they are
        set, while indicators tell of all other relations."""
        found = dict(row)
        for role, index in [entry for entry, _ in row]:
            if role is Role.DISCRETE and self._is_held(index):
                found |= dict.fromkeys(self._deciding((role, index)), Kind.DEPENDENT)
        return tuple(found.items())

    def _is_held(self, discrete: int) -> bool:
        return self._kinds[discrete] == "relation" and self._held[discrete - self._kinds.index("relation")]

    def _deciding(self, discrete: Entry) -> Iterable[Entry]:
        """Entries that a discrete follows from: those of an indicator, or of a clause, which may read everything."""
        kind = self._kinds[discrete[1]]
        relations = self._kinds.count("relation")
        if kind == "relation":
            return [entry for entry, _ in self._indicator(discrete[1] - self._kinds.index("relation"))]
        if kind in ("contact", "impacts"):
            return [entry for entry, _ in self._indicator(relations + discrete[1] - self._kinds.index(kind))]
        return [entry for entry in self._place if entry[0] in _KNOWN]

    def _indicator(self, index: int) -> Row:
        return self._found.moving[Role.INDICATOR, index]

    def _continuous_state(self, index: int) -> Unknown:
        variable = self._variables[index]
        strongest = self._strongest(self._rows(variable))
        return Unknown(
            variable=index,
            dependencies=tuple((known, self._word(variable, known, kind)) for known, kind in strongest),
        )

    def _word(self, variable: Variable, known: int, kind: Kind) -> str:
        """Only real numbers are linear in others."""
        real = variable.attributes.type == "REAL" and self._variables[known].attributes.type == "REAL"
        return _WORDS[kind] if real else "dependent"

    def _strongest(self, rows: Iterable[Row]) -> list[tuple[int, Kind]]:
        """By variable, in their order."""
        found: dict[int, Kind] = {}
        for row in rows:
            for entry, kind in row:
                known, _ = self._place[entry]
                found[known] = max(kind, found.get(known, Kind.CONSTANT))
        return sorted(found.items())

    def _elements(self, variable: Variable) -> tuple[ElementDependency, ...]:
        rows = [self._whole(row, variable) for row in self._rows(variable)]
        if len(rows) > 1 and all(row == rows[0] for row in rows):
            return tuple(_at(0, dependency) for dependency in rows[0])
        return tuple(_at(element, dependency) for element, row in enumerate(rows, 1) for dependency in row)

    def _whole(self, row: Row, variable: Variable) -> list[tuple[int, int, str]]:
        """Variables, entries and kinds; an array of which all entries count in the same way is one."""
        entries: dict[int, list[tuple[int, str]]] = {}
        for entry, kind in row:
            known, element = self._place[entry]
            entries.setdefault(known, []).append((element, self._word(variable, known, kind)))
        found: list[tuple[int, int, str]] = []
        for known, told in sorted(entries.items()):
            kinds = {kind for _, kind in told}
            if 1 < len(told) == self._variables[known].count and len(kinds) == 1:
                found.append((known, 0, told[0][1]))
            else:
                found += [(known, element, kind) for element, kind in sorted(told)]
        return found

    # ---- until initialization ends -----------------------------------------------------------------------------------

    def _initial(self, index: int) -> Unknown:
        """Discretes get their first values from all that is known, and so does what depends on them."""
        variable = self._variables[index]
        role, real = _role_of_entries(variable), variable.attributes.type == "REAL"
        rows = [self._found.initial.get((role, entry), ()) for entry in variable.entries]
        if any(entry[0] is Role.DISCRETE for row in rows for entry, _ in row):
            return Unknown(variable=index, dependencies=tuple((known, "dependent") for known in sorted(self._given)))
        rows = [tuple((entry, kind) for entry, kind in row if entry in self._place) for row in rows]
        strongest = [(known, kind) for known, kind in self._strongest(rows) if known in self._given]
        return Unknown(
            variable=index,
            dependencies=tuple((known, self._start_word(known, kind, real)) for known, kind in strongest),
        )

    def _start_word(self, known: int, kind: Kind, real: bool) -> str:
        linear = kind is Kind.CONSTANT and real and self._variables[known].attributes.type == "REAL"
        return "constant" if linear else "dependent"


def _role_of_entries(variable: Variable) -> Role:
    """Dependent coordinates and their rates are entries of x, as states are; free parameters are parameters."""
    role = variable.attributes.role
    return {Role.DEPENDENT: Role.STATE, Role.FREE: Role.PARAMETER}.get(role, role)


def _at(element: int, dependency: tuple[int, int, str]) -> ElementDependency:
    other, other_element, kind = dependency
    return ElementDependency(element=element, other=other, other_element=other_element, kind=kind)
