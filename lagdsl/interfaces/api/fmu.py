"""From a model to an FMU, by the names of the package and of the command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Literal

from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.exchange.fmi.description.description import Attribution
from lagdsl.exchange.fmi.export import export
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import Compilation

VERSIONS: dict[int, Literal[2, 3]] = {2: 2, 3: 3}
KINDS: dict[str, tuple[Literal["me", "cs"], ...]] = {"me": ("me",), "cs": ("cs",), "both": ("me", "cs")}


def export_fmu(
    compilation: Compilation,
    path: Path,
    *,
    version: int,
    kind: str,
    platforms: Sequence[str],
    parameters: Mapping[str, float],
    start: Mapping[str, float],
    source: SourceFile | None,
    ports: Ports,
    attribution: Attribution,
    engine: EngineName,
    sink: Sink | None,
    progress: Callable[[float], None] | None,
) -> None:
    """`export`, with ValueError for a version and a kind that there are not."""
    if version not in VERSIONS:
        raise ValueError(f"there is no FMI {version}; there are 2, 3")
    if kind not in KINDS:
        raise ValueError(f"there is no kind `{kind}`; there are {', '.join(KINDS)}")
    export(
        compilation,
        path,
        version=VERSIONS[version],
        kinds=KINDS[kind],
        platforms=tuple(platforms),
        parameters=parameters,
        start=start,
        source=source,
        ports=ports,
        attribution=attribution,
        engine=engine,
        sink=Sink() if sink is None else sink,
        progress=progress,
    )
