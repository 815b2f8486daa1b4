"""Reads the declarations of the C runtime and says them in ctypes. A tool of development.

It knows the C of these headers: members are numbers, pointers, or pointers to functions.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from itertools import groupby
from operator import itemgetter

from lagdsl.foundation.resources import c_folder

# Structures that Python makes or reads, in an order in which what is named was declared; their headers and names here.
STRUCTURES = {
    "lag_arguments": ("model", "Arguments"),
    "lag_model": ("model", "Model"),
    "lag_start": ("model", "Start"),
    "lag_range": ("equations/jacobian", "Range"),
    "lag_strided": ("batch", "Strided"),
    "lag_batch": ("batch", "Batch"),
    "lag_call": ("call", "Call"),
    "lag_note": ("run/results", "Note"),
    "lag_extremes": ("run/extremes", "Extremes"),
    "lag_results": ("run/results", "Results"),
    "lag_initial": ("initial", "Initial"),
    "lag_along": ("equations/motion", "Along"),
    "lag_sensitivity_directions": ("sensitivities/sensitivities", "SensitivityDirections"),
    "lag_sensitivity_rows": ("sensitivities/sensitivities", "SensitivityRows"),
    "lag_columns_fault": ("sensitivities/sensitivities", "SensitivityFault"),
    "lag_run_callbacks": ("run", "RunCallbacks"),
    "lag_sizes": ("model", "Sizes"),
    "lag_lasting": ("model", "Lasting"),
    "lag_run_invariants": ("run", "RunInvariants"),
    "lag_run_options": ("run", "RunOptions"),
    "lag_change": ("run", "RunChange"),
    "lag_step_counts": ("stepper", "StepCounts"),
    "lag_run_report": ("run", "RunReport"),
    "lag_fault": ("run", "RunFault"),
    "lag_ensemble_results": ("ensemble", "EnsembleResults"),
    "lag_ensemble": ("ensemble", "Ensemble"),
    "lag_signal": ("signals", "Signal"),
    "lag_signals": ("signals", "Signals"),
    "lag_hold": ("hold", "Hold"),
}
# Of these Python follows the pointers; elsewhere they are addresses.
_READ = ("lag_run_report", "lag_fault")
_ENUMERATIONS = {
    "Status": ("status", "LAG_"),
    "InitialFault": ("initial", "LAG_INITIAL_"),
    "SignalKind": ("signals", "LAG_SIGNAL_"),
}
_NUMBERS = {"double": "c_double", "size_t": "c_size_t", "int": "c_int", "unsigned": "c_uint"}
_ENUMS = ("lag_status", "lag_event_kind", "lag_initial_fault", "lag_signal_kind")
_WIDTH = 80  # of names on one line
_HEAD = '''"""The structures and enumerations of the C runtime as ctypes sees them.

Generated from its headers: `python -m lagdsl.engines.runtime.generate`.
"""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p
from enum import IntEnum
from typing import Any

_Numbers = POINTER(c_double)
_Fields = list[tuple[str, Any]]


def _all(kind: Any, names: str) -> _Fields:
    """Members of one type."""
    return [(name, kind) for name in names.split()]


def _evaluated(results: int) -> Any:
    """A function of lag_model that fills so many arrays."""
    return CFUNCTYPE(c_int, POINTER(Arguments), *[_Numbers] * results)


'''


def structures_text() -> str:
    """The module `lagdsl.engines.runtime.structures`."""
    (version,) = re.findall(r"#define LAG_MODEL_VERSION (\d+)u", _header("model"))
    what = " ".join(name.lower() for name, _ in _enumerators("event_notice", "LAG_"))
    parts = [_HEAD, f'VERSION = {version}\n\n# lag_event_kind.\n_WHAT = "{what}"\nWHAT = tuple(_WHAT.split())\n']
    for name, (header, prefix) in _ENUMERATIONS.items():
        values = "".join(f"    {each} = {value}\n" for each, value in _enumerators(header, prefix))
        parts.append(f'\n\nclass {name}(IntEnum):\n    """Of lag/{header}.h."""\n\n{values}')
    for name, (_, mirror) in STRUCTURES.items():
        fields = "".join(
            f'        *_all({kind}, "{line}"),\n'
            for kind, same in groupby(members(name), key=itemgetter(1))
            for line in textwrap.wrap(" ".join(member for member, _ in same), _WIDTH)
        )
        parts.append(f'\n\nclass {mirror}(Structure):\n    """{name}."""\n\n    _fields_ = [\n{fields}    ]\n')
    return "".join(parts)


def members(name: str) -> Iterator[tuple[str, str]]:
    """Names and types of the members of a structure, in their order."""
    text = _header(STRUCTURES[name][0])
    (body,) = re.findall(rf"typedef struct {name} \{{(.*?)\}} {name};", text)
    for declaration in (part.strip() for part in body.split(";")):
        if function := re.fullmatch(r"(\w+) \(\*(\w+)\)\((.*)\)", declaration):
            yield function[2], _function(function[1], function[3])
        elif declaration:
            base, declarators = _base(declaration)
            for declarator in declarators.split(","):
                yield declarator.split("*")[-1].strip(), _type(base, declarator.count("*"), read=name in _READ)


def _base(declaration: str) -> tuple[str, str]:
    """`double` and `*p` of `const double *p`."""
    base, rest = re.fullmatch(r"(?:const )?(?:struct )?(\w+) (.*)", declaration).groups()  # type: ignore[union-attr]
    return base, rest.replace("const ", "")


def _type(base: str, stars: int, *, read: bool = False) -> str:
    typedef = re.findall(rf"typedef (\w+) {base}\((.*?)\);", _header("equations/motion"))
    if typedef:
        return _function(*typedef[0])
    if not stars:
        return STRUCTURES[base][1] if base in STRUCTURES else "c_int" if base in _ENUMS else _NUMBERS[base]
    if base == "char" and stars == 1:
        return "c_char_p"
    if read:
        return "_Numbers" if base == "double" else f"POINTER({STRUCTURES[base][1]})"
    return "c_void_p"


def _function(result: str, parameters: str) -> str:
    """Arguments and numbers that a function is handed may be looked at; other pointers are addresses."""
    kinds = ["None" if result == "void" else _type(result, 0)]
    for parameter in parameters.split(","):
        base, declarator = _base(parameter.strip())
        looked_at = {"double": "_Numbers", "lag_arguments": "POINTER(Arguments)"}
        stars = declarator.count("*")
        kinds.append(looked_at.get(base, "c_void_p") if stars else _type(base, 0))
    if kinds[:2] == ["c_int", "POINTER(Arguments)"]:
        return f"_evaluated({len(kinds) - 2})"
    return f"CFUNCTYPE({', '.join(kinds)})"


def _enumerators(header: str, prefix: str) -> list[tuple[str, int]]:
    (body,) = re.findall(r"typedef enum \w+ \{(.*?)\}", _header(header))
    names = [entry.split("=")[0].strip().removeprefix(prefix) for entry in body.split(",")]
    return [(name, number) for number, name in enumerate(names)]


def _header(name: str) -> str:
    """Without comments, on one line."""
    text = (c_folder() / "lag" / f"{name}.h").read_text(encoding="utf-8")
    version = re.findall(r"#define LAG_MODEL_VERSION \d+u", text)
    bare = re.sub(r"/\*.*?\*/|^#.*?$", "", text, flags=re.DOTALL | re.MULTILINE)
    return " ".join([*version, *bare.split()])
