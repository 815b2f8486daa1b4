"""Family 09: FMUs."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note

ROWS: dict[str, Row] = {
    "E0902": error(
        "{what} of `{name}` is {value}, beyond the integers of FMI {version}, which go from {least} to {most}",
        label="an integer here",
        help="declare `{name}` as `Real`, or take a smaller number",
    ),
    "N0903": note(
        "this FMU takes the time derivatives of `{name}` as inputs, too: {derivatives}",
        label="declared with its derivatives here",
        help="derive all of them from one signal; otherwise the motion is inconsistent",
    ),
    "E0904": error(
        "FMUs need the package `{package}`, which is not installed",
        help="install it: `pip install {package}`",
    ),
    "E0905": error(
        "no compiler for the platform {platform} was found",
        help="`pip install ziglang` brings one for every platform",
    ),
    "E0906": error(
        "the C compiler `{compiler}` failed for the platform {platform}",
        help="leave this platform out, or check that `{compiler}` compiles C11 for it",
    ),
    "E0907": error(
        "the finished FMU does not satisfy the standard, so it was not written",
        help="report the model: this is a defect of lagdsl; the other version of the standard (`--fmi`) may work",
    ),
    "E0908": error(
        "the finished FMU does not run, so it was not written: {reason}",
        help="check that `lag run` works from the same start values",
    ),
    "N0910": note(
        "the files and constants of `{name}` are named `{stem}`: {reason}",
        help="rename the model if the files must have its name",
    ),
    "E0915": error(
        "{what} has no statement in Modelica: it would need {reason}",
        label="this one",
        help="export an FMU with `lag fmu`, which contains the runtime of lagdsl; or leave this statement out",
    ),
    "E0916": error(
        "modules for {language} do not find `{name}`: it depends on multipliers, reactions or accelerations, and these "
        "on it",
        label="this load",
        help="choose the target `numpy` or `c`, or an FMU; or write a load that is known before the equations are "
        "solved",
    ),
    "E0917": error(
        "an FMU for model exchange cannot hold `{name}`: the importer makes the steps, and keeps no past",
        label="needs the past",
        help="export for co-simulation, which contains the runtime of lagdsl: `--kind cs`",
    ),
    "E0925": error(
        "no variable that can be an output of the FMU is called `{name}`",
        help="name a coordinate, a rate, a state, a discrete variable or a definition",
    ),
    "E0926": error(
        "the FMU has no variable `{name}` that could be hidden",
        help="time, states and their derivatives stay: importers need them",
    ),
    "N0927": note(
        "the model declares no output, so {names} of the FMU",
        help="declare outputs, or choose them: `--output '{first}'`",
    ),
    "N0928": note(
        "fixed numbers of the FMU, not parameters of it: {names}",
        label="sizes, branches, limits or other structural parameters depend on it",
        help="`--set '{first}=...'` gives an FMU another number",
    ),
    "N0929": note(
        "`--hide` leaves out inputs, which keep their start values in the FMU: {names}",
        help="replace `{pattern}` by patterns that do not match inputs, or declare these inputs as parameters",
    ),
}
