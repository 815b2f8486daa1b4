"""Rules of FMI 2.0.5 and FMI 3.0.2 that schemas cannot tell, read from the text of a description alone.

Written from the standards, with no line of the code that writes descriptions.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree import ElementTree

# FMI 2.0.5, section 2.2.7, the two tables after "initial", and FMI 3.0.2, table 22: what may stand with what.
COMBINATIONS = {
    ("independent", "continuous", None),
    *((f"{causality}", variability, "exact") for causality in ("parameter",) for variability in ("fixed", "tunable")),
    *(
        ("calculatedParameter", variability, i)
        for variability in ("fixed", "tunable")
        for i in ("calculated", "approx")
    ),
    *(("input", variability, None) for variability in ("discrete", "continuous")),
    *(("output", v, i) for v in ("discrete", "continuous") for i in ("exact", "approx", "calculated")),
    ("output", "constant", "exact"),
    ("local", "constant", "exact"),
    *(("local", v, i) for v in ("fixed", "tunable") for i in ("calculated", "approx")),
    *(("local", v, i) for v in ("discrete", "continuous") for i in ("exact", "approx", "calculated")),
}


@dataclass
class Entry:
    """A variable, read from either version; `key` is what the model structure calls it."""

    name: str
    key: str
    tag: str
    attributes: dict[str, str]
    values: dict[str, str]  # attributes of its type
    size: int
    starts: list[str]

    @property
    def is_state_derivative(self) -> bool:
        return "derivative" in self.values


def entries(root: ElementTree.Element) -> list[Entry]:
    variables = root.find("ModelVariables")
    assert variables is not None
    return [_entry2(v, i) if v.tag == "ScalarVariable" else _entry3(v) for i, v in enumerate(variables, 1)]


def _entry2(element: ElementTree.Element, index: int) -> Entry:
    (inner,) = element
    starts = [inner.attrib["start"]] if "start" in inner.attrib else []
    return Entry(element.attrib["name"], str(index), inner.tag, dict(element.attrib), dict(inner.attrib), 1, starts)


def _entry3(element: ElementTree.Element) -> Entry:
    size = math.prod(int(dimension.attrib["start"]) for dimension in element.findall("Dimension"))
    starts = [start.attrib["value"] for start in element.findall("Start")] or element.attrib.get("start", "").split()
    attributes = dict(element.attrib)
    return Entry(attributes["name"], attributes["valueReference"], element.tag, attributes, attributes, size, starts)


def broken(root: ElementTree.Element) -> list[str]:
    """The rules that the description breaks, in words."""
    variables = entries(root)
    return [
        *_names(root, variables),
        *(fault for variable in variables for fault in (*_attributes(variable), *_starts(variable), *_range(variable))),
        *_units(root, variables),
        *_structure(root, variables),
    ]


def _names(root: ElementTree.Element, variables: list[Entry]) -> Iterator[str]:
    types = [kind.attrib["name"] for kind in root.findall("TypeDefinitions/*")]
    for name, count in Counter([*(v.name for v in variables), *types]).items():
        if count > 1:
            yield f"{name} is there {count} times"
    for variable in variables:
        declared = variable.values.get("declaredType")
        if declared is not None and declared not in types:
            yield f"{variable.name} has the type {declared}, which is not defined"
    references = [v.attributes["valueReference"] for v in variables]
    own = len(dict.fromkeys(references))
    if references[:own] != [str(index) for index in range(own)]:
        yield "value references are not those of the table"
    for alias in variables[own:]:
        first = variables[int(alias.attributes["valueReference"])]
        if alias.tag != first.tag or alias.values.get("unit") != first.values.get("unit"):
            yield f"{alias.name} is another quantity than {first.name}, whose value reference it has"
        if alias.starts or alias.is_state_derivative or alias.attributes["causality"] != "local":
            yield f"{alias.name} is an alias and more than a name"
    if [v.name for v in variables if v.attributes["causality"] == "independent"] != ["time"]:
        yield "there is not one independent variable"


def _attributes(variable: Entry) -> Iterator[str]:
    found = (variable.attributes["causality"], variable.attributes["variability"], variable.attributes.get("initial"))
    if found not in COMBINATIONS:
        yield f"{variable.name}: {found} is not allowed"
    if variable.attributes["variability"] == "continuous" and variable.tag not in ("Real", "Float64"):
        yield f"{variable.name} is no Real and continuous"


def _starts(variable: Entry) -> Iterator[str]:
    required = variable.attributes.get("initial") in ("exact", "approx") or variable.attributes["causality"] == "input"
    if len(variable.starts) != (variable.size if required else 0):
        yield f"{variable.name} has {len(variable.starts)} start values"


def _range(variable: Entry) -> Iterator[str]:
    low, high = (float(variable.values.get(name, f"{sign}inf")) for name, sign in (("min", "-"), ("max", "+")))
    if variable.tag not in ("Boolean", "String") and not all(low <= float(s) <= high for s in variable.starts):
        yield f"{variable.name} starts outside of its range"
    if float(variable.values.get("nominal", 1.0)) <= 0.0:
        yield f"{variable.name} has a nominal value that is not positive"


def _units(root: ElementTree.Element, variables: list[Entry]) -> Iterator[str]:
    defined = {
        unit.attrib["name"]: {shown.attrib["name"] for shown in unit.findall("DisplayUnit")}
        for unit in root.findall("UnitDefinitions/Unit")
    }
    for variable in variables:
        unit, shown = variable.values.get("unit"), variable.values.get("displayUnit")
        if unit is not None and unit not in defined:
            yield f"{variable.name} has the unit {unit}, which is not defined"
        if shown is not None and (unit is None or shown not in defined[unit]):
            yield f"{variable.name} is shown in {shown}, which is not defined"


def _structure(root: ElementTree.Element, variables: list[Entry]) -> Iterator[str]:
    by_key = {variable.key: variable for variable in variables}
    parts = {"Output": "Outputs", "ContinuousStateDerivative": "Derivatives", "InitialUnknown": "InitialUnknowns"}
    listed = {}
    for part3, part2 in parts.items():
        found = root.findall(f"ModelStructure/{part2}/Unknown") or root.findall(f"ModelStructure/{part3}")
        listed[part2] = [unknown.get("index") or unknown.get("valueReference") or "" for unknown in found]
        for unknown in found:
            yield from _dependencies(part2, unknown, by_key)
    outputs = [v.key for v in variables if v.attributes["causality"] == "output"]
    derivatives = [v.key for v in variables if v.is_state_derivative]
    states = [by_key[v.values["derivative"]] for v in variables if v.is_state_derivative]
    unknown = {
        *(v.key for v in variables if v.attributes["causality"] in ("output", "calculatedParameter")),
        *derivatives,
        *(state.key for state in states),
    }
    computed = [k for k in by_key if k in unknown and by_key[k].attributes.get("initial") in ("approx", "calculated")]
    for part, expected in (("Outputs", outputs), ("Derivatives", derivatives), ("InitialUnknowns", computed)):
        if listed[part] != expected:
            yield f"{part} are {listed[part]}, not {expected}"
    for derivative, state in zip((v for v in variables if v.is_state_derivative), states, strict=True):
        if derivative.size != state.size:
            yield f"{derivative.name} has another size than {state.name}"


def _dependencies(part: str, unknown: ElementTree.Element, by_key: dict[str, Entry]) -> Iterator[str]:
    """In the initial problem inputs and what is exact are known, else inputs, states and time."""
    if "dependencies" not in unknown.attrib:
        return
    keys, kinds = unknown.attrib["dependencies"].split(), unknown.attrib["dependenciesKind"].split()
    if len(keys) != len(kinds) or len(set(keys)) != len(keys):
        yield f"{part}: dependencies {keys} of kinds {kinds}"
    states = {v.values["derivative"] for v in by_key.values() if v.is_state_derivative}
    for key, kind in zip(keys, kinds, strict=False):
        known = by_key[key]
        causality, initial = known.attributes["causality"], known.attributes.get("initial")
        if part == "InitialUnknowns":
            fine = causality in ("input", "independent") or initial == "exact"
            fine = fine and kind in ("dependent", "constant") and known.attributes["variability"] != "constant"
        else:
            fine = causality in ("input", "independent") or key in states
        if not fine:
            yield f"{part}: {known.name} is not known, or not by the kind {kind}"
