"""Input decks of CalculiX and Abaqus: nodes, elements, sets and elastic materials, with places."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field

from lagdsl.exchange.flexible.keywords import LONGEST, Block, blocks
from lagdsl.exchange.flexible.refusal import Refused
from lagdsl.foundation.diagnostics.suggest import did_you_mean, distance, listing
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span

SIZES = {"C3D4": 4, "C3D6": 6, "C3D8": 8, "C3D10": 10, "C3D15": 15, "C3D20": 20}
"""Nodes of the solid elements. A letter behind the number chooses integration, and changes no node."""
_VARIANTS = ("", "R", "I", "T", "H", "RH", "IH", "M", "MH")
TYPES = {f"{kind}{variant}": kind for kind in SIZES for variant in _VARIANTS}
MAX_NODES = 100_000
_NEIGHBOURS = frozenset(["PLASTIC"])  # keywords of their own that are one letter from one that is read
_GENERATING = frozenset(
    [
        "INCLUDE",
        "NGEN",
        "NFILL",
        "NCOPY",
        "NMAP",
        "ELGEN",
        "ELCOPY",
        "SYSTEM",
        "TRANSFORM",
        "PART",
        "INSTANCE",
        "ASSEMBLY",
        "SUBMODEL",
    ]
)
"""Keywords that make or move nodes elsewhere than in the lines of `*NODE`."""


@record(kw_only=True)
class Element:
    """A solid element: its kind, as in SIZES, the letters behind it, and its nodes in the order of both programs."""

    kind: str
    variant: str
    nodes: tuple[int, ...]

    @property
    def is_reduced(self) -> bool:
        """True if stiffness has fewer points than the full rule."""
        return self.variant.startswith("R")

    @property
    def is_incompatible(self) -> bool:
        """True if CalculiX adds INNER nodes, whose shapes vanish at all others."""
        return self.variant.startswith("I")


INNER = 3
"""Nodes that CalculiX adds to an element C3D8I."""


@record(kw_only=True)
class Deck:
    """The parts of a deck that the import reads; sets by their names in capitals. `elastic` is Young's modulus and
    Poisson's ratio of each element, by its number."""

    file: SourceFile
    nodes: dict[int, tuple[float, float, float]]
    elements: dict[int, Element]
    node_sets: dict[str, dict[int, None]]
    element_sets: dict[str, dict[int, None]]
    reference_nodes: dict[str, int]
    elastic: dict[int, tuple[float, float]]


@record(kw_only=True)
class _Draft:
    deck: Deck
    materials: dict[str, tuple[float, float]] = field(default_factory=dict)
    sections: list[tuple[str, str, Span]] = field(default_factory=list)
    material: list[str] = field(default_factory=list)


def read_deck(file: SourceFile) -> Deck:
    """The model part of a deck. Raises Refused."""
    deck = Deck(file=file, nodes={}, elements={}, node_sets={}, element_sets={}, reference_nodes={}, elastic={})
    draft = _Draft(deck=deck)
    for block in blocks(file):
        if block.keyword == "STEP":
            break
        if block.keyword in _GENERATING:
            raise Refused("E1207", block.span, keyword=block.keyword)
        reader = _READERS.get(block.keyword)
        if reader is not None:
            reader(draft, block)
        elif (meant := _meant(block.keyword)) is not None:
            raise Refused("E1222", block.span, keyword=block.keyword, meant=meant)
    if not deck.nodes:
        raise Refused("E1203", None, name=file.name, what="*NODE")
    if not deck.elements:
        raise Refused("E1203", None, name=file.name, what="*ELEMENT")
    for elements, material, span in draft.sections:
        if elements not in deck.element_sets:
            raise unknown("set of elements", elements, deck.element_sets, span)
        if material in draft.materials:
            deck.elastic.update(dict.fromkeys(deck.element_sets[elements], draft.materials[material]))
    return deck


def unknown(kind: str, name: str, known: Iterable[str], span: Span | None) -> Refused:
    """E1209 with the names that the file has."""
    help = did_you_mean(name, known)
    return Refused("E1209", span, help=help, kind=kind, name=name[:80], known=listing(name, sorted(known)))


def _meant(keyword: str) -> str | None:
    """The keyword that is one slip away; without it the deck would lack what it says."""
    likes = (each for each in sorted(_READERS) if distance(keyword, each, 1) == 1)
    return None if keyword in _NEIGHBOURS else next(likes, None)


def _nodes(draft: _Draft, block: Block) -> None:
    if "SYSTEM" in block.parameters:
        raise Refused("E1207", block.span, keyword="NODE, SYSTEM")
    members = _set_of(draft.deck.node_sets, block, "NSET")
    for line in block.lines:
        number = line.positive(0, "the number of a node")
        if number in draft.deck.nodes:
            raise Refused("E1206", line.span, what="node", name=number)
        place = [line.real(k, "a coordinate") if k < len(line.cells) else 0.0 for k in (1, 2, 3)]
        draft.deck.nodes[number] = (place[0], place[1], place[2])
        members[number] = None
        if len(draft.deck.nodes) > MAX_NODES:
            raise Refused("E1204", line.span, what="the deck", limit=MAX_NODES, unit="nodes")


