"""Family 11: fits of parameters to data."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, warning

ROWS: dict[str, Row] = {
    "E1101": error(
        "the data `{run}` have a column `{name}`, which the model does not have",
        None,
        "name what it means, or leave it out: `columns={{\"{name}\": None}}`, `--column '{name}='`",
    ),
    "E1102": error(
        "the data `{run}` have nothing that the model computes",
        None,
        "columns are found by name: those of the results of a run beside `time`, or, without `time`, contacts",
    ),
    "E1103": error(
        "the data `{run}` have a value at {time} s, but the run begins at {first} s{end}",
        None,
        "shift the times of the data, or set StartTime in the experiment of the model",
    ),
    "E1104": error(
        "too few data: {values} values for {unknowns} unknowns",
        None,
        "measure more, or free less",
    ),
    "E1105": error(
        "nothing is free: a fit needs at least one parameter or start value to find",
        None,
        'name it: `free=["{example}"]`, `--free {example}`, or `fixed = false` in a model with `measure`',
    ),
    "E1106": error(
        "`{name}` cannot be found within its bounds: {why}",
        None,
        "change its bounds, or the value at which the search begins",
    ),
    "E1107": error(
        "the search cannot begin: there is no motion of `{run}` with the values of the model",
        None,
        "begin at other values of the free parameters and starts, as with `--set`",
    ),
    "E1108": error(
        "the search cannot begin: `{run}` has {measured} times of `{name}`, the motion with the values of the model "
        "{found}",
        None,
        "begin at values with which it happens as often, or let the run end later with `stop`",
    ),
    "E1109": error(
        "the data have no column `{name}`, of which a standard deviation is given",
        None,
        "the data have {known}",
    ),
    "W1110": warning(
        "the search ended after {trials} trials, before the sum of squares was least",
        None,
        "begin nearer to the data, give bounds, or try many starts",
    ),
    "W1111": warning(
        "`{name}` stands at its {which} bound {bound}: the data would take it further",
        None,
        "the others are the best ones for this bound; widen it, or look for what the model lacks",
    ),
    "W1112": warning(
        "the order of events of `{run}` changes {where}",
        None,
        "between orders of events the sum of squares has corners and may have other minima: begin nearer, or try many "
        "starts",
    ),
    "W1113": warning(
        "{text}",
        None,
        "keep all but as many of them as there are combinations, or measure something else",
    ),
    "W1114": warning(
        "the residuals of `{name}` in `{run}` are not white (chance {chance}): the model leaves something out",
        None,
        "the intervals are too short then; look at the residuals over time",
    ),
    "W1115": warning(
        "{count} of {trials} trials of the search had no motion: {reason}",
        None,
        "bounds keep the search from values that are impossible",
    ),
    "E1116": error(
        "cannot write `{name}` into the text: {reason}",
        None,
        "write its number where the value is stated, or use the values with `--set`",
    ),
    "E1117": error(
        "the motion cannot be cut into segments: {what} makes its state more than free coordinates, rates and states",
        None,
        "segments are for motions without events and constraints; leave `segments` out",
    ),
}
