"""Names and texts of a model in Modelica: quoted where they have to be, and never two of them the same.

Source: Modelica 3.6, section 2.3 (identifiers, keywords) and 3.7 (built-in operators).
"""

from __future__ import annotations

import re

from lagdsl.engines.backends.reserved import MODELICA_KEYWORDS

_BUILT_IN = """
    Boolean Clock ExternalObject Integer Real StateSelect String abs acos actualStream asin assert atan atan2
    backSample base cardinality ceil change cos cosh cross delay diagonal div edge exp fill floor getInstanceName guess
    hold homotopy identity inStream inferred integer interval linspace log log10 matrix max min mod ndims noClock
    noEvent ones partition pre previous prioritize product promote reinit rem rooted sample scalar semiLinear
    shiftSample sign sin sinh size skew smooth spatialDistribution sqrt subSample subpartition sum superSample
    symmetric tan tanh terminal terminate time transpose vector zeros
"""
_TAKEN = MODELICA_KEYWORDS | frozenset(_BUILT_IN.split())
_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_]*", re.ASCII)
_OTHER = re.compile(r"[^-0-9A-Za-z_!$&()*+,./:;<>=?@\[\]{}|~ ^]")
_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}


def quoted(name: str) -> str:
    """`name` as an identifier: as it is where Modelica has no other meaning for it, else in single quotes.

    What quotes cannot hold is written as `%` and the bytes in hexadecimal, and so are `%` and `#`: identifiers differ
    where names do, and none is that of `own`.
    """
    if _PLAIN.fullmatch(name) and name not in _TAKEN:
        return name
    return f"'{_OTHER.sub(_encoded, name)}'"


def own(name: str) -> str:
    """An identifier that no name of a model has."""
    return f"'#{name}'"


def text(words: str) -> str:
    """`words` as a string of Modelica; control characters become spaces."""
    return '"' + "".join(_ESCAPES.get(each, each if each.isprintable() else " ") for each in words) + '"'


def _encoded(found: re.Match[str]) -> str:
    return "".join(f"%{byte:02x}" for byte in found[0].encode("utf-8", "surrogatepass"))