def _elements(draft: _Draft, block: Block) -> None:
    written = block.parameters.get("TYPE", "").upper()
    kind = TYPES.get(written)
    if kind is None:
        raise Refused("E1208", block.span, type=written or "(none)")
    members = _set_of(draft.deck.element_sets, block, "ELSET")
    cells: list[int] = []
    for line in block.lines:
        cells += [line.positive(k, "the number of a node") for k in range(len(line.cells))]
        if len(cells) <= SIZES[kind]:
            continue
        number, nodes = cells[0], tuple(cells[1:])
        if len(nodes) != SIZES[kind]:
            raise Refused(
                "E1201", line.span, what=f"element {number}", text=f"{len(nodes)} nodes", expected=f"{SIZES[kind]}"
            )
        if number in draft.deck.elements:
            raise Refused("E1206", line.span, what="element", name=number)
        missing = [node for node in nodes if node not in draft.deck.nodes]
        if missing:
            raise Refused("E1209", line.span, kind="node", name=missing[0], known="those of *NODE before this line")
        draft.deck.elements[number] = Element(kind=kind, variant=written.removeprefix(kind), nodes=nodes)
        members[number] = None
        cells = []
    if cells:
        raise Refused("E1202", block.span, what=f"the nodes of element {cells[0]}")


def _node_set(draft: _Draft, block: Block) -> None:
    _set(draft.deck.node_sets, block, "NSET", "set of nodes")


def _element_set(draft: _Draft, block: Block) -> None:
    _set(draft.deck.element_sets, block, "ELSET", "set of elements")


def _set(sets: dict[str, dict[int, None]], block: Block, parameter: str, kind: str) -> None:
    members = _set_of(sets, block, parameter)
    for line in block.lines:
        if "GENERATE" in block.parameters:
            first, last = (line.positive(k, "a number") for k in (0, 1))
            step = line.positive(2, "a step") if len(line.cells) > 2 else 1
            if (last - first) // step > MAX_NODES * 10:
                raise Refused("E1204", line.span, what="the set", limit=MAX_NODES * 10, unit="members")
            members.update(dict.fromkeys(range(first, last + 1, step)))
            continue
        for k, cell in enumerate(line.cells):
            if cell.isdigit():
                members[line.positive(k, "a number")] = None
            elif cell.upper() in sets:
                members.update(sets[cell.upper()])
            else:
                raise unknown(kind, cell, sets, line.span)


def _set_of(sets: dict[str, dict[int, None]], block: Block, parameter: str) -> dict[int, None]:
    """The set that a keyword line names, which later lines may extend; a new one where it names none."""
    name = block.parameters.get(parameter, "").upper()
    return sets.setdefault(name, {}) if name else {}


def _material(draft: _Draft, block: Block) -> None:
    draft.material[:] = [block.parameters.get("NAME", "").upper()]


def _elastic(draft: _Draft, block: Block) -> None:
    """Isotropic constants that depend on no temperature; of others there is no stress to import."""
    if block.parameters.get("TYPE", "ISO").upper() not in ("ISO", "ISOTROPIC") or len(block.lines) != 1:
        return
    line = block.lines[0]
    modulus, ratio = line.real(0, "Young's modulus"), line.real(1, "Poisson's ratio")
    if modulus <= 0 or not -1 < ratio < 0.5:
        raise Refused(
            "E1201", line.span, what="*ELASTIC", text=f"{modulus:g}, {ratio:g}", expected="those of a material"
        )
    for name in draft.material:
        draft.materials[name] = (modulus, ratio)


def _section(draft: _Draft, block: Block) -> None:
    names = (block.parameters.get("ELSET", "").upper(), block.parameters.get("MATERIAL", "").upper())
    draft.sections.append((*names, block.span))


def _rigid_body(draft: _Draft, block: Block) -> None:
    """`*RIGID BODY, NSET=..., REF NODE=...`: the reference node is the place of an interface that is this set."""
    name, number = block.parameters.get("NSET", "").upper(), block.parameters.get("REF NODE", "")
    if name and number.isascii() and number.isdigit() and len(number) <= LONGEST:
        draft.deck.reference_nodes[name] = int(number)


_READERS: dict[str, Callable[[_Draft, Block], None]] = {
    "NODE": _nodes,
    "ELEMENT": _elements,
    "NSET": _node_set,
    "ELSET": _element_set,
    "MATERIAL": _material,
    "ELASTIC": _elastic,
    "SOLID SECTION": _section,
    "RIGID BODY": _rigid_body,
}
