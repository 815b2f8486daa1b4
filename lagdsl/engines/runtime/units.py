"""Translation units: many C files in one call of a compiler, which takes half the time of one call for each.

A unit includes files of some folders, after all headers. A name that several of these files give to something of their
own (a static function, a constant, a type, a macro) stands for another one in each: a macro puts the stem of the file
before it while the file is read. Where such a macro meets a member of a structure of a header, the compiler says so:
then the name in the file must change.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from lagdsl.foundation.resources import c_folder, fmi_folder

# Files by patterns: what programs in C and in Python call, and no FMU (sessions, calls of one value, many states at
# once, derivatives of motions); functions of every stage of a step; those of each step; starts and blows; FMUs.
SESSIONS = "units/sessions.c"
_UNITS = {
    SESSIONS: ("session/[!s]*.c", "session/session.c", "session/signals.c", "equations/batch.c", "sensitivities/*.c"),
    "units/integration.c": ("factorization/*.c", "equations/*.c", "linalg/*.c", "methods/*.c", "optimization/*.c"),
    "units/events.c": ("delays/*.c", "events/*.c", "run/*.c", "session/*.c"),
    "units/starts.c": ("contacts/*.c", "impulses/*.c", "initial/*.c"),
    "units/instance.c": ("instance/*.c", "shell/*.c"),
    "units/fmi2.c": ("fmi2/*.c",),
    "units/fmi3.c": ("fmi3/*.c",),
}
# They decide what their headers mean to them.
ALONE = tuple(
    f"lag/{file}{kind}.c"
    for file in ("methods/attempts", "sensitivities/column_sums")
    for kind in ("", "_wide", "_widest")
)

_HEAD = "/* Generated: one unit of several files (lagdsl/engines/runtime/units.py). */\n"
_SKIPPED = re.compile(r'/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'', re.DOTALL)
_DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*$", re.MULTILINE)
_MACRO = re.compile(r"^#[ \t]*define[ \t]+(\w+)", re.MULTILINE)
_INCLUDE = re.compile(r'^#[ \t]*include[ \t]*([<"][^>"]+[>"])', re.MULTILINE)
_INNERMOST = re.compile(r"\{[^{}]*\}")
_TAG = re.compile(r"\b(?:struct|union|enum)\s+(\w+)\s*\{")
_ENUMERATORS = re.compile(r"\benum\b\s*\w*\s*\{([^{}]*)\}")
_FUNCTION = re.compile(r"(\w+)\s*\(")
_DECLARATOR = re.compile(r"(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=|$)")


def unit_texts() -> dict[Path, str]:
    """The units of the runtime and of FMUs, by path."""
    found = {}
    taken = set(ALONE)
    for name, patterns in _UNITS.items():
        for folder in (c_folder(), fmi_folder()):
            files = {path.relative_to(folder).as_posix(): path for each in patterns for path in _matching(folder, each)}
            sources = {path: file.read_text(encoding="utf-8") for path, file in files.items() if path not in taken}
            if sources:
                found[folder / name] = unit(sources, _is_read_once)
                taken.update(sources)
    return found


def unit(sources: Mapping[str, str], is_read_once: Callable[[str], bool]) -> str:
    """One unit of C files, given by the paths that include them. `is_read_once` is true of the name of a header that
    may stand before all files, as it guards itself against being read twice."""
    own = {path: own_names(text) for path, text in sources.items()}
    shared = {name for name, files in Counter(n for names in own.values() for n in names).items() if files > 1}
    headers = sorted({header for text in sources.values() for header in _INCLUDE.findall(text)})
    lines = [f"#include {header}\n" for header in headers if is_read_once(header.strip('<">'))]
    for path, text in sources.items():
        renamed = sorted(own[path] & shared)
        macros = sorted(set(_MACRO.findall(text)))
        lines += [
            "\n",
            *(f"#define {name} {Path(path).stem}_{name}\n" for name in renamed if name not in macros),
            f'#include "{path}"\n',
            *(f"#undef {name}\n" for name in sorted({*renamed, *macros})),
        ]
    return "".join((_HEAD, *lines))


def own_names(text: str) -> set[str]:
    """Names that a C file gives to things of its own: static functions and variables, enumerators, types, macros."""
    macros = set(_MACRO.findall(text))
    plain = _DIRECTIVE.sub("", _SKIPPED.sub(" ", text))
    enumerators = {
        each.split("=")[0].strip() for found in _ENUMERATORS.findall(plain) for each in found.split(",") if each.strip()
    }
    tags = set(_TAG.findall(plain))
    while (emptier := _INNERMOST.sub(" ", plain)) != plain:
        plain = emptier
    return {*macros, *enumerators, *tags, *(name for each in _declarations(plain) for name in _declared(each))}


def _declarations(plain: str) -> Iterator[str]:
    """Declarations and heads of functions of a text without bodies, the latter with what follows them."""
    for part in plain.split(";"):
        yield from re.split(r"(?=^(?:static|typedef)\b)", part, flags=re.MULTILINE)


def _declared(declaration: str) -> Iterator[str]:
    words = declaration.strip()
    if words.startswith("typedef"):
        pointer = re.search(r"\(\s*\*\s*(\w+)\s*\)", words)
        last = pointer or re.search(r"(\w+)\s*(?:\([^()]*\))?$", words)
        if last:
            yield last[1]
    elif words.startswith("static"):
        head = words.partition("=")[0]
        function = _FUNCTION.search(head)
        if function:
            yield function[1]
        else:
            for part in _at_top(words):
                yield from (found[1] for found in [_DECLARATOR.search(part)] if found)


def _at_top(words: str) -> Sequence[str]:
    """Parts between the commas that stand in no parentheses."""
    plain = words
    while (emptier := re.sub(r"\([^()]*\)", " ", plain)) != plain:
        plain = emptier
    return plain.split(",")


def _is_read_once(header: str) -> bool:
    """True of headers of C and of the standard, and of ours with a guard: others hold functions."""
    found = [folder / header for folder in (c_folder(), fmi_folder()) if (folder / header).is_file()]
    return all("#ifndef" in file.read_text(encoding="utf-8") for file in found)


def _matching(folder: Path, pattern: str) -> list[Path]:
    return sorted((folder / "lag").glob(pattern))
