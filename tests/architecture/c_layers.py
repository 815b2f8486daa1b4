"""Dependencies of the C sources: files by their includes, rooms (folders of `lag/`) by includes and calls."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

_INCLUDE = re.compile(r'^#include "lag/([^"]+)"', re.MULTILINE)
_DEFINED = re.compile(r"^\w[^;={}()#]*?\b(lag_\w+)\([^;{}]*\)\s*\{", re.MULTILINE)
_DECLARED = re.compile(r"^\w[^;={}()#]*?\b(lag_\w+)\([^;{}]*\);", re.MULTILINE)
_NAMED = re.compile(r"\blag_\w+\b")
_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)

Files = Mapping[str, str]
"""Texts without comments, by paths below the folder `lag`."""


def read(*folders: Path) -> Files:
    found = {}
    for folder in folders:
        for path in sorted([*folder.rglob("*.c"), *folder.rglob("*.h")]):
            found[path.relative_to(folder).as_posix()] = _COMMENT.sub("", path.read_text(encoding="utf-8"))
    return found


def included(files: Files) -> dict[str, set[str]]:
    """The files that each file includes."""
    return {name: {other for other in _INCLUDE.findall(text) if other in files} for name, text in files.items()}


def defined(files: Files) -> dict[str, str]:
    """The source in which a function that is not static is defined."""
    found = {}
    for name, text in files.items():
        if name.endswith(".c"):
            for match in _DEFINED.finditer(text):
                if not match[0].startswith("static"):
                    found[match[1]] = name
    return found


def rooms(files: Files) -> dict[str, str]:
    """The room of each file. A public header belongs to the source of its name, else to that of what it declares; a
    header with types alone stands below all rooms."""
    home = defined(files)
    sources = {Path(name).stem: name for name in files if name.endswith(".c")}
    found = {}
    for name, text in files.items():
        if "/" in name:
            found[name] = name.split("/")[0]
            continue
        declared = [home[f] for f in _DECLARED.findall(text) if f in home]
        source = sources.get(Path(name).stem) or (declared[0] if declared else None)
        found[name] = source.split("/")[0] if source is not None else "types"
    return found


def between_rooms(files: Files) -> dict[str, dict[str, set[str]]]:
    """For each room the rooms that it needs, each with the reasons: `a.c includes b.h`, `a.c calls lag_b`."""
    room, home, includes = rooms(files), defined(files), included(files)
    found: dict[str, dict[str, set[str]]] = {name: defaultdict(set) for name in set(room.values())}
    for name, text in files.items():
        for other in includes[name]:
            found[room[name]][room[other]].add(f"{name} includes {other}")
        if name.endswith(".c"):
            for function in set(_NAMED.findall(text)) & home.keys():
                found[room[name]][room[home[function]]].add(f"{name} calls {function}")
    return {name: {other: why for other, why in needs.items() if other != name} for name, needs in found.items()}


def cycles(graph: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """The strongly connected components with more than one member (Tarjan, SIAM J. Comput. 1 (1972) 146), sorted."""
    number: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(node: str) -> None:
        number[node] = low[node] = len(number)
        stack.append(node)
        for other in sorted(graph.get(node, ())):
            if other not in number:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], number[other])
        if low[node] == number[node]:
            position = stack.index(node)
            component = stack[position:]
            del stack[position:]
            if len(component) > 1:
                found.append(sorted(component))

    for node in sorted(graph):
        if node not in number:
            visit(node)
    return sorted(found)
