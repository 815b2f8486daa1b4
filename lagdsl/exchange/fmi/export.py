"""From a compiled model to an FMU: texts, libraries, a zip file that was tried before it takes its name."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from shutil import copyfile
from tempfile import TemporaryDirectory

from lagdsl.engines.backends.reserved import report_renamed
from lagdsl.engines.runtime.building.compiler import failure
from lagdsl.engines.runtime.building.platforms import PLATFORMS, Platform, platform_of, this_machine
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.exchange.fmi.capability_checks import refuse
from lagdsl.exchange.fmi.contents import library_files, source_files, terminal_files, texts
from lagdsl.exchange.fmi.description.description import Attribution
from lagdsl.exchange.fmi.export_model import export_model
from lagdsl.exchange.fmi.extra import extra_files
from lagdsl.exchange.fmi.kept_documentation import kept_documentation
from lagdsl.exchange.fmi.model_texts import model_texts
from lagdsl.exchange.fmi.package.archive import write_archive
from lagdsl.exchange.fmi.package.binary import objects_of
from lagdsl.exchange.fmi.package.sources import require_fmpy
from lagdsl.exchange.fmi.package.trial import try_out
from lagdsl.exchange.fmi.reference import reference
from lagdsl.exchange.fmi.structural_parameters import with_structural_parameters
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.exchange.fmi.variables.variables import KINDS, Kind, Version
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.motion.pipeline import Compilation

# Parts of the work: until the texts are there, until the objects are, until the libraries are.
_WRITTEN, _COMPILED, _LINKED = 0.1, 0.7, 0.9


def export(
    compilation: Compilation,
    path: Path,
    *,
    version: Version = 2,
    kinds: Sequence[Kind] = KINDS,
    platforms: Sequence[str] = (),
    parameters: Mapping[str, float] | None = None,
    start: Mapping[str, float] | None = None,
    source: SourceFile | None = None,
    documented: bool = True,
    ports: Ports | None = None,
    attribution: Attribution | None = None,
    engine: EngineName = "auto",
    sink: Sink | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write the model as an FMU of this `version` of FMI.

    `platforms` are names of `runtime.building.platforms.PLATFORMS`; none: that of this machine. `parameters`
    and `start`, by name in SI units, become the defaults. `source` goes into the file with all that the model
    was read from; `ports` choose among the variables, `attribution` stands in the description. Without `documented`
    there is neither documentation nor a picture nor a motion to compare with, which take most of the time. `engine`
    finds the start and that motion. `progress` is called with the part of the work that is done. The file appears when
    the validator of fmpy found nothing and its own library, if it is for this machine, came through its first steps;
    the same model gives the same bytes.

    Raises CompilationFailed with E09xx, ValueError for a platform that there is not, OSError where `path` cannot be
    written.
    """
    own = Sink() if sink is None else sink
    told = progress or _nobody
    machines = _platforms(platforms)
    require_fmpy()
    compilation = with_structural_parameters(compilation, own)
    refuse(compilation.flat, version, kinds, parameters or {}, own)
    own.raise_if_errors()
    report_renamed(compilation.program.name, "c", own)
    exported = export_model(compilation, version, kinds, parameters or {}, start or {}, own, engine, ports, attribution)
    description, sources = texts(exported)
    told(_WRITTEN)
    objects = objects_of(sources, exported.stem, machines, _part(told, _WRITTEN, _COMPILED))
    libraries = objects.libraries(_part(told, _COMPILED, _LINKED))
    files = {
        "modelDescription.xml": description.encode(),
        **source_files(exported, sources),
        **library_files(libraries, exported.stem, version),
        **terminal_files(exported),
    }
    written = {} if source is None else model_texts(compilation.flat, source)
    if documented:
        known = reference(exported, objects, engine)
        header = sources["fmi2Functions.h" if version == 2 else "fmi3Functions.h"]
        files |= {**kept_documentation(exported, description, known, header), **extra_files(known, written)}
    else:
        files |= extra_files(None, written)
    with TemporaryDirectory(prefix="lagdsl-") as folder:
        made = Path(folder) / f"{exported.stem}.fmu"
        write_archive(made, files)
        try_out(made, exported.table.kinds if this_machine() in libraries else ())
        with whole_file(path) as draft:
            copyfile(made, draft)
    told(1.0)


def _platforms(names: Sequence[str]) -> list[Platform]:
    """Each once, in a fixed order. Raises ValueError; E0905 where this machine is no platform of FMUs."""
    own = this_machine()
    if not names and own not in PLATFORMS:
        raise failure("E0905", platform=own)
    chosen = [platform_of(name) for name in names or (own,)]
    return sorted({each.name: each for each in chosen}.values(), key=lambda each: PLATFORMS.index(each.name))


def _part(told: Callable[[float], None], begin: float, end: float) -> Callable[[float], None]:
    """Progress of one part of the work."""
    return lambda part: told(begin + (end - begin) * part)


def _nobody(_: float) -> None:
    """Nobody watches."""
