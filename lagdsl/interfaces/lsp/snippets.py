"""Statements as editors write them; `python -m lagdsl.interfaces.lsp.snippets FILE` writes those of VS Code."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from lagdsl.language.manual.words import statement_of

SNIPPETS = {
    "model": 'model ${1:Name} "${2:what it is}"\n  $0\nend ${1:Name};',
    "coordinate": "coordinate ${1:Angle} ${2:q}(start = ${3:30 deg});",
    "parameter": "parameter ${1:Mass} ${2:m} = ${3:1 kg};",
    "mass": "mass ${1:m} at ${2:P};",
    "body": "body ${1:b}(m = ${2:m}, Izz = ${3:I}) on ${4:frame};",
    "point": "point ${1:P} = {${2:x}, ${3:y}};",
    "frame": "frame ${1:B} = ${2:world}.rotz(${3:q});",
    "gravity": "gravity = -g_n*world.${1:y};",
    "force": "force ${1:F} at ${2:P};",
    "torque": "torque ${1:tau} on ${2:q};",
    "kinetic": "kinetic ${1:T} = ${2:1/2*m*der(x)^2};",
    "potential": "potential ${1:V} = ${2:1/2*k*x^2};",
    "dissipation": "dissipation ${1:D} = ${2:1/2*d*der(x)^2};",
    "constraint": "constraint ${1:c}: ${2:a} = ${3:b};",
    "contact": "contact ${1:c}: ${2:gap} >= 0 with restitution = ${3:0.5};",
    "friction": "friction ${1:f}: ${2:der(s)} with limit = ${3:1 N};",
    "invariant": "invariant ${1:E}: ${2:energy()};",
    "measure": "measure ${1:q} with sigma = ${2:0.1 deg};",
    "output": "output ${1:Force} ${2:N} = ${3:value};",
    "input": "input ${1:Torque} ${2:tau};",
    "state": "state ${1:Real} ${2:z}(start = ${3:0});",
    "connect": "connect(${1:world}, ${2:a});",
    "import": "import Lag.${1:Planar}.*;",
    "draw": "draw ${1:rod} from ${2:A} to ${3:B};",
    "for": "for ${1:i} in 1:${2:n} loop\n  $0\nend for;",
    "when": "when ${1:condition} then\n  $0\nend when;",
    "annotation": "annotation(experiment(StopTime = ${1:5}));",
    "function": "function ${1:f}(Real ${2:x}) -> Real = ${3:x};",
}


def snippets_text() -> str:
    """The snippets as VS Code reads them: JSON."""
    found = {}
    for word, body in SNIPPETS.items():
        said = statement_of(word)
        found[word] = {"prefix": word, "body": body.split("\n"), "description": word if said is None else said[1]}
    return json.dumps(found, indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(snippets_text(), encoding="utf-8")
